import firmwareUrl from '../../../../../.cache/vm/vm.wasm?url';
import { fetchedOnce } from '#core/memo';
import { FirmwareError, isCompiled, mayCompile } from './firmware-trouble';

/**
 * The VM, compiled once per page (while it is downloaded, where the host names its type right) and shared by all workers.
 * Rejects with a `FirmwareError`.
 */
export const compileFirmware = fetchedOnce(() => compile(new URL(firmwareUrl, import.meta.url).href));

/** Fetches and compiles the VM at an address. */
export async function compile(url: string): Promise<WebAssembly.Module> {
  if (!mayCompile()) throw new FirmwareError('forbidden');
  try {
    const response = await fetch(url);
    if (!response.ok) throw new Error(`${url}: ${response.status}`);
    if (response.headers.get('content-type')?.startsWith('application/wasm'))
      return await WebAssembly.compileStreaming(response);
    const bytes = await response.arrayBuffer();
    if (!isCompiled(new Uint8Array(bytes))) throw new FirmwareError('foreign');
    return await WebAssembly.compile(bytes);
  } catch (cause) {
    throw cause instanceof FirmwareError ? cause : new FirmwareError('absent', { cause });
  }
}
