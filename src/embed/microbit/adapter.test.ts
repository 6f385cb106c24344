import { describe, expect, it } from 'vitest';

import { RecordingSimulator } from '../testing/recording-simulator';
import { createMicrobitAdapter } from './adapter';
import { kinds, opened, settled } from './testing/opened-adapter';

describe('ready of the micro:bit dialect', () => {
  it('is said once, with everything that the board feels in the order of the official simulator', () => {
    const { start } = opened();
    if (start.kind !== 'ready') throw new Error(start.kind);
    expect(Object.keys(start.state)).toEqual(
      'radio buttonA buttonB pinLogo pin0 pin1 pin2 accelerometerX accelerometerY accelerometerZ gesture compassX compassY compassZ compassHeading lightLevel dataLogging temperature soundLevel'.split(
        ' ',
      ),
    );
    expect(start.state['soundLevel']).toEqual({
      type: 'range',
      id: 'soundLevel',
      min: 0,
      max: 255,
      lowThreshold: 75,
      highThreshold: 150,
      value: 0,
    });
    expect(start.state['temperature']).toMatchObject({ min: -5, max: 50, unit: '°C', value: 21 });
    expect(start.state['radio']).toEqual({ type: 'radio', enabled: false, group: 0 });
    expect(start.state['gesture']).toMatchObject({ type: 'enum', value: 'none' });
    expect(JSON.stringify(start.state['gesture'])).not.toContain('2g');
  });

  it('has the fourth pad where the address asks for a Calliope mini', () => {
    const { start } = opened({ device: 'calliope-mini-3' });
    expect(start).toMatchObject({ state: { pin3: { type: 'range', value: 0 } } });
  });
});

describe('stop and reset', () => {
  it('stop ends the run with the whole state, and nothing more is printed', async () => {
    const { simulator, adapter, news, flash } = opened();
    await flash();
    news();
    adapter.receive({ kind: 'stop' });
    simulator.tell({ type: 'output', text: 'too late' });
    await settled();
    expect(simulator.phase()).toBe('stopped');
    expect(kinds(news())).toEqual(['state_change']);
    adapter.receive({ kind: 'stop' });
    await settled();
    expect(news()).toEqual([]);
  });

  it('reset starts the program that is on the board, also after a stop', async () => {
    const { simulator, adapter, flash } = opened();
    await flash('print("again")');
    adapter.receive({ kind: 'stop' });
    await settled();
    adapter.receive({ kind: 'reset' });
    await settled();
    expect(simulator.phase()).toBe('running');
    expect(simulator.project().files[0]?.text).toBe('print("again")');
  });

  it('reset before anything was brought starts an empty board, not a program of the page', async () => {
    const simulator = new RecordingSimulator({
      project: { ...new RecordingSimulator().project(), files: [{ name: 'main.py', text: 'print("example")' }] },
    });
    const adapter = createMicrobitAdapter(simulator, { post: () => undefined, nowMs: () => 0 });
    adapter.receive({ kind: 'reset' });
    await settled();
    expect(simulator.phase()).toBe('running');
    expect(simulator.project().files).toEqual([{ name: 'main.py', text: '' }]);
  });

  it('tells the whole state when the program starts again by itself, and when it panics', async () => {
    const { simulator, news, flash } = opened();
    await flash();
    news();
    simulator.tell({ type: 'program-restarted' });
    simulator.tell({
      type: 'program-ended',
      ended: { kind: 'panic', exception: null, timeUs: 1 },
      verdict: null,
    });
    expect(kinds(news())).toEqual(['state_change', 'state_change']);
  });
});

describe('what the program does', () => {
  it('is printed with the line ends of a serial line, wherever the text is cut', async () => {
    const { simulator, news, flash } = opened();
    await flash();
    news();
    for (const text of ['a\nb\r\nc', '\n', 'd\r', '\ne\n\n']) simulator.tell({ type: 'output', text });
    const printed = news().map((message) => (message.kind === 'serial_output' ? message.data : message.kind));
    expect(printed.join('')).toBe('a\r\nb\r\nc\r\nd\r\ne\r\n\r\n');
  });

  it('is sent by radio as bytes', async () => {
    const { simulator, news, flash } = opened();
    await flash();
    news();
    simulator.tell({ type: 'radio', packets: [{ timeUs: 5, group: 0, bytes: [1, 0, 1, 104, 105] }] });
    expect(news().at(-1)).toEqual({ kind: 'radio_output', data: Uint8Array.of(1, 0, 1, 104, 105) });
  });

  it('is sent by radio in the group that the host has been told before, also when no picture has come yet', async () => {
    const { simulator, news, flash } = opened();
    await flash();
    news();
    const radio = (group: number) => ({
      kind: 'state_change',
      change: { radio: { type: 'radio', enabled: true, group } },
    });
    const packet = { kind: 'radio_output', data: Uint8Array.of(9) };
    const packets = [7, 7, 8].map((group, at) => ({ timeUs: at, group, bytes: [9] }));
    simulator.tell({ type: 'radio', packets });
    expect(news()).toEqual([radio(7), packet, packet, radio(8), packet]);
    simulator.tell({
      type: 'snapshot',
      snapshot: { ...simulator.snapshot()!, radio: { on: true, group: 8, channel: 7 } },
    });
    expect(news()).toEqual([]);
  });

  it('is logged with headings only when they change, also over a reset of the board', async () => {
    const { simulator, adapter, news, flash } = opened();
    await flash();
    news();
    const row = (headings: string[], values: string[]): void =>
      simulator.tell({ type: 'log', events: [{ type: 'row', headings, values, timeUs: 0 }] });
    row(['Time (seconds)', 'x'], ['0.00', '1']);
    row(['Time (seconds)', 'x'], ['1.00', '2']);
    expect(news()).toEqual([
      { kind: 'log_output', headings: ['Time (seconds)', 'x'], data: ['0.00', '1'] },
      { kind: 'log_output', data: ['1.00', '2'] },
    ]);
    adapter.receive({ kind: 'reset' });
    await settled();
    news();
    row(['y', 'x'], ['7', '3']);
    expect(news()).toEqual([{ kind: 'log_output', headings: ['Time (seconds)', 'x', 'y'], data: ['', '3', '7'] }]);
    simulator.tell({ type: 'log', events: [{ type: 'full', timeUs: 0 }] });
    simulator.tell({ type: 'log', events: [{ type: 'clear', timeUs: 0 }] });
    expect(news()).toEqual([
      { kind: 'state_change', change: { dataLogging: { type: 'dataLogging', logFull: true } } },
      { kind: 'state_change', change: { dataLogging: { type: 'dataLogging', logFull: false } } },
      { kind: 'log_delete' },
    ]);
  });

  it('switches the radio on: the host hears of it once', async () => {
    const { simulator, news, flash } = opened();
    await flash();
    news();
    const snapshot = { ...simulator.snapshot()!, radio: { on: true, group: 7, channel: 7 } };
    simulator.tell({ type: 'snapshot', snapshot });
    simulator.tell({ type: 'snapshot', snapshot });
    expect(news()).toEqual([{ kind: 'state_change', change: { radio: { type: 'radio', enabled: true, group: 7 } } }]);
  });

  it('sets the range of the accelerometer: the host hears of it once, and values beyond 2 g are taken until it ends', async () => {
    const { simulator, adapter, news, flash } = opened();
    await flash();
    news();
    adapter.receive({ kind: 'set_value', id: 'accelerometerX', value: 7000 });
    expect(simulator.sensorWishes()).toEqual({});
    const snapshot = { ...simulator.snapshot()!, accelerometerRangeMg: 8000 };
    simulator.tell({ type: 'snapshot', snapshot });
    simulator.tell({ type: 'snapshot', snapshot });
    const axis = { type: 'range', min: -8000, max: 8000, unit: 'mg', value: 0 };
    expect(news()).toEqual([
      {
        kind: 'state_change',
        change: {
          accelerometerX: { ...axis, id: 'accelerometerX' },
          accelerometerY: { ...axis, id: 'accelerometerY' },
          accelerometerZ: { ...axis, id: 'accelerometerZ', value: -1024 },
        },
      },
    ]);
    adapter.receive({ kind: 'set_value', id: 'accelerometerX', value: 7000 });
    adapter.receive({ kind: 'set_value', id: 'accelerometerY', value: 8001 });
    expect(simulator.sensorWishes()).toEqual({ accelerometerX: 7000 });
    simulator.tell({ type: 'snapshot', snapshot: { ...snapshot, accelerometerRangeMg: 4000 } });
    expect(news()).toMatchObject([{ change: { accelerometerX: { max: 4000, value: 4000 } } }]);
    adapter.receive({ kind: 'stop' });
    await settled();
    expect(news()).toMatchObject([{ change: { accelerometerX: { min: -2000, max: 2000, value: 2000 } } }]);
  });

  it('sets what is loud and what is quiet: the host hears of it once', async () => {
    const { simulator, news, flash } = opened();
    await flash();
    news();
    const snapshot = { ...simulator.snapshot()!, soundThresholds: { quiet: 20, loud: 200 } };
    simulator.tell({ type: 'snapshot', snapshot });
    simulator.tell({ type: 'snapshot', snapshot: { ...snapshot, soundThresholds: { quiet: 20, loud: 200 } } });
    expect(news()).toMatchObject([
      { kind: 'state_change', change: { soundLevel: { lowThreshold: 20, highThreshold: 200, min: 0, max: 255 } } },
    ]);
    await flash();
    expect(news()[0]).toMatchObject({ change: { soundLevel: { lowThreshold: 75, highThreshold: 150 } } });
  });

  it('is reported as an error if it cannot start', () => {
    const { simulator, news } = opened();
    news();
    simulator.tell({ type: 'failed', message: 'The robot stands in a wall.' });
    const [said] = news();
    if (said?.kind !== 'internal_error') throw new Error(JSON.stringify(said));
    // As in the official simulator: hosts check its class, or pass it to error reporting.
    expect(said.error).toBeInstanceOf(Error);
    expect(said.error.message).toBe('The robot stands in a wall.');
  });
});

describe('what a person does on the page', () => {
  it('is told; what the host sets itself is not', () => {
    const { simulator, adapter, news } = opened();
    news();
    simulator.tell({ type: 'sensed', action: { type: 'button', button: 'b', down: true } });
    simulator.tell({ type: 'sensed', action: { type: 'touch', pad: 'pinLogo', down: true } });
    adapter.receive({ kind: 'set_value', id: 'temperature', value: 30 });
    expect(news()).toMatchObject([
      { kind: 'state_change', change: { buttonB: { value: 1 } } },
      { kind: 'state_change', change: { pinLogo: { value: 1 } } },
    ]);
  });

  it('asks for the program when Play is pressed, and runs nothing', () => {
    const { simulator, news } = opened();
    news();
    expect(simulator.pressRun()).toBe(true);
    expect(news()).toEqual([{ kind: 'request_flash' }]);
    expect(simulator.phase()).toBe('ready');
  });
});

describe('set_value', () => {
  const sensed = (simulator: RecordingSimulator) =>
    simulator.calls.flatMap((call) => (call.call === 'input' ? [call.action] : []));

  it('sets sensors, by numbers and by texts, and they outlive the program', async () => {
    const { simulator, adapter, news, flash } = opened();
    adapter.receive({ kind: 'set_value', id: 'lightLevel', value: 200 });
    adapter.receive({ kind: 'set_value', id: 'temperature', value: '-3' });
    adapter.receive({ kind: 'set_value', id: 'gesture', value: 'shake' });
    await flash();
    await flash();
    expect(simulator.sensorWishes()).toMatchObject({ lightLevel: 200, temperature: -3 });
    const state = news().findLast(({ kind }) => kind === 'state_change');
    expect(state).toMatchObject({
      change: { lightLevel: { value: 200 }, temperature: { value: -3 }, gesture: { value: 'shake' } },
    });
  });

  it.each([
    ['lightLevel', 256],
    ['temperature', 'warm'],
    ['gesture', '2g'],
    ['nonsense', 1],
    ['radio', 1],
    [5, 1],
    ['lightLevel', Number.NaN],
    ['lightLevel', null],
  ])('of %s to %s changes nothing', (id, value) => {
    const { simulator, adapter, news } = opened();
    news();
    adapter.receive({ kind: 'set_value', id, value });
    expect(sensed(simulator)).toEqual([]);
    expect(news()).toEqual([]);
  });

  it('passes on a press that is down and up in one breath, and one more that comes without an up', async () => {
    const { simulator, adapter, flash } = opened();
    await flash();
    for (const value of [1, 0, '1', '1']) adapter.receive({ kind: 'set_value', id: 'buttonA', value });
    const values = sensed(simulator).map((action) => (action.type === 'sensor' ? action.value : null));
    expect(values).toEqual([1, 0, 1, 0, 1]);
  });
});

describe('other messages', () => {
  it('set the language and the words of the board', () => {
    const { simulator, adapter } = opened();
    const translations = { 'button-a': 'Bouton A', 'touch-logo': ' ', other: 'x' };
    adapter.receive({ kind: 'config', language: 'fr-CA', translations });
    expect(simulator.settings().language).toBe('fr');
    expect(simulator.calls.at(-1)).toMatchObject({ settings: { labels: { 'button-a': 'Bouton A' } } });
    adapter.receive({ kind: 'config', language: 'ko', translations: {} });
    expect(simulator.settings().language).toBe('fr');
  });

  it('mute, type and come by radio, also before a program has switched the radio on', async () => {
    const { simulator, adapter, flash } = opened();
    await flash();
    adapter.receive({ kind: 'mute' });
    expect(simulator.settings().muted).toBe(true);
    adapter.receive({ kind: 'unmute' });
    expect(simulator.settings().muted).toBe(false);
    adapter.receive({ kind: 'serial_input', data: '\x03' });
    adapter.receive({ kind: 'radio_input', data: Uint8Array.of(1, 0, 1, 104) });
    expect(simulator.calls.slice(-2)).toEqual([
      { call: 'input', action: { type: 'serial', text: '\x03' } },
      { call: 'input', action: { type: 'radio', bytes: [1, 0, 1, 104] } },
    ]);
  });

  it('are let pass if they are unknown, whatever they are', () => {
    const { simulator, adapter, news } = opened();
    news();
    const before = simulator.calls.length;
    const trap = new Proxy({}, { get: () => { throw new Error('looked at'); } }); // prettier-ignore
    for (const message of [null, undefined, 1, 'flash', [], {}, { kind: 'toString' }, { type: 'flash' }, trap])
      adapter.receive(message);
    expect(simulator.calls.length).toBe(before);
    expect(news()).toEqual([]);
  });

  it('are heard no more once the adapter is closed', () => {
    const { simulator, adapter, news } = opened();
    news();
    adapter.close();
    adapter.receive({ kind: 'mute' });
    simulator.tell({ type: 'output', text: 'x' });
    expect(simulator.settings().muted).toBe(false);
    expect(simulator.listenerCount).toBe(0);
    expect(simulator.pressRun()).toBe(false);
    expect(news()).toEqual([]);
  });
});

describe('a project with several microcomputers', () => {
  it('is to the host as if it had the first one alone', async () => {
    const { simulator, news, flash } = opened();
    await flash();
    news();
    simulator.tell({ type: 'output', text: 'not yours', device: 'remote' });
    simulator.tell({ type: 'sensed', action: { type: 'button', button: 'a', down: true }, device: 'remote' });
    expect(news()).toEqual([]);
    simulator.tell({ type: 'output', text: 'yours' });
    expect(kinds(news())).toEqual(['serial_output']);
  });
});
