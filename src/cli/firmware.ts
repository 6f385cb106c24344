import { existsSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

/** The bytes of the VM: beside the bundle, or where set-up has made it. */
export function readFirmware(): Uint8Array<ArrayBuffer> {
  const places = ['./vm.wasm', '../../.cache/vm/vm.wasm'].map((place) =>
    fileURLToPath(new URL(place, import.meta.url)),
  );
  const place = places.find((candidate) => existsSync(candidate));
  if (place === undefined) throw new Error(`The VM is missing (${places.join(', ')}). Run: npm run setup`);
  return new Uint8Array(readFileSync(place));
}
