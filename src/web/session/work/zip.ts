import { zipSync } from 'fflate';

/** A file in a zip; `/` in its name separates folders. */
export interface ZippedFile {
  readonly name: string;
  readonly text: string;
}

/**
 * The same moment for every file, so that the same project gives the same zip. Chosen: near the earliest that a zip can
 * hold.
 */
const MOMENT = '1980-01-02T00:00:00';

/** Files as one zip. */
export function zipOf(files: readonly ZippedFile[]): Uint8Array<ArrayBuffer> {
  const encoder = new TextEncoder();
  return zipSync(Object.fromEntries(files.map(({ name, text }) => [name, encoder.encode(text)])), { mtime: MOMENT });
}
