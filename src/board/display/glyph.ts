import { font } from './font';

const LIT = 9;

/** The picture of one character: 25 brightnesses 0 or 9, row by row. Characters without one show as `?`. */
export function glyphOf(char: string): Uint8Array {
  const rows = Object.hasOwn(font, char) ? font[char] : font['?'];
  const pixels = (rows ?? '').replaceAll(':', '');
  return Uint8Array.from(pixels, (pixel) => (pixel === '1' ? LIT : 0));
}
