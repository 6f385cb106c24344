import { describe, expect, it } from 'vitest';

import { sealSandbox } from './sandbox';

describe('the sandbox', () => {
  it('takes fetch and the like away, wherever they come from, for good', () => {
    class Scope {
      XMLHttpRequest = class {};
      fetch(): string {
        return 'out';
      }
    }
    const scope = Object.create(Scope.prototype, {}) as Record<string, unknown>;
    scope['indexedDB'] = {};
    sealSandbox(scope);
    for (const name of [
      ...['Worker', 'SharedWorker', 'BroadcastChannel', 'FontFace', 'fonts', 'WebSocketStream', 'cookieStore'],
      'fetch',
      'XMLHttpRequest',
      'WebSocket',
      'EventSource',
      'importScripts',
      'indexedDB',
      'caches',
    ]) {
      expect(scope[name], name).toBeUndefined();
      expect(() => Object.assign(scope, { [name]: 1 }), name).toThrow(TypeError);
    }
    expect('fetch' in Scope.prototype).toBe(false);
  });

  it('takes storage away that hangs on the navigator', () => {
    class Navigator {
      readonly hardwareConcurrency = 2;
      get storage(): object {
        return {};
      }
    }
    const navigator = new Navigator();
    const scope = { navigator };
    sealSandbox(scope);
    expect('storage' in navigator && navigator.storage).toBeUndefined();
    expect(scope.navigator.hardwareConcurrency).toBe(2);
  });
});
