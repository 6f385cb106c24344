/** Contents of a micro:bit V2's flash memory, and hence of its file MY_DATA.HTM. */
export interface MicrobitPage {
  /** The rows as the board writes them: a line of names whenever they change. */
  readonly csv: string;
  /** The columns' names behind the meta data. */
  readonly names?: string;
  /** A row did not fit any more. */
  readonly isFull?: boolean;
  /** Room for the rows, in bytes; on a real board 118,780. */
  readonly roomBytes?: number;
}

const HEAD_BYTES = 2048;
const DATA_AT = 0x2000;
const JOURNAL_AT = 0x1000;
const UNUSED = 0xff;

/** Beginning of the page, shortened: its script names the mark of the log as well (MicroBitLog.cpp, header). */
const HEAD =
  '<!doctype html><meta charset=utf-8><script>let csv="";window.dl={load:function(){let o=document.documentElement.' +
  'outerHTML.split("FS_START")[2];if(/^UBIT_LOG_FS_V_002/.test(o)){csv=o.substr(parseInt(o.substr(29,10),16)-2048)}}}' +
  '</script><title>micro:bit data log</title><body onload=dl.load()><div id=w><h1>micro:bit data log</h1></div>';

/**
 * The bytes of MY_DATA.HTM, laid out as codal-microbit-v2 does: `MicroBitLog::clear()` writes head and meta data,
 * `logString()` the rows, the journal's entry and, at the log's end, `FUL`.
 */
export function microbitPage({ csv, names = '', isFull = false, roomBytes = 118_780 }: MicrobitPage): Uint8Array {
  const end = DATA_AT + roomBytes;
  const bytes = new Uint8Array(end + 4).fill(UNUSED);
  const put = (at: number, text: string): void => bytes.set(new TextEncoder().encode(text), at);
  put(0, `${HEAD.padEnd(HEAD_BYTES - '<!--FS_START'.length)}<!--FS_START`);
  put(HEAD_BYTES, `UBIT_LOG_FS_V_002\n${address(end)}\n${address(DATA_AT)}\n0257\0${names}`);
  put(JOURNAL_AT, '\0\0\0\0\0\0\0\x0000000100');
  put(DATA_AT, csv);
  bytes.fill(0, end, end + 4);
  if (isFull) put(end + 1, 'FUL');
  return bytes;
}

const address = (at: number): string => `0x${at.toString(16).toUpperCase().padStart(8, '0')}`;
