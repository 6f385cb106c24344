import firmwareUrl from '../../../../.cache/vm/vm.wasm?url';

let compiled: Promise<WebAssembly.Module> | null = null;

/** The VM, compiled once per page (while it is downloaded, where the host names its type right) and shared by all workers. */
export function compileFirmware(): Promise<WebAssembly.Module> {
  compiled ??= compile(new URL(firmwareUrl, import.meta.url).href).catch((error: unknown) => {
    compiled = null; // offline for a moment: the next try may work
    throw error;
  });
  return compiled;
}

async function compile(url: string): Promise<WebAssembly.Module> {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url}: ${response.status}`);
  if (response.headers.get('content-type')?.startsWith('application/wasm'))
    return WebAssembly.compileStreaming(response);
  return WebAssembly.compile(await response.arrayBuffer());
}
