import { describe, expect, it } from 'vitest';

import { bytes, kinds, opened, settled } from './testing/opened-adapter';

describe('flash', () => {
  it('runs before anyone has clicked anything, and empties the log of the host', async () => {
    const { simulator, news, flash } = opened();
    news();
    await flash('print("hallo")');
    expect(simulator.phase()).toBe('running');
    expect(simulator.project().files).toEqual([{ name: 'main.py', text: 'print("hallo")' }]);
    expect(kinds(news())).toEqual(['log_delete']);
  });

  it('ends a running program first, with its whole state', async () => {
    const { news, flash } = opened();
    await flash();
    news();
    await flash('print(2)');
    const [first, second, ...rest] = news();
    expect(first).toMatchObject({ kind: 'state_change', change: { buttonA: {}, soundLevel: {} } });
    expect(second).toEqual({ kind: 'log_delete' });
    expect(rest).toEqual([]);
  });

  it('starts the REPL without main.py', async () => {
    const { simulator, adapter } = opened();
    adapter.receive({ kind: 'flash', filesystem: { 'helper.py': bytes('x = 1') } });
    await settled();
    expect(simulator.project().files).toEqual([
      { name: 'main.py', text: '' },
      { name: 'helper.py', text: 'x = 1' },
    ]);
    expect(simulator.phase()).toBe('running');
  });

  it.each([
    ['one that is no text', { 'data.bin': Uint8Array.of(0xff, 0xfe) }, /"data\.bin" is left out: .*UTF-8/],
    ['a name that cannot be', { 'a b.py': bytes('') }, /"a b\.py" is left out/],
    ['one larger than any board', { 'big.txt': new Uint8Array(300_000) }, /"big\.txt" is left out: .*limit/],
    ['more than there is room for', Object.fromEntries(Array.from({ length: 30 }, (_, i) => [`f${i}.py`, bytes('')])), /"f19\.py".*limit/], // prettier-ignore
  ])('runs without a file that the page cannot hold (%s), and says so', async (_, others, message) => {
    const { simulator, adapter, news } = opened();
    news();
    adapter.receive({ kind: 'flash', filesystem: { ...others, 'main.py': bytes('print(1)') } });
    await settled();
    expect(simulator.phase()).toBe('running');
    expect(simulator.project().files[0]).toEqual({ name: 'main.py', text: 'print(1)' });
    expect(simulator.project().files.length).toBe(Object.keys(others).length === 1 ? 1 : 20);
    const [error, ...rest] = news().filter(({ kind }) => kind === 'internal_error');
    if (error?.kind !== 'internal_error') throw new Error('no error was told');
    expect(error.error.message).toMatch(message);
    expect(rest).toEqual([]);
  });

  it.each([
    ['a program that is no text', { 'main.py': Uint8Array.of(0xff, 0xfe) }, /main\.py.*UTF-8/],
    ['a program larger than any board', { 'main.py': new Uint8Array(300_000) }, /main\.py.*limit/],
  ])('of %s is told as an error; what runs goes on', async (_, filesystem, message) => {
    const { simulator, adapter, news, flash } = opened();
    await flash('print("stays")');
    news();
    adapter.receive({ kind: 'flash', filesystem });
    await settled();
    const [said, ...rest] = news();
    if (said?.kind !== 'internal_error') throw new Error(JSON.stringify(said));
    expect(said.error.message).toMatch(message);
    expect(rest).toEqual([]);
    expect(simulator.phase()).toBe('running');
    expect(simulator.project().files[0]?.text).toBe('print("stays")');
  });

  it('says that a full log is no longer full, before it empties the table of the host', async () => {
    const { simulator, news, flash } = opened();
    await flash();
    simulator.tell({ type: 'log', events: [{ type: 'full', timeUs: 0 }] });
    news();
    await flash();
    expect(kinds(news())).toEqual(['state_change', 'state_change', 'log_delete']);
    simulator.tell({ type: 'log', events: [{ type: 'full', timeUs: 0 }] });
    await simulator.stop();
    news();
    await flash();
    expect(news()).toEqual([
      { kind: 'state_change', change: { dataLogging: { type: 'dataLogging', logFull: false } } },
      { kind: 'log_delete' },
    ]);
  });

  it('changes nothing and says nothing for anything but bytes, as the official simulator', async () => {
    const { simulator, adapter, news } = opened();
    news();
    const before = simulator.calls.length;
    const buffers = [[], new Uint8Array(0), new Uint8Array(200_000_000)]; // its keys would be as many texts
    for (const filesystem of [null, 'print(1)', { 'main.py': 'print(1)' }, { 'main.py': [112] }, undefined, ...buffers])
      adapter.receive({ kind: 'flash', filesystem });
    await settled();
    expect(simulator.calls.length).toBe(before);
    expect(news()).toEqual([]);
  });

  it('gives a program that imports a robot its robot and the arena, and any other the board alone', async () => {
    const { simulator, flash } = opened();
    expect(simulator.settings()).toMatchObject({ robot: 'none', parts: ['board'] });
    await flash('import mbrobot_plusV2\n');
    expect(simulator.settings()).toMatchObject({ robot: 'auto', parts: ['board', 'arena'], arenaSenses: true });
    await flash('from microbit import *\n');
    expect(simulator.settings()).toMatchObject({ robot: 'none', parts: ['board'] });
  });

  it('leaves robot and parts that the address names as they are', async () => {
    const { simulator, flash } = opened({ robot: 'none', parts: ['board', 'console'] });
    await flash('import mbrobot_plusV2\n');
    expect(simulator.settings()).toMatchObject({ robot: 'none', parts: ['board', 'console'] });
  });
});
