import { font } from './font';

const LIT = 9;

const drawn = new Map<string, Uint8Array>();

/** The picture of one character: 25 brightnesses 0 or 9, row by row. Characters without one show as `?`. */
export function glyphOf(char: string): Uint8Array {
  const known = Object.hasOwn(font, char) ? char : '?';
  const glyph = drawn.get(known) ?? draw(font[known]);
  drawn.set(known, glyph);
  return glyph.slice();
}

function draw(rows: string | undefined): Uint8Array {
  const pixels = (rows ?? '').replaceAll(':', '');
  return Uint8Array.from(pixels, (pixel) => (pixel === '1' ? LIT : 0));
}

/** The characters of a text as the device counts them. It knows bytes: an umlaut is two unknown characters. */
export function* bytesOf(text: string): Generator<string> {
  for (const char of text) {
    const code = char.codePointAt(0) ?? 0;
    const byteCount = code < 0x80 ? 1 : code < 0x800 ? 2 : code < 0x10000 ? 3 : 4;
    for (let i = 0; i < byteCount; i++) yield byteCount === 1 ? char : '\u{fffd}';
  }
}
