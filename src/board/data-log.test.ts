import { describe, expect, it } from 'vitest';
import { DataLog, LOG_BYTES, NO_TIMESTAMP, type LogEvent } from './data-log';

const SECONDS = 10;
const HOURS = 36_000;

function record(log: DataLog): LogEvent[] {
  const events: LogEvent[] = [];
  log.onEvent((event) => events.push(event));
  return events;
}

describe('data log', () => {
  it('J1: a column is added when it first gets a value, at the end', () => {
    const log = new DataLog();
    log.add([['a', '1']], 0);
    log.add(
      [
        ['b', '2'],
        ['a', '3'],
      ],
      0,
    );
    log.add([['b', '4']], 0);
    expect(log.csv).toBe('a\n1\na,b\n3,2\n,4\n');
  });

  it('J2: a timestamp that is set before the first row comes first, later ones last', () => {
    const log = new DataLog();
    log.setTimestamp(SECONDS);
    log.add([['x', '1']], 1239);
    log.setTimestamp(HOURS);
    log.add([['x', '2']], 5_400_000);
    expect(log.csv).toBe('Time (seconds),x\n1.23,1\nTime (seconds),x,Time (hours)\n,2,1.50\n');
  });

  it.each([
    [1, 'Time (milliseconds)', '93784567'],
    [10, 'Time (seconds)', '93784.56'],
    [600, 'Time (minutes)', '1563.07'],
    [36_000, 'Time (hours)', '26.05'],
    [864_000, 'Time (days)', '1.08'],
  ])('J3: the unit %i is written %s: %s', (unit, heading, text) => {
    const log = new DataLog();
    log.setTimestamp(unit);
    log.add([['v', '1']], 93_784_567);
    expect(log.csv).toBe(`${heading},v\n${text},1\n`);
  });

  it('J3: another unit has no name, and hundredths, too', () => {
    const log = new DataLog();
    log.setTimestamp(7);
    log.add([['v', '1']], 93_784);
    expect(log.csv).toBe('Time (),v\n133.97,1\n');
  });

  it('J4: labels alone are a line of headings; no values, no row, no timestamp', () => {
    const log = new DataLog();
    const events = record(log);
    log.setTimestamp(SECONDS);
    log.add(
      [
        ['a', ''],
        ['b', ''],
      ],
      5000,
    );
    log.add([['a', '']], 6000);
    log.add([['b', '7']], 7000);
    expect(log.csv).toBe('Time (seconds),a,b\n7.00,,7\n');
    const headings = ['Time (seconds)', 'a', 'b'];
    expect(events).toEqual([
      { type: 'row', headings, values: [] },
      { type: 'row', headings, values: ['7.00', '', '7'] },
    ]);
  });

  it('J5: before anything is logged the timestamp may still be replaced', () => {
    const log = new DataLog();
    log.setTimestamp(SECONDS);
    log.setTimestamp(NO_TIMESTAMP);
    log.add([['a', '1']], 0);
    expect(log.csv).toBe('a\n1\n');
  });

  it('J6: what would break the table becomes underlines', () => {
    const log = new DataLog();
    log.add([['a,b\tc', 'x-->y\nz']], 0);
    expect(log.csv).toBe('a_b_c\nx___y_z\n');
  });

  it('J7: 118,780 bytes fit; the row that does not is lost, and the log counts as full until it is deleted', () => {
    const log = new DataLog();
    const events = record(log);
    expect(log.add([['a', 'é'.repeat((LOG_BYTES - 14) / 2)]], 0)).toBe(true); // 2 bytes of heading, 11 left
    expect(log.add([['a', '12345678901']], 0)).toBe(false);
    expect([log.isFull, new TextEncoder().encode(log.csv).length]).toEqual([true, LOG_BYTES - 11]);
    expect(log.add([['a', '1234567890']], 0)).toBe(false);
    expect(new TextEncoder().encode(log.csv).length).toBe(LOG_BYTES);
    expect(events.map(({ type }) => type)).toEqual(['row', 'full', 'row']);
    log.delete();
    expect([log.isFull, log.csv, log.headings, log.add([['b', '1']], 0), log.csv]).toEqual([
      false,
      '',
      [],
      true,
      'b\n1\n',
    ]);
  });

  it('J8: deleting tells, and keeps the timestamp', () => {
    const log = new DataLog();
    log.setTimestamp(SECONDS);
    log.add([['a', '1']], 0);
    const events = record(log);
    log.delete();
    log.add([['a', '2']], 0);
    expect(events[0]).toEqual({ type: 'clear' });
    expect(log.csv).toBe('Time (seconds),a\n0.00,2\n');
  });

  it('J9: outlives a reset, with its columns; timestamp and mirror are set anew', () => {
    const log = new DataLog();
    const lines: string[] = [];
    log.mirrorTo((line) => lines.push(line));
    log.setTimestamp(SECONDS);
    log.add([['a', '1']], 0);
    log.reset();
    log.setTimestamp(SECONDS);
    log.add([['a', '2']], 40);
    expect([log.csv, lines]).toEqual(['Time (seconds),a\n0.00,1\n0.04,2\n', ['Time (seconds),a', '0.00,1']]);
  });

  it('J10: a new main.py makes it worthless: it is deleted, and nothing is told when it was empty', () => {
    const log = new DataLog();
    const events = record(log);
    log.invalidate();
    log.add([['a', '1']], 0);
    log.invalidate();
    expect([events.map(({ type }) => type), log.csv]).toEqual([['row', 'clear'], '']);
  });
});
