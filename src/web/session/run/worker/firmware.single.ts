import { gunzipSync } from 'fflate';

import packed from 'single:firmware';

import { fetchedOnce } from '#core/memo';
import { FirmwareError, mayCompile } from './firmware-trouble';

/** The VM, which is part of the page (gzip, base64), compiled once and shared by all workers. */
export const compileFirmware = fetchedOnce(async () => {
  if (!mayCompile()) throw new FirmwareError('forbidden');
  return WebAssembly.compile(gunzipSync(Uint8Array.from(atob(packed), (letter) => letter.charCodeAt(0))));
});
