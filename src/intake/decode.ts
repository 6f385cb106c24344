/** A text, and the coding of its bytes where that is not UTF-8. */
export interface Decoded {
  readonly text: string;
  /** Left out: UTF-8. */
  readonly coding?: 'UTF-16' | 'Windows-1252';
}

/**
 * Reads the bytes of a text: UTF-8, UTF-16 with its mark in front (as Windows' Notepad calls it “Unicode”), else
 * Windows-1252 (its “ANSI”); `null`: it is no text.
 */
export function decoded(bytes: Uint8Array): Decoded | null {
  const [first, second] = bytes;
  const marked = first === 0xff && second === 0xfe ? 'utf-16le' : first === 0xfe && second === 0xff ? 'utf-16be' : null;
  if (marked !== null) return as('UTF-16', inCoding(bytes, marked));
  const text = inCoding(bytes, 'utf-8');
  return text === null ? as('Windows-1252', inTable(bytes, WINDOWS_1252)) : { text };
}

/** Signs that no text has, such as those in a picture or a film. */
const NO_TEXT = /[\0-\x08\x0e-\x1a\x1c-\x1f]/;

const as = (coding: NonNullable<Decoded['coding']>, text: string | null): Decoded | null =>
  text === null || NO_TEXT.test(text) ? null : { text, coding };

function inCoding(bytes: Uint8Array, coding: string): string | null {
  try {
    return new TextDecoder(coding, { fatal: true }).decode(bytes);
  } catch {
    return null;
  }
}

/** The upper half of Windows-1252, as browsers have it; a table, because Node reads it as Latin-1. */
const WINDOWS_1252 = `€\u0081‚ƒ„…†‡ˆ‰Š‹Œ\u008dŽ\u008f\u0090‘’“”•–—˜™š›œ\u009džŸ${Array.from({ length: 96 }, (_, index) => String.fromCharCode(160 + index)).join('')}`;

/** The upper half of code page 850, in which Windows writes the names in a zip (Microsoft: OEM 850, Multilingual Latin I). */
const CODE_PAGE_850 =
  'ÇüéâäàåçêëèïîìÄÅÉæÆôöòûùÿÖÜø£Ø×ƒáíóúñÑªº¿®¬½¼¡«»░▒▓│┤ÁÂÀ©╣║╗╝¢¥┐└┴┬├─┼ãÃ╚╔╩╦╠═╬¤ðÐÊËÈıÍÎÏ┘┌█▄¦Ì▀ÓßÔÒõÕµþÞÚÛÙýÝ¯´\u00ad±‗¾¶§÷¸°¨·¹³²■\u00a0';

/** A name in a zip without the mark of UTF-8: newer programs write UTF-8 nevertheless, Windows its code page. */
export const nameInZip = (bytes: Uint8Array): string => inCoding(bytes, 'utf-8') ?? inTable(bytes, CODE_PAGE_850);

/** @param upper the signs of the bytes from 128 on */
const inTable = (bytes: Uint8Array, upper: string): string =>
  Array.from(bytes, (byte) => (byte < 128 ? String.fromCharCode(byte) : upper.charAt(byte - 128))).join('');
