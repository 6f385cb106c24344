import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { putFiles, type PutProgress, type PutResult, type PutWish } from './put-files';
import { filesForDevice } from '#hex/device-files';
import { fingerprint } from './device-python';
import type { Port } from './port';
import { simulatedBoard, type BoardStart, type SimulatedBoard } from './testing/simulated-board';

const HELLO = "print('hello from the board')\n";

const wishOf = (files: Readonly<Record<string, string>>, change: Partial<PutWish> = {}): PutWish => ({
  files: Object.entries(files).map(([name, text]) => ({ name, text })),
  modules: [],
  isKnown: () => false,
  mayReplace: () => Promise.resolve(true),
  ...change,
});

interface Watched {
  readonly port?: Port;
  readonly signal?: AbortSignal;
  readonly onProgress?: (progress: PutProgress) => void;
}

const firmware = new WebAssembly.Module(readFileSync('.cache/vm/vm.wasm'));
const switchedOn = (start: Omit<BoardStart, 'firmware'>): Promise<SimulatedBoard> =>
  simulatedBoard({ ...start, firmware });

const put = (board: SimulatedBoard, wish: PutWish, watched: Watched = {}): Promise<PutResult> =>
  putFiles(watched.port ?? board.port, wish, {
    timer: board.timer,
    signal: watched.signal ?? new AbortController().signal,
    onProgress: watched.onProgress ?? (() => undefined),
  });

/** The board's list of files and the content of one, read at its own REPL. */
const filesOn = (board: SimulatedBoard): readonly string[] => {
  const answer = board.type('\x03\r\x03import os\rsorted(os.listdir())\r');
  return Array.from(/\[(.*)\]/.exec(answer)?.[1]?.matchAll(/'([^']*)'/g) ?? [], ([, name]) => name ?? '');
};
const sumOn = (board: SimulatedBoard, name: string): string =>
  board.type(`\x03sum(open('${name}', 'rb').read())\r`, 3000).match(/^\d+$/m)?.[0] ?? '';
const sumOf = (text: string): string => String(new TextEncoder().encode(text).reduce((total, byte) => total + byte, 0));

describe('a project on its way to the device', { timeout: 120_000 }, () => {
  it.each(['microbit-v2', 'calliope-mini-3'])('is on the %s afterwards, and runs', async (id) => {
    const board = await switchedOn({ board: id, files: {} });
    const helper = '# ünï\ncode = "\\x00 \'quoted\' \\\\"\r\n\tvalue = 41\n'.replace('\r\n\t', '\n');
    const result = await put(
      board,
      wishOf({ 'helper.py': helper, 'main.py': 'import helper\nprint(helper.value + 1)' }),
    );
    expect(result).toMatchObject({ kind: 'done', written: ['helper.py', 'main.py'], same: [], isStarted: true });
    expect(result.kind === 'done' && result.said).toMatch(/^42\s+MicroPython/);
    expect(filesOn(board)).toEqual(['helper.py', 'main.py']);
    expect(sumOn(board, 'helper.py')).toBe(sumOf(helper));
    expect(board.type('\x03\x04', 2000)).toContain('42');
  });

  it('takes the libraries of the robot along, and the program drives with them', async () => {
    const board = await switchedOn({ board: 'microbit-v2', robot: 'maqueen-plus-v2', files: {} });
    const program = 'from mbrobot_plusV2 import *\nforward()\ndelay(200)\nstop()\nprint("driven", getDistance() > 0)';
    const { files, modules } = filesForDevice([{ name: 'main.py', text: program }], 'maqueen-plus-v2');
    const result = await put(board, { ...wishOf({}), files, modules });
    expect(result).toMatchObject({ kind: 'done', written: ['mbrobot_plusV2.py', 'main.py'] });
    // 11 kB are a matter of seconds on the board, not of minutes.
    expect(board.waitedMs()).toBeLessThan(20_000);
    board.type('', 3000);
    expect(board.console()).toContain('driven True');
  });

  it('stops the program that runs on the board, even one without end', async () => {
    const board = await switchedOn({
      board: 'microbit-v2',
      files: { 'main.py': 'from microbit import *\nwhile True:\n    print("busy")\n    sleep(20)' },
    });
    board.type('', 500);
    const result = await put(board, wishOf({ 'main.py': HELLO }));
    expect(result).toMatchObject({ kind: 'done', written: ['main.py'] });
    expect(result.kind === 'done' && result.said).toMatch(/^hello from the board/);
  });

  it('writes only what has changed, and says what was there already', async () => {
    const board = await switchedOn({ board: 'microbit-v2', files: {} });
    await put(board, wishOf({ 'lib.py': 'x = 1', 'main.py': HELLO }));
    const again = await put(board, wishOf({ 'lib.py': 'x = 1', 'main.py': 'print(2)' }));
    expect(again).toMatchObject({ kind: 'done', same: ['lib.py'], written: ['main.py'] });
  });

  it('asks before it replaces a program that nobody here knows, and leaves it when the answer is no', async () => {
    const files = { 'main.py': 'print("of somebody else")', 'notes.txt': 'keep me' };
    const board = await switchedOn({ board: 'microbit-v2', files });
    const asked: (readonly string[])[] = [];
    const mayReplace = (names: readonly string[]): Promise<boolean> => {
      asked.push(names);
      return Promise.resolve(false);
    };
    const refused = await put(board, wishOf({ 'main.py': HELLO }, { mayReplace }));
    expect([refused, asked]).toEqual([
      { kind: 'problem', problem: { kind: 'stopped', isTouched: false } },
      [['main.py']],
    ]);
    expect(sumOn(board, 'main.py')).toBe(sumOf(files['main.py']));
    const known = fingerprint(new TextEncoder().encode(files['main.py']));
    const done = await put(board, wishOf({ 'main.py': HELLO }, { mayReplace, isKnown: (sum) => sum === known }));
    expect([done.kind, asked.length]).toEqual(['done', 1]);
    expect(filesOn(board)).toEqual(['main.py', 'notes.txt']);
  });

  it('hands out what lies on the board before it is replaced, byte for byte', async () => {
    const old = `# äöü ${'0123456789'.repeat(40)}\nprint("of somebody else")\n`;
    const board = await switchedOn({ board: 'microbit-v2', files: { 'main.py': old } });
    let kept = '';
    const result = await put(
      board,
      wishOf(
        { 'main.py': HELLO },
        {
          mayReplace: async (names, read) => {
            kept = new TextDecoder().decode(await read(names[0] ?? ''));
            return true;
          },
        },
      ),
    );
    expect([result.kind, kept]).toEqual(['done', old]);
  });

  it('says how much does not fit and what else lies on the board, and no half program stays', async () => {
    const board = await switchedOn({ board: 'microbit-v2', files: { 'old.py': `#${'x'.repeat(15_000)}` } });
    const result = await put(board, wishOf({ 'big.py': `#${'y'.repeat(11_999)}`, 'main.py': HELLO }));
    const problem = result.kind === 'problem' ? result.problem : null;
    expect(problem).toMatchObject({ kind: 'full', file: 'big.py', others: ['old.py'] });
    const over = problem?.kind === 'full' ? problem.overBytes : 0;
    // 192 chunks of 126 bytes; 15,001 + 12,000 + the program, and the names.
    expect(over).toBeGreaterThan(27_001 + HELLO.length - 192 * 126);
    expect(over).toBeLessThan(27_001 + HELLO.length - 192 * 126 + 500);
    expect(filesOn(board)).toEqual(['old.py']);
  });

  it('makes room by what it replaces before it writes', async () => {
    const old = `#${'x'.repeat(15_000)}`;
    const board = await switchedOn({ board: 'microbit-v2', files: { 'main.py': old } });
    const result = await put(board, wishOf({ 'lib.py': `#${'y'.repeat(12_000)}`, 'main.py': HELLO }));
    expect(result).toMatchObject({ kind: 'done', written: ['lib.py', 'main.py'] });
  });

  it('does not put a program on a board that misses its modules', async () => {
    const board = await switchedOn({ board: 'microbit-v2', files: {} });
    const result = await put(board, wishOf({ 'main.py': HELLO }, { modules: [['calliopemini', 'calliope_mini']] }));
    expect(result).toMatchObject({ kind: 'problem', problem: { kind: 'wrong-board', module: 'calliopemini' } });
    expect(filesOn(board)).toEqual([]);
  });

  it('shows the error of a program that stops at once', async () => {
    const board = await switchedOn({ board: 'microbit-v2', files: {} });
    const result = await put(board, wishOf({ 'main.py': 'print(1)\n1/0' }));
    expect(result.kind === 'done' && result.said).toMatch(/ZeroDivisionError/);
  });

  it('says how far it is, from nothing to all, never backwards', async () => {
    const board = await switchedOn({ board: 'microbit-v2', files: {} });
    const seen: PutProgress[] = [];
    await put(board, wishOf({ 'lib.py': '#'.repeat(2000), 'main.py': HELLO }), { onProgress: (p) => seen.push(p) });
    const parts = seen.map(({ part }) => part);
    expect([parts[0], parts.at(-1)]).toEqual([0, 1]);
    expect(parts).toEqual([...parts].sort((a, b) => a - b));
    expect([...new Set(seen.map(({ stage }) => stage))]).toEqual([
      'greeting',
      'looking',
      'writing',
      'checking',
      'starting',
    ]);
  });

  it('ends with its own words when the cable is pulled at any moment', async () => {
    let writes = 0;
    let pull = Infinity;
    const transfer = async (): Promise<PutResult> => {
      const board = await switchedOn({ board: 'microbit-v2', files: {} });
      writes = 0;
      const write = (bytes: Uint8Array): Promise<void> => {
        if (++writes === pull) board.unplug();
        return board.port.write(bytes);
      };
      return put(board, wishOf({ 'main.py': HELLO }), { port: { ...board.port, write } });
    };
    expect((await transfer()).kind).toBe('done');
    const all = writes;
    expect(all).toBeGreaterThan(20);
    for (pull = 1; pull <= all; pull += 5) {
      expect(await transfer()).toEqual({ kind: 'problem', problem: { kind: 'interrupted' } });
    }
  });

  it('stops when the pupil wants it, and the board answers at its prompt again', async () => {
    const board = await switchedOn({ board: 'microbit-v2', files: {} });
    const stop = new AbortController();
    const onProgress = ({ stage }: PutProgress): void => {
      if (stage === 'writing') stop.abort();
    };
    const wish = wishOf({ 'lib.py': '#'.repeat(5000), 'main.py': HELLO });
    const result = await put(board, wish, { signal: stop.signal, onProgress });
    expect(result).toEqual({ kind: 'problem', problem: { kind: 'stopped', isTouched: true } });
    expect(board.type('6*7\r')).toContain('42');
  });

  it('does not mind answers in single bytes, late ones, and noise from before', async () => {
    const board = await switchedOn({ board: 'microbit-v2', files: { 'main.py': 'print("\\x04\\x04>OK" * 50)' } });
    const queue: number[] = [];
    const read = async (): Promise<Uint8Array | null> => {
      if (queue.length === 0) queue.push(...((await board.port.read()) ?? []));
      await new Promise<void>((resolve) => board.timer.after(1, resolve));
      const byte = queue.shift();
      return byte === undefined ? null : Uint8Array.of(byte);
    };
    const result = await put(board, wishOf({ 'main.py': HELLO }), { port: { ...board.port, read } });
    expect(result).toMatchObject({ kind: 'done', written: ['main.py'] });
  });
});
