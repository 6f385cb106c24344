import { describe, expect, it } from 'vitest';

import { closeDoors } from './moat';

describe('the moat', () => {
  it('takes fetch and the like away, wherever they come from, for good', () => {
    class Scope {
      XMLHttpRequest = class {};
      fetch(): string {
        return 'out';
      }
    }
    const scope = Object.create(Scope.prototype, {}) as Record<string, unknown>;
    scope['indexedDB'] = {};
    closeDoors(scope);
    for (const door of [
      'fetch',
      'XMLHttpRequest',
      'WebSocket',
      'EventSource',
      'importScripts',
      'indexedDB',
      'caches',
    ]) {
      expect(scope[door], door).toBeUndefined();
      expect(() => Object.assign(scope, { [door]: 1 }), door).toThrow(TypeError);
    }
    expect('fetch' in Scope.prototype).toBe(false);
  });
});
