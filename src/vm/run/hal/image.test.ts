import { describe, expect, it } from 'vitest';
import { createHalBench } from '../testing/hal-bench';

const [FIRST, SECOND, RESULT] = [0, 1000, 2000];

/** The bytes of an image. */
const image = (width: number, height: number, pixels: readonly number[]): number[] => [
  ...[width & 0xff, width >> 8, height & 0xff, height >> 8, 0],
  ...pixels,
];

/** Two images of 3 × 2 pixels in memory, and what a call leaves in a third. */
function images() {
  const bench = createHalBench();
  bench.put(image(3, 2, [0, 1, 2, 7, 8, 9]), FIRST);
  bench.put(image(3, 2, [5, 5, 5, 5, 5, 5]), SECOND);
  return { ...bench, result: (count = 6) => [...bench.memory.subarray(RESULT + 5, RESULT + 5 + count)] };
}

describe('image syscalls', () => {
  it('add and subtract within 0 and 9, images of the same size alone', () => {
    const { call, put, result } = images();
    expect(call('image_sum', FIRST, SECOND, 1, RESULT)).toBe(true);
    expect(result()).toEqual([5, 6, 7, 9, 9, 9]);
    call('image_sum', FIRST, SECOND, -1, RESULT);
    expect(result()).toEqual([0, 0, 0, 2, 3, 4]);
    put(image(2, 3, [5, 5, 5, 5, 5, 5]), SECOND);
    expect(call('image_sum', FIRST, SECOND, 1, RESULT)).toBe(false);
  });

  it('multiply, rounding half up, and leave rows beyond the width dark as v2.1.2 does', () => {
    const { call, put, result } = images();
    call('image_scale', FIRST, 0.5, RESULT);
    expect(result()).toEqual([0, 1, 1, 4, 4, 5]);
    put(image(2, 3, [0, 1, 2, 7, 8, 9]), FIRST);
    call('image_scale', FIRST, 2, RESULT);
    expect(result()).toEqual([0, 2, 4, 9, 0, 0]);
  });

  it('copy a part: dark from outside the source, nothing outside the target', () => {
    const { call, put, result } = images();
    put(image(3, 2, [3, 3, 3, 3, 3, 3]), RESULT);
    call('image_blit', FIRST, 1, 0, RESULT, 0, 0, 3, 1);
    expect(result()).toEqual([1, 2, 0, 3, 3, 3]);
    call('image_crop', FIRST, 1, 1, 2, 2, RESULT);
    expect(result(4)).toEqual([8, 9, 0, 0]);
  });

  it('read a picture from text and write it as text', () => {
    const { call, result } = images();
    expect(call('image_size', '90:1\n')).toBe((2 << 12) + 2);
    expect(call('image_parse', RESULT)).toBe(true);
    expect(result(4)).toEqual([9, 0, 1, 0]);
    expect(call('image_text', RESULT, false)).toBe("Image('90:10:')");
    expect(call('image_text', RESULT, true)).toBe("Image(\n    '90:'\n    '10:'\n)");
    call('image_size', '9x');
    expect(call('image_parse', RESULT)).toBe(false);
  });

  it('set and tell a pixel, and say −1 at a wrong place or brightness', () => {
    const { call } = images();
    expect(call('image_set', FIRST, 2, 1, 4)).toBe(0);
    expect(call('image_pixel', FIRST, 2, 1)).toBe(4);
    expect(call('image_set', FIRST, 3, 1, 4)).toBe(-1);
    expect(call('image_set', FIRST, 2, 1, 10)).toBe(-1);
    expect(call('image_pixel', FIRST, 0, 2)).toBe(-1);
  });

  it('leave a built-in image as it is', () => {
    const { call, result } = images();
    call('image_unpack', Number.parseInt('avve4', 32), RESULT);
    expect(result(5)).toEqual([0, 9, 0, 9, 0]);
    expect(call('image_set', RESULT, 0, 0, 4)).toBe(-1);
    expect(call('image_fill', RESULT, 4)).toBe(-1);
    expect(result(5)).toEqual([0, 9, 0, 9, 0]);
    call('image_copy', RESULT, FIRST);
    expect(call('image_fill', FIRST, 4)).toBe(0);
  });

  it('cost more the larger the image is', () => {
    const { timed, put } = images();
    const small = timed('image_invert', FIRST, RESULT).us;
    put(image(60, 1, []), FIRST);
    expect(timed('image_invert', FIRST, RESULT).us - small).toBeGreaterThanOrEqual(50);
  });

  it('change nothing for sizes that no memory holds', () => {
    const { call, put, result } = images();
    put(image(65_535, 65_535, []), RESULT);
    call('image_blit', FIRST, 0, 0, RESULT, 0, 0, 3, 2);
    expect(result()).toEqual([0, 0, 0, 0, 0, 0]);
  });
});
