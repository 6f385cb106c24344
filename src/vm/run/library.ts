import { fromBase64 } from '#core/base64';
import compiled from '../../../.cache/vm/library.json';

/** The device's own modules as bytecode files (`microbit.mpy`), made by scripts/build-library.mjs. */
export const deviceLibrary: ReadonlyMap<string, Uint8Array> = new Map(
  Object.entries(compiled).map(([name, base64]) => [name, fromBase64(base64) ?? new Uint8Array()]),
);
