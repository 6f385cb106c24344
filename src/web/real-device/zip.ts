import { zipSync } from 'fflate';

import type { DeviceFile } from './put-files';

/** The same moment for every file, so that the same project gives the same zip: the earliest that a zip can hold. */
const MOMENT = '1980-01-02T00:00:00';

/** Files as one zip, without folders. */
export function zipOf(files: readonly DeviceFile[]): Uint8Array<ArrayBuffer> {
  const encoder = new TextEncoder();
  return zipSync(Object.fromEntries(files.map(({ name, text }) => [name, encoder.encode(text)])), { mtime: MOMENT });
}
