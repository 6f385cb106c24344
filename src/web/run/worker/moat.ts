/** Doors to the network and to storage that a run has no use for. */
const DOORS = [
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
 * Takes away from a worker's global what could reach the network or the disk, before the VM is loaded.
 * A program cannot reach JavaScript anyway (it sees numbers and short texts only); this is the second wall.
 */
export function closeDoors(scope: object): void {
  for (const door of DOORS) {
    for (let owner: object | null = scope; owner !== null; owner = Object.getPrototypeOf(owner) as object | null) {
      if (Object.hasOwn(owner, door)) Reflect.deleteProperty(owner, door);
    }
    Object.defineProperty(scope, door, { value: undefined, writable: false, configurable: false });
  }
}
