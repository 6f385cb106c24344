const ESCAPES: Readonly<Record<string, string>> = { '\n': '\\n', '\r': '\\r', '\t': '\\t', '\\': '\\\\' };

const hex = (code: number, digits: number): string => code.toString(16).padStart(digits, '0');

/** A text as `repr` gives it: py/objstrunicode.c, uni_print_quoted. */
export const quotedText = (bytes: Uint8Array): string => quoted(Array.from(new TextDecoder().decode(bytes)), escaped);

/** Bytes as `repr` gives them: py/objstr.c, mp_str_print_quoted. */
export const quotedBytes = (bytes: Uint8Array): string =>
  `b${quoted(
    Array.from(bytes, (byte) => String.fromCharCode(byte)),
    escaped,
  )}`;

function quoted(characters: readonly string[], escape: (character: string) => string): string {
  const quote = characters.includes("'") && !characters.includes('"') ? '"' : "'";
  const body = characters.map((character) => (character === quote ? `\\${quote}` : escape(character)));
  return `${quote}${body.join('')}${quote}`;
}

function escaped(character: string): string {
  const known = ESCAPES[character];
  if (known !== undefined) return known;
  const code = character.codePointAt(0) ?? 0;
  if (code >= 0x20 && code < 0x7f) return character;
  if (code < 0x100) return `\\x${hex(code, 2)}`;
  return code < 0x10000 ? `\\u${hex(code, 4)}` : `\\U${hex(code, 8)}`;
}
