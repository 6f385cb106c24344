import compiled from '../../../.cache/vm/library.json';

/** The bytes of a text with one in the lower half of each character's code. */
function bytesOf(text: string): Uint8Array {
  const bytes = new Uint8Array(text.length);
  for (let at = 0; at < text.length; at += 1) bytes[at] = text.charCodeAt(at) & 0xff;
  return bytes;
}

/** The device's own modules as bytecode files (`microbit.mpy`), made by scripts/build-library.mjs. */
export const deviceLibrary: ReadonlyMap<string, Uint8Array> = new Map(
  Object.entries(compiled).map(([name, text]) => [name, bytesOf(text)]),
);
