import { afterEach, describe, expect, it } from 'vitest';

import { parseProject } from '#project/file';

import { createParcoursAdapter } from '../parcours/adapter';
import type { SimulatorEvent } from '../simulator';
import { RecordingSimulator } from '../testing/recording-simulator';
import { createParcoursDevice, type ParcoursDeviceOptions } from './webtigerpython-device';

const opened: (() => void)[] = [];
afterEach(() => {
  for (const close of opened.splice(0)) close();
});

/** A device and the page behind it, joined by a port as in a frame. */
function bench(options: Partial<ParcoursDeviceOptions> = {}) {
  const simulator = new RecordingSimulator();
  const { port1, port2 } = new MessageChannel();
  const facts = { app: '1', page: 'p', devices: ['microbit-v2'], robots: ['maqueen-lite'], courses: [] };
  const connection = { post: (message: object) => port2.postMessage(message), nowMs: () => performance.now() };
  const adapter = createParcoursAdapter(simulator, connection, facts);
  port2.onmessage = (event) => adapter.receive(event.data);
  const heard: string[] = [];
  const device = createParcoursDevice({
    frame: port1,
    onOutput: (text) => heard.push(`output ${text}`),
    onError: (text) => heard.push(`error ${text}`),
    onState: (state) => heard.push(state),
    ...options,
  });
  opened.push(() => {
    device.disconnectDevice();
    port1.close();
    port2.close();
  });
  const calls = () => simulator.calls.map(({ call }) => call);
  return { simulator, device, heard, calls, tell: (event: SimulatorEvent) => simulator.tell(event) };
}

/** Waits until a condition holds; a test that waits in vain fails by its time limit. */
async function until(isSo: () => boolean): Promise<void> {
  while (!isSo()) await new Promise((resolve) => setTimeout(resolve, 5));
}

describe('the simulator as a device of WebTigerPython', { timeout: 30_000 }, () => {
  it('has what the simulator can do, and nothing to flash', () => {
    const { device } = bench();
    expect(Object.keys(device).sort()).toEqual([
      'cleanUp',
      'disconnectDevice',
      'exportCode',
      'registerDevice',
      'runCode',
      'stopCode',
    ]);
    expect(() => createParcoursDevice({})).toThrow(TypeError);
    expect(() => createParcoursDevice({ address: 'https://parcours.example/' })).toThrow(TypeError);
  });

  it('is set up as the host wishes when it is registered, once', async () => {
    const b = bench({ board: 'microbit-v2', robot: 'maqueen-lite', language: 'fr', parts: ['arena'] });
    b.device.registerDevice();
    b.device.registerDevice();
    await until(() => b.heard.includes('ready'));
    expect(b.heard).toEqual(['connecting', 'ready']);
    expect(b.simulator.settings()).toMatchObject({ device: 'microbit-v2', robot: 'maqueen-lite', language: 'fr', parts: ['arena'] }); // prettier-ignore
    expect(b.calls()).toEqual(['change', 'change']);
  });

  it('runs a program without being registered first, tells what it prints, and stops it', async () => {
    const b = bench();
    b.device.runCode('print(1)');
    await until(() => b.heard.includes('running'));
    expect(b.simulator.project().files).toEqual([{ name: 'main.py', text: 'print(1)' }]);
    const traceback = 'Traceback (most recent call last):\r\n  File "main.py", line 1\r\nNameError: x\r\n';
    const exception = { type: 'NameError', message: 'x', line: 1, traceback };
    b.tell({ type: 'output', text: `1\r\n${traceback}` });
    b.tell({ type: 'program-ended', ended: { kind: 'exception', timeUs: 0, exception }, verdict: null });
    b.tell({ type: 'output', text: '>>> ' });
    await until(() => b.heard.some((text) => text.startsWith('error')));
    expect(b.heard.slice(2)).toEqual(['running', 'output 1\n', 'ended', `error ${traceback.replaceAll('\r\n', '\n')}`]);
    b.device.stopCode();
    await until(() => b.calls().includes('stop'));
    await until(() => b.heard.at(-1) === 'ready');
  });

  it('stops a program that is only starting, and that is no error', async () => {
    const b = bench();
    let end = (_problem: string): void => undefined;
    b.simulator.run = () => new Promise((resolve) => (end = resolve));
    const stop = b.simulator.stop.bind(b.simulator);
    b.simulator.stop = () => {
      end('The run was stopped before it began.');
      return stop();
    };
    b.device.runCode('print(1)');
    b.device.stopCode();
    await until(() => b.calls().includes('stop'));
    b.simulator.run = () => Promise.resolve('There is no VM.');
    b.device.runCode('print(2)');
    await until(() => b.heard.some((text) => text.startsWith('error')));
    expect(b.heard.filter((text) => text.startsWith('error'))).toEqual(['error There is no VM.']);
  });

  it('shows what looks like the end but is not, after a moment', async () => {
    const b = bench();
    b.device.runCode('');
    await until(() => b.heard.includes('running'));
    b.tell({ type: 'output', text: 'Traceback' });
    await until(() => b.heard.includes('output Traceback'));
  });

  it('exports the program with its course as a project', async () => {
    const saved: string[] = [];
    const b = bench({ saveFile: (name, text) => saved.push(name, text) });
    b.device.exportCode('x = 1');
    await until(() => saved.length > 0);
    expect(saved[0]).toBe('main.parcours.json');
    expect(parseProject(saved[1]!)).toMatchObject({ project: { files: [{ name: 'main.py', text: 'x = 1' }] } });
    expect(b.calls()).not.toContain('setFiles');
  });

  it('puts everything back to the start when the host cleans up, and ends the run when it leaves', async () => {
    const b = bench();
    b.device.cleanUp();
    b.device.stopCode(); // not registered: there is nothing to do
    b.device.runCode('');
    b.device.cleanUp();
    await until(() => b.calls().includes('reset'));
    b.device.disconnectDevice();
    await until(() => b.calls().includes('stop'));
    expect(b.heard.at(-1)).toBe('absent');
    b.device.stopCode();
    expect(b.calls().filter((call) => call === 'stop')).toHaveLength(1);
  });

  it('says what cannot be done', async () => {
    const b = bench({ robot: 'cat' });
    b.device.registerDevice();
    await until(() => b.heard.includes('ready'));
    expect(b.heard.find((text) => text.startsWith('error'))).toMatch(/cat/);
  });

  it('says so when nobody answers, and tries again when it is asked to', async () => {
    const { port1, port2 } = new MessageChannel();
    const heard: string[] = [];
    const device = createParcoursDevice({
      frame: port1,
      timeoutMs: 30,
      onError: () => heard.push('error'),
      onState: (state) => heard.push(state),
    });
    device.runCode('');
    await until(() => heard.includes('missing'));
    expect(heard).toEqual(['connecting', 'missing', 'error']);
    device.registerDevice();
    await until(() => heard.length === 6);
    device.disconnectDevice();
    port1.close();
    port2.close();
    expect(heard.at(-1)).toBe('absent');
  });
});
