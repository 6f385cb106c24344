import { text } from 'node:stream/consumers';

import type { Plugin } from 'vite';

const FIRMWARE = /[\\/]\.cache[\\/]vm[\\/]vm\.wasm(\?|$)/;

let coming: Promise<void> | undefined;

/**
 * Waits for the VM where it is still being made: `scripts/setup.mjs` then starts the build with PARCOURS_VM=coming, and
 * writes “made” to its standard input.
 */
export const firmwareMade = (): Promise<void> =>
  (coming ??= process.env['PARCOURS_VM'] === 'coming' ? toldSo(process.stdin) : Promise.resolve());

/** @throws Error if the stream ends without the word */
export async function toldSo(stream: NodeJS.ReadableStream): Promise<void> {
  if ((await text(stream)) !== 'made') throw new Error('The VM was not made.');
}

/** Reads everything but the VM while that is still being made. Rolldown is not to warn of a plugin that takes long. */
export const firmwareAwaited = (made = firmwareMade): Plugin => ({
  name: 'firmware-awaited',
  enforce: 'pre',
  config: () => ({ build: { rolldownOptions: { checks: { bundlerTimings: false } } } }),
  async resolveId(id) {
    if (FIRMWARE.test(id)) await made();
    return null;
  },
});
