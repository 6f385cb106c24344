// @vitest-environment happy-dom
import { beforeEach, describe, expect, it, vi } from 'vitest';
import { nextTick, shallowRef } from 'vue';

import { byId, isThere, tap } from '../../../app/testing/find';
import { mountOn, textOf } from '../../../app/testing/mount-on';
import { createPage } from '../../../app/testing/page';
import { realBoard, type BoardText, type RealBoard } from '../../../session/run/board/real-board';
import BoardOutput from './BoardOutput.vue';

beforeEach(() => {
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] });
  return () => vi.useRealTimers();
});

/** The output of a board that has said this. */
function outputOf(...texts: readonly string[]) {
  const output: BoardText[] = texts.map((text) => ({ device: 0, text, timeUs: 0 }));
  const board = {
    ...{ name: shallowRef('micro:bit V2'), start: shallowRef(1), count: shallowRef(0), output, outputGone: 0 },
    state: shallowRef<RealBoard['state']['value']>('connected'),
    ...{ send: vi.fn(), disconnect: vi.fn() },
  };
  const page = createPage();
  realBoard(page).value = board;
  mountOn(page, BoardOutput);
  const say = async (text: string): Promise<void> => {
    output.push({ device: 0, text, timeUs: 1 });
    board.count.value += 1;
    await nextTick();
    vi.advanceTimersByTime(100);
    await nextTick();
  };
  return { board, say };
}

describe('the output of a board at the cable', () => {
  it('says that there is none yet, and then what comes, without the signs of a terminal', async () => {
    const { say } = outputOf();
    await nextTick();
    expect(textOf(byId('board-output'))).toBe('Noch hat das Programm auf dem Gerät nichts ausgegeben.');
    await say('23\r\n\x1b[K24\r\n');
    expect(byId('board-output').textContent).toBe('23\n24\n');
  });

  it('stops and restarts the program as MicroPython’s prompt does, and lets the board go', async () => {
    const { board } = outputOf('x');
    await tap('board-interrupt');
    await tap('board-restart');
    await tap('board-disconnect');
    expect(board.send.mock.calls).toEqual([['\x03'], ['\x03\x03\x04']]);
    expect(board.disconnect).toHaveBeenCalledOnce();
  });

  it('stays to be read when the cable is out', async () => {
    const { board } = outputOf('last words\r\n');
    board.state.value = 'gone';
    await nextTick();
    expect(textOf(byId('board-state'))).toBe('ausgesteckt');
    expect(textOf(byId('board-output'))).toBe('last words');
    expect(isThere('board-interrupt')).toBe(false);
  });
});
