import { describe, expect, it } from 'vitest';

import { MAIN } from '#project/project';

import { PARTS, type SimulatorEvent } from '../simulator';
import { RecordingSimulator } from '../testing/recording-simulator';
import { createWebTigerPythonAdapter } from './adapter';

const traceback = 'Traceback (most recent call last):\n  File "main.py", line 1, in <module>\nNameError: x\n';
const ended = (kind: 'finished' | 'exception' | 'stopped', text: string | null = null): SimulatorEvent => ({
  type: 'program-ended',
  ended: {
    kind,
    timeUs: 5,
    exception: text === null ? null : { type: 'NameError', message: 'x', line: 1, traceback: text },
  },
  verdict: null,
});

/** A host of WebTigerPython with the page behind its adapter. */
function bench() {
  const simulator = new RecordingSimulator();
  const posts: { type: string; data: unknown }[] = [];
  let nowMs = 0;
  const adapter = createWebTigerPythonAdapter(simulator, {
    post: (message) => posts.push(message as (typeof posts)[number]),
    nowMs: () => nowMs,
  });
  const files = () => simulator.project().files;
  return {
    ...{ simulator, posts, adapter, files },
    wait: (ms: number) => (nowMs += ms),
    /** The messages since the last call. */
    said: () => posts.splice(0),
    send: (type: string, data?: unknown) => adapter.receive(data === undefined ? { type } : { type, data }),
    print: (text: string) => simulator.tell({ type: 'output', text }),
  };
}
const aMoment = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));

describe('the adapter of WebTigerPython', () => {
  it('says that it is ready, then takes files and runs them', async () => {
    const b = bench();
    expect(b.said()).toEqual([{ type: 'pythonReady', data: null }]);
    b.send('files', [{ name: MAIN, data: 'print(1)\r\n' }]);
    b.send('run_code');
    expect(b.files()).toEqual([{ name: MAIN, text: 'print(1)\n' }]);
    await aMoment();
    expect(b.simulator.phase()).toBe('running');
    expect(b.said()).toEqual([{ type: 'code', data: [{ name: MAIN, data: 'print(1)\n' }] }]);
  });

  it('takes a program in every shape that hosts send it', () => {
    const b = bench();
    b.send('files', 'x = 1');
    expect(b.files()).toEqual([{ name: MAIN, text: 'x = 1' }]);
    b.send('files', JSON.stringify([{ name: MAIN, data: 'x = 2' }]));
    expect(b.files()).toEqual([{ name: MAIN, text: 'x = 2' }]);
    b.send('files', { name: 'robot.py', data: 'x = 3' });
    expect(b.files()).toEqual([{ name: MAIN, text: 'x = 3' }]);
    b.send('files', [
      { name: 'drive.py', data: 'x = 4', open: true },
      { name: MAIN, data: 'import drive' },
    ]);
    expect(b.files().map(({ name }) => name)).toEqual([MAIN, 'drive.py']);
    b.said();
    b.send('files', [{ name: MAIN, data: '' }, { name: 'lib/a.py', data: '' }]); // prettier-ignore
    expect(b.said()).toEqual([{ type: 'error', data: 'files.1.name: "lib/a.py" cannot be the name of a file (nameCharacters).' }]); // prettier-ignore
    expect(b.files().map(({ name }) => name)).toEqual([MAIN, 'drive.py']);
  });

  it('tells what the program prints, its traceback apart, and all of it at the end; the REPL is left out', () => {
    const b = bench();
    b.said();
    b.simulator.tell({ type: 'started' });
    b.print('1\r\n');
    b.print(`2\r\n${traceback.replaceAll('\n', '\r\n')}`);
    b.simulator.tell(ended('exception', traceback.replaceAll('\n', '\r\n')));
    b.print('MicroPython v1.18\r\n>>> ');
    expect(b.said().slice(1)).toEqual([
      { type: 'output', data: '1\n' },
      { type: 'output', data: '2\n' },
      { type: 'error', data: traceback },
      { type: 'full_output', data: `1\n2\n${traceback}` },
      { type: 'program_finished', data: null },
    ]);
    b.simulator.tell({ type: 'program-restarted' });
    b.print('1\r\n');
    b.simulator.tell(ended('finished'));
    b.simulator.tell({ type: 'phase', phase: 'stopped' });
    expect(b.said()).toEqual([
      { type: 'output', data: '1\n' },
      { type: 'full_output', data: '1\n' },
      { type: 'program_finished', data: null },
    ]);
  });

  it('calls it no error when somebody presses Stop', () => {
    const b = bench();
    b.simulator.tell({ type: 'started' });
    b.said();
    const interrupt = traceback.replace('NameError: x', 'KeyboardInterrupt: ');
    b.print(interrupt);
    b.simulator.tell(ended('stopped', interrupt));
    expect(b.said()).toEqual([
      { type: 'full_output', data: interrupt },
      { type: 'program_finished', data: null },
    ]);
    b.simulator.tell({ type: 'started' });
    b.simulator.tell({ type: 'phase', phase: 'killed' });
    expect(b.said().map(({ type }) => type)).toEqual(['code', 'full_output', 'program_finished']);
  });

  it('shows a traceback that the program printed itself, when it goes on in silence', () => {
    const b = bench();
    b.simulator.tell({ type: 'started' });
    b.said();
    b.print(traceback);
    b.simulator.tell({ type: 'phase', phase: 'running' });
    const snapshot = b.simulator.snapshot()!;
    b.simulator.tell({ type: 'snapshot', snapshot });
    expect(b.said()).toEqual([]);
    b.wait(1001);
    b.simulator.tell({ type: 'snapshot', snapshot: { ...snapshot, running: 'world' } });
    expect(b.said()).toEqual([]); // the program is over, and its end on the way
    b.simulator.tell({ type: 'snapshot', snapshot });
    expect(b.said()).toEqual([{ type: 'output', data: traceback }]);
  });

  it('says once why a run did not start', async () => {
    const b = bench();
    b.said();
    b.simulator.run = () => {
      b.simulator.tell({ type: 'failed', message: 'Broken.' });
      return Promise.resolve('Broken.');
    };
    b.send('run_code');
    await aMoment();
    expect(b.said()).toEqual([{ type: 'error', data: 'Broken.' }]);
    b.simulator.run = () => {
      b.simulator.tell({ type: 'phase', phase: 'failed' });
      return Promise.resolve('The run could not start.');
    };
    b.send('run_code');
    await aMoment();
    expect(b.said()).toEqual([{ type: 'error', data: 'The run could not start.' }]);
  });

  it('says nothing of a run that was stopped before it began', async () => {
    const b = bench();
    b.said();
    b.simulator.run = () => {
      b.simulator.tell({ type: 'phase', phase: 'stopped' });
      return Promise.resolve('The run was stopped before it began.');
    };
    b.send('run_code');
    await aMoment();
    expect(b.said()).toEqual([]);
  });

  it('takes settings by the names of the address; what it does not know changes nothing', () => {
    const b = bench();
    const settings = () => b.simulator.settings();
    b.send('settings', { lang: 'fr-CH', dark_mode: true, device: 'Calliope mini 3', tutorial_size: 0, garden: [] });
    expect(settings()).toMatchObject({ language: 'fr', theme: 'dark', device: 'calliope-mini-3' });
    b.send('settings', { dark_mode: 'false', device: 'Oxocard', lang: 7 });
    expect(settings()).toMatchObject({ language: 'fr', theme: 'light', device: 'calliope-mini-3' });
    b.send('settings', { device: '-' });
    expect(settings().device).toBe('auto');
    b.send('settings', 7);
    b.send('settings');
    expect(settings()).toMatchObject({ language: 'fr', theme: 'light', device: 'auto' });
  });

  it('takes a program among the settings, as the manual of WebTigerPython shows it', () => {
    const b = bench();
    b.said();
    b.send('settings', { code: 'print("test")', lang: 'fr' });
    expect(b.files()).toEqual([{ name: MAIN, text: 'print("test")' }]);
    expect(b.simulator.settings().language).toBe('fr');
    const files = b.files();
    for (const code of [7, '', undefined, 'x'.repeat(300_000)]) b.send('settings', { code });
    expect(b.files()).toBe(files);
    expect(b.said()).toEqual([]);
  });

  it('shows the panes that a host asks for', () => {
    const b = bench();
    const parts = () => b.simulator.settings().parts;
    b.send('settings', { layout: [['Editor', 'Canvas'], 'Console'] });
    expect(parts()).toEqual(['bar', 'code', 'board', 'arena', 'console']);
    b.send('settings', { layout: '["Canvas"]', hide_topbar: true });
    expect(parts()).toEqual(['board', 'arena']);
    b.send('settings', { hide_topbar: false });
    expect(parts()).toEqual(['bar', 'board', 'arena']);
    b.send('settings', { full_screen: false });
    expect(parts()).toEqual(PARTS);
    b.send('settings', { full_screen: true });
    expect(parts()).toEqual(['board', 'arena']);
    b.send('settings', { layout: [] });
    b.send('settings', { layout: ['Garden'] });
    b.send('settings', { layout: 'Garden' });
    expect(parts()).toEqual(['board', 'arena']);
  });

  it('is deaf and silent once it is closed', () => {
    const b = bench();
    b.said();
    b.adapter.close();
    b.send('run_code');
    b.simulator.tell({ type: 'started' });
    expect(b.said()).toEqual([]);
    expect(b.simulator.calls).toEqual([]);
    expect(b.simulator.listenerCount).toBe(0);
  });

  it('says nothing of a run that was asked for and fails only after it is closed', async () => {
    const b = bench();
    b.said();
    b.simulator.run = () => Promise.resolve('The run could not start.');
    b.send('run_code');
    b.adapter.close();
    await aMoment();
    expect(b.said()).toEqual([]);
  });
});
