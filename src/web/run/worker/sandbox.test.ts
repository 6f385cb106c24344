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
});
