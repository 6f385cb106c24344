import type { LogProblem, ReadLog, Remark } from './device-log';
import { pageLog } from './microbit-page';
import { readTable } from './read-table';
import { separated } from './separated';

/**
 * Reads what a real board has logged: the file MY_DATA.HTM of a micro:bit V2, as it is or saved again by a browser, or a
 * table of separated values from that page or from a spreadsheet. It never throws.
 *
 * @param bytes the whole file; the caller limits its size
 */
export function readDeviceLog(bytes: Uint8Array): ReadLog {
  if (bytes.length === 0) return problem({ code: 'empty' });
  if (isWorkbook(bytes)) return problem({ code: 'workbook' });
  const text = textOf(bytes);
  const page = pageLog(text.lenient);
  if (page === null) {
    if (/^\s*<(?:!doctype|html|head|body)/i.test(text.lenient)) return problem({ code: 'other-page' });
    return text.exact.includes('\0') ? problem({ code: 'not-text' }) : logOf(text.exact, false, false);
  }
  if (page.kind === 'cut-short') return problem({ code: 'cut-short', size: kB(bytes.length), start: kB(page.start) });
  if (page.csv.trim() === '' && !page.isCutOff) return problem({ code: 'empty-log' });
  if (page.csv.trim() === '') return problem({ code: 'cut-short', size: kB(bytes.length), start: kB(bytes.length) });
  return logOf(page.csv, page.isFull, page.isCutOff);
}

function logOf(csv: string, isFull: boolean, isCutOff: boolean): ReadLog {
  const read = readTable(separated(csv));
  if (read.kind === 'problem') return read;
  const cut: readonly Remark[] = isCutOff ? [{ code: 'cut-off', rows: read.table.rows.length }] : [];
  return { kind: 'log', log: { ...read.table, isFull, remarks: [...cut, ...read.remarks] } };
}

const problem = (it: LogProblem): ReadLog => ({ kind: 'problem', problem: it });
const kB = (bytes: number): number => Math.ceil(bytes / 102.4) / 10;

/** True for a workbook: files of Excel and of LibreOffice are archives; older ones of Excel have their own mark. */
const isWorkbook = (bytes: Uint8Array): boolean =>
  startsWith(bytes, [0x50, 0x4b, 0x03, 0x04]) || startsWith(bytes, [0xd0, 0xcf, 0x11, 0xe0]);

const startsWith = (bytes: Uint8Array, mark: readonly number[]): boolean =>
  mark.every((byte, place) => bytes[place] === byte);

/**
 * A file as text: `lenient` with U+FFFD for each byte that is not UTF-8, `exact` in the encoding it was saved in.
 * Excel writes UTF-16 (“Unicode text”), UTF-8 with a mark before it, or the characters of Windows.
 */
function textOf(bytes: Uint8Array): { readonly lenient: string; readonly exact: string } {
  const same = (text: string) => ({ lenient: text, exact: text });
  if (startsWith(bytes, [0xff, 0xfe])) return same(new TextDecoder('utf-16le').decode(bytes));
  if (startsWith(bytes, [0xfe, 0xff])) return same(new TextDecoder('utf-16be').decode(bytes));
  const lenient = new TextDecoder('utf-8').decode(bytes);
  return lenient.includes('\uFFFD') ? { lenient, exact: new TextDecoder('windows-1252').decode(bytes) } : same(lenient);
}
