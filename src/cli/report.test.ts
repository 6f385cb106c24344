import { describe, expect, it } from 'vitest';
import { rounded } from '#simulation/report';
import { exitCodeOf, jsonLine, type Report } from './report';
import { createTerminal } from './terminal';
import { traceColumns, traceHeader, traceLine } from './trace-csv';

const report: Report = {
  ended: 'finished',
  exception: null,
  simulatedMs: 1,
  wallMs: 2,
  realTimeFactor: 0.5,
  robot: null,
  display: '00000:00000:00000:00000:00000',
  verdict: null,
  heapFree: 1,
  traceHash: 'ab',
  radio: [],
  radioSent: 0,
  lights: [],
  devices: [],
};

describe('the report', () => {
  it('is one line with exactly the promised fields in their order', () => {
    const line = jsonLine(report, ['one\ntwo\n']);
    expect(line).not.toContain('\n');
    expect(Object.keys(JSON.parse(line) as object)).toEqual([
      ...[
        'ended',
        'exception',
        'simulatedMs',
        'wallMs',
        'realTimeFactor',
        'robot',
        'display',
        'verdict',
        'console',
        'heapFree',
        'traceHash',
        'devices',
      ],
    ]);
  });

  it('tells what was sent by radio, when something was', () => {
    const sent = { ...report, radio: [{ atMs: 5, text: 'go' }], radioSent: 1 };
    expect(JSON.parse(jsonLine(sent, ['']))).toMatchObject({ radio: [{ atMs: 5, text: 'go' }], radioSent: 1 });
  });

  it('has no packet twice: those of the first device stand beside the devices', () => {
    const { simulatedMs: _, wallMs: __, realTimeFactor: ___, verdict: ____, traceHash: _____, ...plain } = report;
    const sending = (name: string) => ({ ...plain, name, radio: [{ atMs: 5, text: name }], radioSent: 7 });
    const sent = { ...report, ...sending('one'), devices: [sending('one'), sending('two')] };
    const line = JSON.parse(jsonLine(sent, ['', ''])) as { devices: object[] };
    expect(line).toMatchObject({ radio: [{ text: 'one' }], radioSent: 7 });
    expect(line.devices[0]).not.toHaveProperty('radio');
    expect(line.devices[1]).toMatchObject({ radio: [{ text: 'two' }], radioSent: 7 });
  });

  it('gives exit code 1 for a program that ended badly, else 0', () => {
    expect((['finished', 'time-limit', 'exception', 'panic', 'stopped', 'stuck'] as const).map(exitCodeOf)).toEqual([
      0, 0, 1, 1, 1, 1,
    ]);
  });

  it('knows no negative zero', () => {
    expect(Object.is(rounded(-0.0001), 0)).toBe(true);
  });
});

describe('the trace file', () => {
  const row = {
    device: '1',
    timeUs: 20_000,
    xMm: 100.12345,
    yMm: 50,
    headingRad: Math.PI / 2,
    leftMmPerS: 100,
    rightMmPerS: -100,
    leftDuty: 0.5,
    rightDuty: -0.5,
    lineSensors: [
      { name: 'left', bright: true },
      { name: 'right', bright: false },
    ],
    distanceMm: null,
    collisions: 3,
  };

  it('names its columns, one for each line sensor', () => {
    expect(traceHeader(traceColumns([row], 1))).toBe(
      't_ms,x_mm,y_mm,heading_deg,left_mm_s,right_mm_s,left_duty,right_duty,line_left,line_right,distance_mm,collisions',
    );
  });

  it('has one line per moment, with nothing where there is no distance', () => {
    expect(traceLine(row, traceColumns([row], 1))).toBe('20,100.123,50,90,100,-100,0.5,-0.5,1,0,,3');
  });
});

describe('the terminal', () => {
  function watch(isTTY: boolean, quiet = false) {
    const written: string[] = [];
    const out = { write: (text: string) => written.push(`out:${text}`), isTTY };
    const err = { write: (text: string) => written.push(`err:${text}`), isTTY };
    return { terminal: createTerminal(out, err, quiet), written };
  }

  it('puts the report on a line of its own', () => {
    const { terminal, written } = watch(false);
    terminal.program('half a line');
    terminal.line('{}');
    expect(written).toEqual(['out:half a line', 'out:\n{}\n']);
  });

  it('shows progress only where a person looks on', () => {
    const piped = watch(false);
    piped.terminal.progress(1000, 100);
    const quiet = watch(true, true);
    quiet.terminal.progress(1000, 100);
    expect([...piped.written, ...quiet.written]).toEqual([]);
    const seen = watch(true);
    seen.terminal.progress(1500, 99.6);
    seen.terminal.program('hello\n');
    expect(seen.written).toEqual(['err:\r\u001b[K1.5 s simulated, 100 × real time', 'err:\r\u001b[K', 'out:hello\n']);
  });

  it('says nothing of the program when quiet', () => {
    const { terminal, written } = watch(false, true);
    terminal.program('hello\n');
    expect(written).toEqual([]);
  });
});
