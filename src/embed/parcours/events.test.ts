import * as v from 'valibot';
import { describe, expect, it } from 'vitest';

import { defaultProjectSettings } from '#project/project';
import { devicesProject, fullProject } from '#project/testing/projects';
import { defaultScene } from '#scene/scene';

import { greeted, settled, type Message } from '../testing/host-at';
import { answerSchemas, eventSchemas } from './event-schemas';
import { limits } from './limits';
import type { EventName } from './protocol';

describe('a run whose VM does not come', () => {
  it.each(['stop', 'reset'])('is ended by %s at once, and answered as refused before it', async (end) => {
    const { say, heard, simulator } = greeted({ hangs: true });
    const [run, stopped] = [say('run'), say(end)];
    await settled();
    const answers = heard.filter(({ reply }) => reply === run || reply === stopped);
    expect(answers).toEqual([
      expect.objectContaining({ reply: run, ok: false, code: 'refused', message: expect.stringContaining('stopped') }),
      expect.objectContaining({ reply: stopped, ok: true }),
    ]);
    expect(simulator.phase()).toBe(end === 'stop' ? 'stopped' : 'ready');
  });

  it('is given up although a heap of commands waits for it', async () => {
    const { say, answerTo } = greeted({ hangs: true });
    const run = say('run');
    const others = Array.from({ length: limits.waitingCommands }, () => say('state'));
    const tooMuch = say('state');
    const again = say('run');
    const stop = say('stop');
    await settled();
    expect(answerTo(run)).toMatchObject({ ok: false, code: 'refused' });
    expect(answerTo(tooMuch)).toMatchObject({ ok: false, code: 'busy' });
    expect(answerTo(again)).toMatchObject({ ok: false, code: 'busy' });
    expect(others.every((id) => answerTo(id)?.['ok'] === true)).toBe(true);
    expect(answerTo(stop)).toMatchObject({ ok: true });
  });

  it('is not begun again by a run that waits before the stop, but by the one after it', async () => {
    const { say, answerTo, simulator } = greeted({ hangs: true });
    const [first, second] = [say('run'), say('run')];
    const stop = say('stop');
    const third = say('run');
    await settled();
    expect([first, second].map((id) => answerTo(id)?.['code'])).toEqual(['refused', 'refused']);
    expect([answerTo(stop)?.['ok'], answerTo(third)]).toEqual([true, undefined]);
    expect(simulator.calls.filter(({ call }) => call === 'run').length).toBe(2);
    expect(simulator.phase()).toBe('starting');
  });
});

describe('events of our own dialect', () => {
  it('tell of phases, output and the end with what became of it', () => {
    const { simulator, heard, events } = greeted({ phase: 'running' });
    simulator.tell({ type: 'started' });
    simulator.tell({ type: 'output', text: 'hello\n' });
    const exception = { type: 'ValueError', message: 'no', line: 3, traceback: 'Traceback' };
    simulator.tell({
      type: 'program-ended',
      ended: { kind: 'exception', exception, timeUs: 2_500_000 },
      verdict: null,
    });
    expect(heard.slice(1).map((message) => message['type'])).toEqual(['started', 'output', 'ended']);
    expect(events('ended')).toEqual([
      expect.objectContaining({ ended: 'exception', exception, atMs: 2500, verdict: null, robot: null }),
    ]);
  });

  it('call a run that was stopped before its program ended stopped, and one that was killed stuck', () => {
    for (const [phase, ended] of [
      ['stopped', 'stopped'],
      ['killed', 'stuck'],
    ] as const) {
      const { simulator, events } = greeted();
      simulator.tell({ type: 'started' });
      simulator.tell({ type: 'phase', phase });
      expect(events('ended')).toEqual([expect.objectContaining({ ended, exception: null })]);
      simulator.tell({ type: 'phase', phase: 'stopped' });
      expect(events('ended').length).toBe(1);
    }
  });

  it('send no snapshots at first, then as many as were asked for, and the last one before things stand still', () => {
    const { simulator, time, ask, events } = greeted({ phase: 'running' });
    const snapshot = simulator.snapshot()!;
    const frame = (ms: number): void => {
      time.ms = ms;
      simulator.tell({ type: 'snapshot', snapshot: { ...snapshot, timeUs: ms * 1000 } });
    };
    frame(0);
    expect(events('snapshot')).toEqual([]);
    expect(ask('subscribe', { snapshotHz: 10 })).toMatchObject({ ok: true });
    for (let ms = 1000; ms <= 2000; ms += 16) frame(ms);
    const told = events('snapshot').map((message) => (message['snapshot'] as { atMs: number }).atMs);
    expect(told.slice(0, 3)).toEqual([1000, 1112, 1224]); // the first frame at least 98 ms later
    expect(told.length).toBe(9);
    simulator.tell({ type: 'phase', phase: 'paused' });
    expect(events('snapshot').at(-1)?.['snapshot']).toMatchObject({ atMs: 1992 });
    expect(ask('subscribe', { snapshotHz: 61 })).toMatchObject({ code: 'wrong-message', path: 'snapshotHz' });
  });

  it('leave out output that comes too fast and say how much', () => {
    const { simulator, time, events } = greeted({ phase: 'running' });
    const most = limits.outputCharactersPerSecond;
    for (let times = 0; times < 30; times += 1) simulator.tell({ type: 'output', text: 'x'.repeat(10_000) });
    const sent = events('output').map((message) => (message['text'] as string).length);
    expect(sent.reduce((sum, length) => sum + length, 0)).toBeLessThanOrEqual(most);
    time.ms = 1000;
    simulator.tell({ type: 'output', text: 'again' });
    expect(events('output').at(-1)).toMatchObject({ text: 'again', omitted: 300_000 - 10_000 * sent.length });
  });

  it('leave out packets and rows that come too fast, in order, and say how many', () => {
    const { simulator, time, events } = greeted({ phase: 'running' });
    const packets = Array.from({ length: 5000 }, (_, at) => ({
      timeUs: at * 1000,
      group: 0,
      bytes: Array<number>(30).fill(7),
    }));
    const row = { type: 'row', headings: ['a'], values: ['x'.repeat(50)] } as const;
    const rows = Array.from({ length: 5000 }, (_, timeUs) => ({ ...row, timeUs }));
    simulator.tell({ type: 'radio', packets, dropped: 100 });
    simulator.tell({ type: 'log', events: [{ type: 'clear', timeUs: 0 }, ...rows, { type: 'full', timeUs: 9 }] });
    const sentPackets = events('radio')[0]?.['packets'] as readonly { atMs: number }[];
    const sentRows = events('log')[0]?.['events'] as readonly { type: string }[];
    expect(sentPackets.map(({ atMs }) => atMs)).toEqual(packets.slice(0, sentPackets.length).map((_, at) => at));
    expect(sentRows.map(({ type }) => type).filter((type) => type !== 'row')).toEqual(['clear', 'full']);
    for (const one of [events('radio')[0], events('log')[0]])
      expect(JSON.stringify(one).length).toBeLessThan(1.5 * limits.outputCharactersPerSecond);
    expect(events('radio')[0]).toMatchObject({ omitted: 100 });
    time.ms = 1000;
    simulator.tell({ type: 'radio', packets: packets.slice(0, 1) });
    expect(events('radio').at(-1)).toMatchObject({ omitted: 5000 - sentPackets.length });
    simulator.tell({ type: 'phase', phase: 'paused' });
    expect(events('log').at(-1)).toMatchObject({ events: [], omitted: 5000 - (sentRows.length - 2) });
  });

  it('of the radio come through while a program prints without end', () => {
    const { simulator, events } = greeted({ phase: 'running' });
    for (let times = 0; times < 100; times += 1) simulator.tell({ type: 'output', text: 'x'.repeat(9999) });
    simulator.tell({ type: 'radio', packets: [{ timeUs: 1, group: 0, bytes: [1, 0, 1, 104] }] });
    expect(events('radio').length).toBe(1);
  });

  it('come only as far as they are wanted', () => {
    const { simulator, ask, events } = greeted();
    ask('subscribe', { events: ['output'] });
    simulator.tell({ type: 'started' });
    simulator.tell({ type: 'output', text: 'hi' });
    expect([events('started').length, events('output').length]).toEqual([0, 1]);
    expect(ask('subscribe', { events: ['everything'] })).toMatchObject({ code: 'wrong-message', path: 'events.0' });
  });

  it('tell radio packets as text where they are one', () => {
    const { simulator, events } = greeted();
    const packets = [{ timeUs: 5000, group: 0, bytes: [1, 0, 1, 104, 105] }, { timeUs: 6000, group: 0, bytes: [7, 255] }]; // prettier-ignore
    simulator.tell({ type: 'radio', packets });
    expect(events('radio')).toEqual([{ parcours: 1, type: 'radio', packets: [{ atMs: 5, text: 'hi' }, { atMs: 6, bytes: [7, 255] }] }]); // prettier-ignore
  });

  it('have the form that the manual promises, as do answers', async () => {
    const { simulator, heard, ask, say, answerTo } = greeted({ project: fullProject() });
    ask('subscribe', { snapshotHz: 60 });
    simulator.where = { timeUs: 1500, variables: VARIABLES };
    const ids = new Map(Object.keys(answerSchemas).map((name) => [name, say(name)]));
    say('run');
    await settled();
    const snapshot = simulator.snapshot()!;
    simulator.tell({ type: 'snapshot', snapshot });
    simulator.tell({ type: 'output', text: 'hi' });
    simulator.tell({ type: 'radio', packets: [{ timeUs: 1, group: 0, bytes: [1] }] });
    simulator.tell({ type: 'log', events: [{ type: 'clear', timeUs: 1 }, { type: 'row', headings: ['a'], values: [], timeUs: 2 }] }); // prettier-ignore
    simulator.tell({ type: 'sensed', action: { type: 'button', button: 'b', down: true } });
    simulator.tell({ type: 'settings', settings: { ...defaultProjectSettings, ...simulator.settings() } });
    simulator.tell({ type: 'refused', message: 'No.' });
    simulator.tell({ type: 'failed', message: 'No.' });
    simulator.tell({ type: 'program-restarted' });
    simulator.tell({ type: 'held', timeUs: 2500, file: 'main.py', line: 3 });
    simulator.tell({ type: 'looking', timeUs: null });
    simulator.tell({ type: 'break-points', points: [{ file: 'main.py', line: 3 }], device: 'remote' });
    simulator.tell({ type: 'scene', scene: defaultScene() });
    simulator.tell({ type: 'files', files: simulator.project().files });
    simulator.tell({ type: 'program-ended', ended: { kind: 'fault', exception: null, timeUs: 7 }, verdict: null });
    const events = heard.filter((message) => typeof message['type'] === 'string');
    expect([...new Set(events.map((message) => message['type']))].sort()).toEqual(Object.keys(eventSchemas).sort());
    for (const event of events) {
      const type = String(event['type']);
      expect(() => v.parse(eventSchemas[type as EventName] as v.GenericSchema, ownFields(event)), type).not.toThrow();
    }
    for (const [name, id] of ids) {
      const schema: v.GenericSchema = answerSchemas[name as keyof typeof answerSchemas];
      expect(() => v.parse(schema, ownFields(answerTo(id) ?? {})), name).not.toThrow();
    }
  });
});

/** A list in a function, and a number. */
const VARIABLES = {
  stack: [
    {
      ...{ function: 'turn', file: 'main.py', line: 3 },
      locals: [
        {
          name: 'way',
          value: { type: 'list', text: '[1, …]', parts: [{ name: '0', value: { type: 'int', text: '1' } }], more: 1 },
        },
      ],
    },
  ],
  globals: [{ name: 'n', value: { type: 'int', text: '7' } }],
} as const;

/** The content of a message without the common fields. */
const ownFields = (message: Message): object =>
  Object.fromEntries(Object.entries(message).filter(([key]) => !['parcours', 'type', 'reply', 'ok'].includes(key)));

describe('events of a project with several microcomputers', () => {
  const other = { device: 'Fernbedienung' } as const;

  it('name the further one from which they come; those of the first are as ever', () => {
    const { simulator, events } = greeted({ phase: 'running' });
    simulator.tell({ type: 'output', text: 'one\n' });
    simulator.tell({ type: 'output', text: 'two\n', ...other });
    simulator.tell({ type: 'radio', packets: [], ...other });
    simulator.tell({ type: 'sensed', action: { type: 'button', button: 'a', down: true }, ...other });
    simulator.tell({ type: 'program-restarted', ...other });
    expect(events('output').map(({ text, device }) => [text, device])).toEqual([
      ['one\n', undefined],
      ['two\n', 'Fernbedienung'],
    ]);
    expect(events('sensed')).toEqual([expect.objectContaining({ sensor: 'buttonA', value: 1, ...other })]);
    expect(events('program-restarted')).toEqual([expect.objectContaining(other)]);
  });

  it('tell the end of each program once, also of those that a stop ends', () => {
    const { simulator, events } = greeted({ project: devicesProject(), phase: 'running' });
    simulator.tell({ type: 'started' });
    simulator.tell({ type: 'program-ended', ended: { kind: 'finished', exception: null, timeUs: 1000 }, verdict: null, ...other }); // prettier-ignore
    simulator.tell({ type: 'phase', phase: 'stopped' });
    expect(events('ended').map(({ device, ended }) => [device, ended])).toEqual([
      ['Fernbedienung', 'finished'],
      [undefined, 'stopped'],
      ['Ärzt 2', 'stopped'],
    ]);
  });

  it('count what is left out for each of them', () => {
    const { simulator, events, time } = greeted({ phase: 'running' });
    const flood = 'x'.repeat(limits.outputCharactersPerSecond);
    simulator.tell({ type: 'output', text: flood, ...other });
    simulator.tell({ type: 'output', text: 'heard' });
    time.ms = 2000;
    simulator.tell({ type: 'output', text: 'again', ...other });
    expect(events('output').map(({ text, omitted, device }) => [text, omitted, device])).toEqual([
      ['heard', undefined, undefined],
      ['again', flood.length, 'Fernbedienung'],
    ]);
  });
});
