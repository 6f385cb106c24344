// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';

import { mountOn, named, textOf } from '../../app/testing/mount-on';
import { createPage } from '../../app/testing/page';
import { inputsOf, show, startRun } from '../../app/testing/run';
import MiniBoard from './MiniBoard.vue';

describe('the small board above the arena of a phone', () => {
  beforeEach(() => void vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] }));
  afterEach(() => void vi.useRealTimers());

  it('names the robot, where the run stands and its time', async () => {
    const page = createPage();
    const board = mountOn(page, MiniBoard, { robotName: 'Maqueen Lite' });
    expect(textOf(board.get('.state').element)).toBe('Maqueen Lite bereit · 00:00.0');
    await startRun(page);
    await show(page, { timeUs: 62_300_000 });
    expect(textOf(board.get('.state').element)).toBe('Maqueen Lite läuft · 01:02.3');
  });

  it('shows the 25 lights: dark ones alike, bright ones in red', async () => {
    const page = createPage();
    const board = mountOn(page, MiniBoard, { robotName: '' });
    const fills = () => board.findAll('rect').map((it) => it.attributes('fill'));
    expect(fills()).toHaveLength(25);
    expect(new Set(fills())).toEqual(new Set(['#3a4148']));
    await startRun(page);
    await show(page, { display: Array.from({ length: 25 }, (_, place) => (place === 3 ? 9 : 0)) });
    expect(fills()[3]).toContain('#ff5a4d');
    expect(new Set(fills()).size).toBe(2);
  });

  it('has both buttons, which press those of the board', async () => {
    const page = createPage();
    mountOn(page, MiniBoard, { robotName: '' });
    await startRun(page);
    for (const name of ['Taste A', 'Taste B']) {
      named(name).dispatchEvent(new PointerEvent('pointerdown', { pointerId: 1, button: 0 }));
      vi.advanceTimersByTime(300);
      named(name).dispatchEvent(new PointerEvent('pointerup', { pointerId: 1 }));
    }
    expect(inputsOf(page)).toEqual(
      (['a', 'b'] as const).flatMap((button) => [true, false].map((down) => ({ type: 'button', button, down }))),
    );
  });

  it('shows a button pressed that is held elsewhere', async () => {
    const page = createPage();
    mountOn(page, MiniBoard, { robotName: '' });
    await startRun(page);
    await show(page, { buttons: { a: false, b: true } });
    expect(named('Taste A').classList).not.toContain('round--down');
    expect(named('Taste B').classList).toContain('round--down');
  });
});
