import { gunzipSync } from 'fflate';

import packed from 'single:firmware';

import { FirmwareError, mayCompile } from './firmware-trouble';

let compiled: Promise<WebAssembly.Module> | null = null;

/** The VM, which is part of the page (gzip, base64), compiled once and shared by all workers. */
export function compileFirmware(): Promise<WebAssembly.Module> {
  if (!mayCompile()) return Promise.reject(new FirmwareError('forbidden'));
  compiled ??= WebAssembly.compile(gunzipSync(Uint8Array.from(atob(packed), (letter) => letter.charCodeAt(0))));
  return compiled;
}
