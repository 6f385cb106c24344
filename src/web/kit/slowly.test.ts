import { effectScope, shallowRef } from 'vue';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';

import { slowly } from './slowly';

describe('a number that is shown slowly', () => {
  beforeEach(() => void vi.useFakeTimers());
  afterEach(() => void vi.useRealTimers());

  it('shows the first value at once, then one every 100 ms at most, and the last one in any case', () => {
    const scope = effectScope();
    const source = shallowRef(0);
    const shown = scope.run(() => slowly(source))!;
    const seen = new Set<number>([shown.value]);
    for (let ms = 1; ms <= 1000; ms += 1) {
      source.value = ms;
      seen.add(shown.value);
      vi.advanceTimersByTime(1);
      seen.add(shown.value);
    }
    expect(seen.size).toBeLessThanOrEqual(12);
    vi.advanceTimersByTime(200);
    expect(shown.value).toBe(1000);
    scope.stop();
  });

  it('shows a value at once after a rest', () => {
    const scope = effectScope();
    const source = shallowRef('a');
    const shown = scope.run(() => slowly(source))!;
    vi.advanceTimersByTime(500);
    source.value = 'b';
    expect(shown.value).toBe('b');
    scope.stop();
  });
});
