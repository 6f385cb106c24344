import { describe, expect, it } from 'vitest';
import { createHalBench } from '../testing/hal-bench';

const [FIRST, SECOND, RESULT] = [0, 100, 200];

/** Two images of 3 × 2 pixels in memory, and what a call leaves in a third. */
function images() {
  const bench = createHalBench();
  bench.put([0, 1, 2, 7, 8, 9], FIRST);
  bench.put([5, 5, 5, 5, 5, 5], SECOND);
  return { ...bench, result: (count = 6) => [...bench.memory.subarray(RESULT, RESULT + count)] };
}

describe('image syscalls', () => {
  it('add and subtract within 0 and 9', () => {
    const { call, result } = images();
    call('image_sum', FIRST, SECOND, 6, 1, RESULT);
    expect(result()).toEqual([5, 6, 7, 9, 9, 9]);
    call('image_sum', FIRST, SECOND, 6, -1, RESULT);
    expect(result()).toEqual([0, 0, 0, 2, 3, 4]);
  });

  it('multiply, rounding half up, and leave rows beyond the width dark as v2.1.2 does', () => {
    const { call, result } = images();
    call('image_scale', FIRST, 3, 2, 0.5, RESULT);
    expect(result()).toEqual([0, 1, 1, 4, 4, 5]);
    call('image_scale', FIRST, 2, 3, 2, RESULT);
    expect(result()).toEqual([0, 2, 4, 9, 0, 0]);
  });

  it('copy a part: dark from outside the source, nothing outside the target', () => {
    const { call, put, result } = images();
    put([3, 3, 3, 3, 3, 3], RESULT);
    call('image_blit', FIRST, 3, 2, 1, 0, RESULT, 3, 2, 0, 0, 3, 1);
    expect(result()).toEqual([1, 2, 0, 3, 3, 3]);
  });

  it('read a picture from text and write it as text', () => {
    const { call, result } = images();
    expect(call('image_size', '90:1\n')).toBe((2 << 12) + 2);
    expect(call('image_parse', '90:1\n', RESULT, 2)).toBe(true);
    expect(result(4)).toEqual([9, 0, 1, 0]);
    expect(call('image_text', RESULT, 2, 2, '')).toBe('90:10:');
    expect(call('image_parse', '9x', RESULT, 2)).toBe(false);
  });

  it('cost more the larger the image is', () => {
    const { timed } = images();
    const small = timed('image_sum', FIRST, SECOND, 6, 1, RESULT).us;
    const large = timed('image_sum', FIRST, SECOND, 60, 1, RESULT).us;
    expect(large - small).toBeGreaterThan(50);
  });

  it('change nothing for sizes that no memory holds', () => {
    const { call, result } = images();
    call('image_blit', FIRST, 3, 2, 0, 0, RESULT, 2 ** 20, 2 ** 20, 0, 0, 3, 2);
    expect(result()).toEqual([0, 0, 0, 0, 0, 0]);
  });
});
