import compiled from '../../../.cache/vm/library.json';

/** The device's own modules as bytecode files (`microbit.mpy`), made by scripts/build-library.mjs. */
export const deviceLibrary: ReadonlyMap<string, Uint8Array> = new Map(
  Object.entries(compiled).map(([name, base64]) => [name, bytesOf(base64)]),
);

function bytesOf(base64: string): Uint8Array {
  const binary = atob(base64);
  return Uint8Array.from(binary, (character) => character.charCodeAt(0));
}
