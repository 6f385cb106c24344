/** Globals that reach the network or storage; a run needs none of them. */
const FORBIDDEN_GLOBALS = [
  'fetch',
  'XMLHttpRequest',
  'WebSocket',
  'EventSource',
  'WebTransport',
  'importScripts',
  'indexedDB',
  'caches',
] as const;

/**
 * Removes from a worker's global everything that could reach the network or the disk, before the VM is loaded.
 * A program cannot reach JavaScript anyway (it sees numbers and short texts only); this is the second line of defence.
 */
export function sealSandbox(scope: object): void {
  for (const name of FORBIDDEN_GLOBALS) {
    for (let owner: object | null = scope; owner !== null; owner = Object.getPrototypeOf(owner) as object | null) {
      if (Object.hasOwn(owner, name)) Reflect.deleteProperty(owner, name);
    }
    Object.defineProperty(scope, name, { value: undefined, writable: false, configurable: false });
  }
}
