import { fromBase64 } from '#core/base64';
import { unread } from '#check/hand-in/unread';
import type { TreeFile } from './tree';

/** The readable parts of an e-mail. */
export interface Mail {
  /** The sender, by the name that goes with the address; empty: unknown. */
  readonly from: string;
  readonly text: string;
}

/** How the texts in an e-mail are read. */
export interface Reading {
  /**
   * True for a text that contains what is looked for: of a text in two forms, plain and page, the first match is
   * taken.
   */
  readonly isWanted: (text: string) => boolean;
  readonly textOfPage: (html: string) => string;
}

/** Maximum depth of e-mails in e-mails. Chosen: nobody forwards one so often. */
const MOST_LEVELS = 12;

/** Reads a saved e-mail (RFC 5322, 2045, 2047): its texts are decoded, attachments are left out. Never throws. */
export function readMail(source: string, reading: Reading): Mail {
  return { from: senderOf(source), text: textOf(source, reading, 0) };
}

/** The sender of an e-mail, by the name that goes with the address; empty: unknown. */
export const senderOf = (source: string): string => senderIn(partOf(source).headers.get('from') ?? '');

/** The files that an e-mail brings along, by their names; pictures between its words are among them. Never throws. */
export function attachmentsIn(source: string, level = 0): readonly TreeFile[] {
  if (level > MOST_LEVELS) return [];
  const { headers, body } = partOf(source);
  const type = headers.get('content-type') ?? 'text/plain';
  if (/^message\/rfc822/i.test(type)) return attachmentsIn(body, level + 1);
  if (/^multipart\//i.test(type))
    return partsIn(body, parameter(type, 'boundary')).flatMap((part) => attachmentsIn(part, level + 1));
  const name = nameOfFile(headers);
  if (name === '') return [];
  const coding = headers.get('content-transfer-encoding')?.toLowerCase() ?? '';
  const bytes = bytesOf(body, coding);
  const read = (most: number) => (bytes.length > most ? unread('large', { file: name, most }) : { bytes });
  return [{ path: name, size: bytes.length, read }];
}

/** The name of a file in an e-mail (RFC 2183, 2231), without folders; empty: it is none. */
function nameOfFile(headers: ReadonlyMap<string, string>): string {
  const disposition = headers.get('content-disposition') ?? '';
  const coded = /^utf-8''(.*)$/i.exec(parameter(disposition, 'filename\\*'))?.[1];
  const plain = parameter(disposition, 'filename') || parameter(headers.get('content-type') ?? '', 'name');
  const name = coded === undefined ? wordsIn(plain) : inCharset(fromQuoted(coded.replaceAll('%', '=')), 'utf-8');
  return name.replace(/^.*[/\\]/, '').trim();
}

interface Part {
  readonly headers: ReadonlyMap<string, string>;
  readonly body: string;
}

/** A text of names and colons may be a list of links, too: it is the head of an e-mail where one of these is in it. */
const KNOWN = /^(from|to|date|subject|received|mime-version|content-[a-z-]+):/im;

function partOf(source: string): Part {
  const blank = /^\r?\n|\r?\n\r?\n/.exec(source);
  const head = source.slice(0, blank?.index ?? 0);
  if (blank === null || (blank.index > 0 && !KNOWN.test(head))) return { headers: new Map(), body: source };
  const headers = new Map<string, string>();
  for (const line of head.replace(/\r?\n[ \t]+/g, ' ').split(/\r?\n/)) {
    const colon = line.indexOf(':');
    if (colon > 0) headers.set(line.slice(0, colon).trim().toLowerCase(), line.slice(colon + 1).trim());
  }
  return { headers, body: source.slice(blank.index + blank[0].length) };
}

function textOf(source: string, reading: Reading, level: number): string {
  if (level > MOST_LEVELS) return '';
  const { headers, body } = partOf(source);
  const type = headers.get('content-type') ?? 'text/plain';
  const coding = headers.get('content-transfer-encoding')?.toLowerCase() ?? '';
  if (/^message\/rfc822/i.test(type)) return textOf(body, reading, level + 1);
  if (/^multipart\//i.test(type)) {
    const texts = partsIn(body, parameter(type, 'boundary')).map((part) => textOf(part, reading, level + 1));
    if (!/^multipart\/alternative/i.test(type)) return texts.join('\n');
    return texts.find(reading.isWanted) ?? '';
  }
  if (!/^text\//i.test(type)) return '';
  const text = decoded(body, coding, parameter(type, 'charset'));
  return /^text\/html/i.test(type) ? reading.textOfPage(text) : text;
}

/** The value of a parameter in a header such as `text/plain; charset="utf-8"`. */
function parameter(header: string, name: string): string {
  const [, quoted, bare] = new RegExp(`;\\s*${name}\\s*=\\s*(?:"([^"]*)"|([^\\s;]+))`, 'i').exec(header) ?? [];
  return quoted ?? bare ?? '';
}

/** The parts between the boundary lines; text before the first and after the last is ignored. */
function partsIn(body: string, boundary: string): readonly string[] {
  const parts: string[][] = [];
  for (const line of body.split(/\r?\n/)) {
    if (line.trimEnd() === `--${boundary}--`) break;
    if (line.trimEnd() === `--${boundary}`) parts.push([]);
    else parts.at(-1)?.push(line);
  }
  return parts.map((lines) => lines.join('\n'));
}

function decoded(body: string, coding: string, charset: string): string {
  return ['base64', 'quoted-printable'].includes(coding) ? inCharset(bytesOf(body, coding), charset) : body;
}

function bytesOf(body: string, coding: string): Uint8Array {
  if (coding === 'base64') return fromBase64(body.replace(/\s/g, '')) ?? new Uint8Array();
  return coding === 'quoted-printable' ? fromQuoted(body.replace(/=[ \t]*\r?\n/g, '')) : new TextEncoder().encode(body);
}

/** Bytes that are written as themselves or as `=C3`. */
function fromQuoted(text: string): Uint8Array {
  const written = new TextEncoder().encode(text);
  const bytes = new Uint8Array(written.length);
  let length = 0;
  for (let at = 0; at < written.length; at += 1, length += 1) {
    const byte = written[at] === EQUALS ? byteOf(written.subarray(at + 1, at + 3)) : null;
    bytes[length] = byte ?? written[at] ?? 0;
    if (byte !== null) at += 2;
  }
  return bytes.subarray(0, length);
}

const EQUALS = 0x3d;

function byteOf(digits: Uint8Array): number | null {
  const text = String.fromCharCode(...digits);
  return /^[\dA-F]{2}$/i.test(text) ? parseInt(text, 16) : null;
}

function inCharset(bytes: Uint8Array, charset: string): string {
  try {
    return new TextDecoder(charset === '' ? 'utf-8' : charset).decode(bytes);
  } catch {
    return new TextDecoder().decode(bytes); // a charset that nobody knows
  }
}

/** `Zoë` of `=?utf-8?Q?Zo=C3=AB?= <zoe@example.org>`. */
function senderIn(header: string): string {
  const address = header.indexOf('<');
  if (address < 0) return '';
  return wordsIn(header.slice(0, address))
    .trim()
    .replace(/^"(.*)"$/, '$1');
}

/** The words of a header, whatever they are coded in (RFC 2047). */
const wordsIn = (header: string): string =>
  header
    .replace(/\?=\s+=\?/g, '?==?')
    .replace(/=\?([^?\s]+)\?([BQ])\?([^?\s]*)\?=/gi, (_, charset: string, coding: string, text: string) =>
      /b/i.test(coding)
        ? decoded(text, 'base64', charset)
        : decoded(text.replaceAll('_', ' '), 'quoted-printable', charset),
    );
