/**
 * The file MY_DATA.HTM of a micro:bit V2. It is the board's flash memory: a page of 2048 bytes that ends in the begin of
 * a comment, then, as the rest of the comment, the log. Source: codal-microbit-v2 MicroBitLog.cpp and MicroBitLog.h.
 *
 *     offset in the comment    what
 *     0                        UBIT_LOG_FS_V_002 and a line end
 *     18                       0x0001EFFC and a byte: address of the log's end, counted from the page's begin
 *     29                       0x00002000 and a byte: address of the data
 *     40                       more of the kind, the columns' names, a journal; unused bytes are 0xFF
 *     address of the data      the rows as CSV, up to the first unused byte
 *     log's end + 1            FUL, once a row did not fit
 *
 * A browser that saves the page again writes U+FFFD for each byte 0xFF, and other text before the comment. So the text is
 * counted in bytes from the comment on, with U+FFFD as one: this reads both.
 */

/** Contents of the comment in such a page. */
export type PageLog =
  | { readonly kind: 'log'; readonly csv: string; readonly isFull: boolean; readonly isCutOff: boolean }
  /** It ends before its data begins; addresses in bytes. */
  | { readonly kind: 'cut-short'; readonly start: number };

const MARK = /FS_START(UBIT_LOG_FS_V_\d{3}\n(0x[0-9A-F]{8})[^](0x[0-9A-F]{8}))/i;
/** End of the page's head. A page cut off right there has no more of it. */
const HEAD_END = /<!--FS_STAR?T?$/;
/** Length of the page before the comment's content: addresses count from its begin. */
const HEAD_BYTES = 2048;
/** Offset of the data on every board so far: head, page of the meta data, journal, 4 kB each but the first. */
const USUAL_START = 0x2000;
const UNUSED = '\uFFFD';

/** The log in a page's text, decoded as UTF-8 with U+FFFD for invalid bytes. `null`: not such a page. */
export function pageLog(text: string): PageLog | null {
  const found = MARK.exec(text);
  if (found === null) return HEAD_END.test(text) || isCutHead(text) ? { kind: 'cut-short', start: USUAL_START } : null;
  const [, , end = '', start = ''] = found;
  const comment = text.slice(found.index + 'FS_START'.length);
  const from = placeOf(comment, Number(start) - HEAD_BYTES);
  if (from === null) return { kind: 'cut-short', start: Number(start) };
  const unused = comment.slice(from).search(/[\uFFFD\0]/);
  const until = placeOf(comment, Number(end) - HEAD_BYTES) ?? comment.length;
  const isCutOff = until >= comment.length && unused === -1;
  const data = comment.slice(from, unused === -1 ? until : from + unused);
  return {
    kind: 'log',
    csv: isCutOff ? data.slice(0, data.lastIndexOf('\n') + 1) : data,
    isFull: /^[^]{1,3}FUL/.test(comment.slice(until)),
    isCutOff,
  };
}

/** True for the head of such a page. Its script names the mark as well; without the mark itself the rest is missing. */
const isCutHead = (text: string): boolean =>
  text.includes('UBIT_LOG_FS_V_') || /<title>micro:bit data log|micro:bit Data Log<\/h2>/i.test(text);

/** Position in a text after that many bytes of UTF-8; `null`: it has fewer. */
function placeOf(text: string, bytes: number): number | null {
  let left = bytes;
  for (let at = 0; at < text.length; at += 1) {
    if (left <= 0) return at;
    left -= bytesOf(text.charAt(at));
  }
  return left <= 0 ? text.length : null;
}

function bytesOf(unit: string): number {
  if (unit === UNUSED || unit <= '\x7F') return 1;
  if (unit <= '\u07FF' || (unit >= '\uD800' && unit <= '\uDFFF')) return 2; // a half of a pair of four bytes
  return 3;
}
