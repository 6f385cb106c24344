/**
 * Globals that reach the network, storage or another page, or make a worker that has them again. A run needs none of
 * them.
 */
const FORBIDDEN_GLOBALS = [
  ...['fetch', 'XMLHttpRequest', 'WebSocket', 'WebSocketStream', 'EventSource', 'WebTransport', 'importScripts'],
  ...['FontFace', 'fonts'], // a font is fetched
  ...['Worker', 'SharedWorker', 'BroadcastChannel'],
  ...['indexedDB', 'caches', 'cookieStore'],
] as const;

/** Likewise on the worker's navigator. */
const FORBIDDEN_ON_NAVIGATOR = ['storage', 'storageBuckets', 'serviceWorker', 'locks'] as const;

/**
 * Removes from a worker's global everything that could reach the network or the disk, before the VM is loaded.
 * A program cannot reach JavaScript anyway (it sees numbers and short texts only); this is the second line of defence.
 * `import()` is not a global and stays: only the HTTP header of the worker's file can forbid it (docs/hosting.md).
 */
export function sealSandbox(scope: { readonly navigator?: object }): void {
  for (const name of FORBIDDEN_GLOBALS) takeAway(scope, name);
  if (scope.navigator !== undefined) for (const name of FORBIDDEN_ON_NAVIGATOR) takeAway(scope.navigator, name);
}

/** Removes a property for good, wherever in the prototype chain it is defined. */
function takeAway(scope: object, name: string): void {
  for (let owner: object | null = scope; owner !== null; owner = Object.getPrototypeOf(owner) as object | null) {
    if (Object.hasOwn(owner, name)) Reflect.deleteProperty(owner, name);
  }
  Object.defineProperty(scope, name, { value: undefined, writable: false, configurable: false });
}
