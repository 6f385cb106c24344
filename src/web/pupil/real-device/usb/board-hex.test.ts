import { describe, expect, it } from 'vitest';

import { cleanFirmware } from '#hex/clean';
import type { Firmware, HexBoard } from '#hex/firmware';
import { makeHex } from '#hex/make';
import { readHex } from '#hex/read';
import { firmwareText } from '#hex/testing/firmware';

import type { HexWriter } from '../board/hex-writer';
import { HexError } from './usb-problem';
import { firmwaresToSave, firmwareToFlash, hexOf, type Firmwares } from './board-hex';

/** These boards' firmwares are at hand. */
function having(...boards: readonly HexBoard[]): Firmwares {
  const all = boards.map((board): Firmware => {
    const cleaned = cleanFirmware(firmwareText(board));
    if ('problem' in cleaned || cleaned.firmwares[0] === undefined) throw new Error(board);
    return cleaned.firmwares[0];
  });
  return (board) => all.find((firmware) => firmware.board === board) ?? null;
}
/** Writes here and now. */
const write: HexWriter = (firmwares, files) => Promise.resolve(makeHex(firmwares, files));
const main = (text: string) => [{ name: 'main.py', text }];
/** The problem with which something ends. */
async function problemOf(act: () => unknown): Promise<unknown> {
  try {
    await act();
  } catch (error) {
    if (error instanceof HexError) return error.problem;
    throw error;
  }
  return null;
}

describe('the hex of a program for a board', () => {
  it('holds the program, and the libraries that it imports', async () => {
    const { text, boards } = await hexOf({ own: main('import mbled\n'), robot: null }, firmwaresToSave('microbit-v2', having('microbit-v2')), write); // prettier-ignore
    const read = readHex(text);
    expect(boards).toEqual(['microbit-v2']);
    expect(read.kind === 'hex' && read.files.map(({ name }) => name)).toEqual(['main.py', 'mbled.py']);
  });

  it('is for old and new boards alike where both firmwares are at hand', () => {
    const saved = (...boards: readonly HexBoard[]) => firmwaresToSave('microbit-v2', having(...boards)).map(({ board }) => board); // prettier-ignore
    expect(saved('microbit-v2', 'microbit-v1', 'calliope-mini-3')).toEqual(['microbit-v2', 'microbit-v1']);
    expect(saved('microbit-v2')).toEqual(['microbit-v2']);
  });

  it('is not made when it is too large: it tells by how much, and what is large', async () => {
    const own = [...main(`#${'x'.repeat(20_000)}`), { name: 'data.txt', text: 'y'.repeat(5000) }];
    const problem = await problemOf(() =>
      hexOf({ own, robot: null }, firmwaresToSave('microbit-v2', having('microbit-v2')), write),
    );
    expect(problem).toMatchObject({ kind: 'too-large', large: ['main.py', 'data.txt'] });
    expect((problem as { missingBytes: number }).missingBytes).toBeGreaterThan(4000);
  });

  it('is not made with a name that is too long for a board', async () => {
    const name = `${'n'.repeat(121)}.py`;
    const own = [...main(''), { name, text: 'x = 1' }];
    expect(
      await problemOf(() => hexOf({ own, robot: null }, firmwaresToSave('microbit-v2', having('microbit-v2')), write)),
    ).toEqual({ kind: 'name', name });
  });
});

describe('a hex that cannot be written', () => {
  it('is told, where the part of the page for it does not load', async () => {
    const own = main('print(1)\n');
    const absent: HexWriter = () => Promise.reject(new Error('The worker could not be loaded.'));
    const problem = await problemOf(() => hexOf({ own, robot: null }, firmwaresToSave('microbit-v2', having('microbit-v2')), absent)); // prettier-ignore
    expect(problem).toEqual({ kind: 'not-written' });
  });
});

describe('the firmware for the board at the cable', () => {
  const both = having('microbit-v1', 'microbit-v2', 'calliope-mini-3');

  it.each<readonly [HexBoard, 'V1' | 'V2', HexBoard]>([
    ['microbit-v2', 'V2', 'microbit-v2'],
    ['microbit-v2', 'V1', 'microbit-v1'],
    ['microbit-v1', 'V2', 'microbit-v2'],
    ['calliope-mini-3', 'V2', 'calliope-mini-3'],
  ])('is that of its version and family: %s chosen, %s there → %s', (chosen, version, board) => {
    expect(firmwareToFlash(chosen, version, both).board).toBe(board);
  });

  it('is missing for a board that nobody has thought of: it tells which', async () => {
    expect(await problemOf(() => firmwareToFlash('microbit-v2', 'V1', having('microbit-v2')))).toEqual({ kind: 'other-board', found: 'microbit-v1' }); // prettier-ignore
  });
});
