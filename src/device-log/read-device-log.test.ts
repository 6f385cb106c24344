import { describe, expect, it } from 'vitest';

import { DataLog } from '#board/data-log';

import type { DeviceLog, LogProblem } from './device-log';
import { readDeviceLog } from './read-device-log';
import { microbitPage } from './testing/microbit-page';

const bytesOf = (text: string): Uint8Array => new TextEncoder().encode(text);
/** One byte per character, as Windows writes German and French. */
const windows = (text: string): Uint8Array => Uint8Array.from(text, (sign) => sign.charCodeAt(0));

function read(file: Uint8Array | string): DeviceLog {
  const result = readDeviceLog(typeof file === 'string' ? bytesOf(file) : file);
  if (result.kind === 'problem') throw new Error(JSON.stringify(result.problem));
  return result.log;
}
function problemOf(file: Uint8Array | string): LogProblem | null {
  const result = readDeviceLog(typeof file === 'string' ? bytesOf(file) : file);
  return result.kind === 'problem' ? result.problem : null;
}
const csv = 'Time (seconds),cm\n0.10,12.5\n0.20,11\n';
const table = {
  headings: ['Time (seconds)', 'cm'],
  rows: [
    ['0.10', '12.5'],
    ['0.20', '11'],
  ],
};

describe('MY_DATA.HTM of a micro:bit', () => {
  it('has the rows up to the first unused byte', () => {
    expect(read(microbitPage({ csv }))).toEqual({ ...table, isFull: false, remarks: [] });
  });

  it('is counted in bytes: names with umlauts move nothing', () => {
    const page = microbitPage({ csv: 'Länge,Größe\n1,2\n', names: 'Länge,Größe\n' });
    expect(read(page).headings).toEqual(['Länge', 'Größe']);
    expect(read(page).rows).toEqual([['1', '2']]);
  });

  it('says when its memory was full', () => {
    expect(read(microbitPage({ csv, isFull: true })).isFull).toBe(true);
    // Full to the last byte: no unused one ends the rows.
    const whole = read(microbitPage({ csv, isFull: true, roomBytes: csv.length }));
    expect(whole).toMatchObject({ ...table, isFull: true, remarks: [] });
  });

  it('is read as well where a browser has saved it again, with U+FFFD and other text before the log', () => {
    const text = new TextDecoder().decode(microbitPage({ csv, names: 'Länge\n', isFull: true }));
    const saved = text.replace('<div id=w>', '<div id=w><p>LOG FULL</p><table><tr><td>0.10</td></tr></table>');
    expect(read(`${saved}--></body></html>`)).toMatchObject({ ...table, isFull: true });
  });

  it('reads what our own board writes, with columns that came later', () => {
    const log = new DataLog();
    log.setTimestamp(10);
    log.add([['light', '12']], 1500);
    log.add([['light', '13'], ['temp', '20.5']], 2500); // prettier-ignore
    expect(read(microbitPage({ csv: log.csv }))).toMatchObject({
      headings: ['Time (seconds)', 'light', 'temp'],
      rows: [
        ['1.50', '12'],
        ['2.50', '13', '20.5'],
      ],
      remarks: [{ code: 'new-columns', line: 3, columns: 'temp' }],
    });
  });

  it('keeps the whole rows of a file that breaks off in the middle of one', () => {
    const page = microbitPage({ csv });
    const cut = page.slice(0, 0x2000 + csv.length - 2);
    expect(read(cut)).toMatchObject({ rows: [['0.10', '12.5']], remarks: [{ code: 'cut-off', rows: 1 }] });
  });

  it.each([1400, 2045, 2048, 2060, 5000, 0x2000, 0x2004])('has no rows if it breaks off after %i bytes', (length) => {
    expect(problemOf(microbitPage({ csv }).slice(0, length))?.code).toBe('cut-short');
  });

  it('may be empty', () => expect(problemOf(microbitPage({ csv: '' }))).toEqual({ code: 'empty-log' }));

  it('is not any other page', () =>
    expect(problemOf('<!DOCTYPE html><html><body>1,2</body></html>')).toEqual({ code: 'other-page' }));
});

describe('a table of separated values', () => {
  it.each([
    ['commas', csv],
    ['lines as Windows ends them', csv.replaceAll('\n', '\r\n')],
    ['semicolons and decimal commas', 'Time (seconds);cm\n0,10;12,5\n0,20;11\n'],
    ['tabs', 'Time (seconds)\tcm\n0.10\t12.5\n0.20\t11\n'],
    ['a mark of UTF-8 before it', `\uFEFF${csv}`],
    ['Excel’s word for the separator', 'sep=;\r\nTime (seconds);cm\r\n0,10;12,5\r\n0,20;11'],
    ['quotes', '"Time (seconds)","cm"\n"0.10","12.5"\n0.20,11\n'],
    ['a title above it', `My walk\n\n${csv}`],
    ['empty cells at the end of each line', 'Time (seconds);cm;;\n0,10;12,5;;\n0,20;11;;\n'],
  ])('may have %s', (_, text) => expect(read(text)).toMatchObject({ ...table, remarks: [] }));

  it('may be Excel’s “Unicode text”', () => {
    const text = '\uFEFFTime (seconds)\tcm\r\n0,10\t12,5\r\n0,20\t11\r\n';
    const bytes = Uint8Array.from(Array.from(text).flatMap((sign) => [sign.charCodeAt(0) & 255, sign.charCodeAt(0) >> 8])); // prettier-ignore
    expect(read(bytes)).toMatchObject(table);
  });

  it('may have the characters of Windows', () =>
    expect(read(windows('Länge;Größe\r\n1,5;2\r\n')).headings).toEqual(['Länge', 'Größe']));

  it('may have one column, also with decimal commas', () => {
    expect(read('cm\n1.5\n2\n').rows).toEqual([['1.5'], ['2']]);
    expect(read('cm\n1,5\n2,25\n').rows).toEqual([['1.5'], ['2.25']]);
  });

  it('may have no names, the same twice, or an empty one', () => {
    expect(read('1,2\n3,4\n')).toMatchObject({ headings: ['#1', '#2'], rows: [['1', '2'], ['3', '4']] }); // prettier-ignore
    expect(read('x,x,,y\n1,2,3,4\n').headings).toEqual(['x', 'x (2)', '#3', 'y']);
  });

  it('may hold an inch mark or a line end in a cell', () => {
    expect(read('5" disk,n\n1,2\n').headings).toEqual(['5" disk', 'n']);
    expect(read('"a\nb",n\n1,2\n1,x\n').remarks).toMatchObject([{ code: 'not-a-number', line: 4 }]);
    expect(read('n,note\n1,"never closed\n2,ok\n').rows).toHaveLength(2);
  });

  it('goes on under new names after an empty line', () => {
    expect(read('t,a\n0,1\n\nt,b\n1,2\n')).toMatchObject({
      headings: ['t', 'a', 'b'],
      rows: [
        ['0', '1'],
        ['1', '', '2'],
      ],
      remarks: [{ code: 'new-columns', line: 4, columns: 'b' }],
    });
  });

  it('tells the first cell that is no number, and how many there are', () => {
    const { remarks } = read('t,x\n0,1\n1,nan\n2,inf\n3,0x10\n4,1e999\n5,2\n');
    expect(remarks).toEqual([{ code: 'not-a-number', line: 3, column: 'x', value: 'nan', count: 4 }]);
  });

  it('tells which columns have no number, and where there are more cells than columns', () => {
    expect(read('t,x,note\n0,1,go\n1,2,stop,9,9\n').remarks).toEqual([
      { code: 'text-columns', columns: 'note' },
      { code: 'extra-cells', line: 3, value: '9', count: 2 },
    ]);
  });

  it('needs numbers beside the time', () => {
    expect(problemOf('name,color\nAda,red\n')).toEqual({ code: 'no-numbers', line: 2, value: 'Ada' });
    expect(problemOf('Time (seconds)\n1\n2\n')).toEqual({ code: 'no-numbers', line: 1, value: 'Time (seconds)' });
    expect(problemOf('x,y\n')).toEqual({ code: 'no-numbers', line: 1, value: 'x' });
  });

  it('may have 60 columns', () => {
    const wide = (count: number): string => `${Array.from({ length: count }, (_, at) => `c${String(at)}`).join()}\n${Array.from({ length: count }, () => 1).join()}\n`; // prettier-ignore
    expect(read(wide(60)).headings).toHaveLength(60);
    expect(problemOf(wide(61))).toEqual({ code: 'too-many-columns', line: 1, count: 61, max: 60 });
    expect(problemOf(wide(300_000))).toMatchObject({ code: 'too-many-columns', count: 300_000 });
  });
});

describe('a file that is no log', () => {
  it.each<readonly [string, Uint8Array | string, LogProblem['code']]>([
    ['nothing', '', 'empty'],
    ['line ends', '\n\r\n\n', 'empty'],
    ['an Excel workbook', Uint8Array.of(0x50, 0x4b, 3, 4, 0, 0), 'workbook'],
    ['an old Excel workbook', Uint8Array.of(0xd0, 0xcf, 0x11, 0xe0), 'workbook'],
    ['a picture', Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 0, 0, 0, 13), 'not-text'],
    ['a program', 'print("hello")\n', 'no-numbers'],
  ])('may be %s', (_, file, code) => expect(problemOf(file)?.code).toBe(code));
});
