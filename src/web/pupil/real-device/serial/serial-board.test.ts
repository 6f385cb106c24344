import { describe, expect, it, vi } from 'vitest';

import { LentPort } from './lent-port';
import { SerialBoard } from './serial-board';

/** A line on which each of these texts comes 100 ms after the one before, and then whatever is pushed; it has been read by a transfer. */
async function readLine(...texts: readonly string[]) {
  let nowMs = 0;
  const waiting: ((bytes: Uint8Array | null) => void)[] = [];
  const come = (text: string | null) => {
    nowMs += 100;
    waiting.shift()?.(text === null ? null : new TextEncoder().encode(text));
  };
  const close = vi.fn(() => Promise.resolve());
  const port = { write: () => Promise.resolve(), read: () => new Promise<Uint8Array | null>((resolve) => waiting.push(resolve)), close }; // prettier-ignore
  const lent = new LentPort(port, () => nowMs);
  for (const text of texts) {
    const read = lent.read();
    come(text);
    await read;
  }
  void lent.read(); // the transfer still waits when it hands over
  const board = new SerialBoard('micro:bit with nRF52833', lent, () => undefined);
  const push = async (text: string | null): Promise<void> => {
    come(text);
    await Promise.resolve();
    await Promise.resolve();
  };
  return { board, push, close };
}
const said = ({ output }: SerialBoard) => output.map(({ text, timeUs }) => [text, timeUs / 1000]);

describe('a board whose serial line stays open', () => {
  it('says what its program has said since its start, and when; nothing of the transfer', async () => {
    const { board, push } = await readLine('OK\x04\x04>', '\r\nMPY: soft reboot\r\n1', '\r\n2\r\n');
    expect(said(board)).toEqual([['1', 0], ['\r\n2\r\n', 100]]); // prettier-ignore
    await push('3\r\n');
    expect(said(board).at(-1)).toEqual(['3\r\n', 200]);
    expect([board.name.value, board.start.value]).toEqual(['micro:bit', 1]);
  });

  it('begins with what comes later where no start was announced', async () => {
    const { board, push } = await readLine('OK\x04\x04>');
    await push('later');
    expect(said(board).map(([text]) => text)).toEqual(['later']);
  });

  it('is gone when its cable comes out, and its line is closed when the page lets go of it', async () => {
    const { board, push, close } = await readLine('soft reboot\r\n');
    await push(null);
    expect(board.state.value).toBe('gone');
    await board.disconnect();
    expect(close).toHaveBeenCalledOnce();
  });
});
