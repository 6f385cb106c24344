import { describe, expect, it } from 'vitest';
import { csvOf, emptyLog, withLogEvents } from './log-table';

const row = (headings: string[], ...values: string[]) => ({ type: 'row', headings, values }) as const;

describe('the table of the data log', () => {
  it('grows by columns at the end: earlier rows have empty cells there', () => {
    const table = withLogEvents(emptyLog, [row(['t', 'x'], '0', '1'), row(['t', 'x', 'y'], '1', '2', '3')]);
    expect(csvOf(table)).toBe('t,x,y\r\n0,1,\r\n1,2,3\r\n');
  });

  it('has new columns before their first value', () => {
    expect(csvOf(withLogEvents(emptyLog, [row(['x', 'y'])]))).toBe('x,y\r\n');
  });

  it('gets no row from headings that are written alone', () => {
    const table = withLogEvents(emptyLog, [row(['t', 'x']), row(['t', 'x'], '0', '1')]);
    expect(csvOf(table)).toBe('t,x\r\n0,1\r\n');
  });

  it('is empty again after the program has deleted the log', () => {
    const table = withLogEvents(emptyLog, [row(['x'], '1'), { type: 'clear' }, row(['y'], '2')]);
    expect(csvOf(table)).toBe('y\r\n2\r\n');
    expect(csvOf(withLogEvents(table, [{ type: 'clear' }]))).toBe('');
  });

  it('puts what a spreadsheet would misread into quotes', () => {
    expect(csvOf(withLogEvents(emptyLog, [row(['a,b'], 'he said "hi"')]))).toBe('"a,b"\r\n"he said ""hi"""\r\n');
  });
});
