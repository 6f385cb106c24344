import { describe, expect, it } from 'vitest';
import { createHalBench } from '../testing/hal-bench';

const HEART = Number.parseInt('avve4', 32);
/** Address of the heart in memory. */
const AT = 1000;

/** The board on the table, with the built-in heart in memory. */
function withHeart() {
  const bench = createHalBench();
  bench.call('image_unpack', HEART, AT);
  return bench;
}

describe('display syscalls', () => {
  it('shows a built-in picture', () => {
    const { bench, call } = withHeart();
    call('display_show_image', AT);
    expect(bench.picture()).toBe('.9.9.\n99999\n99999\n.999.\n..9..');
  });

  it('cuts a picture of 6 × 2 to the display and leaves the rest dark', () => {
    const { bench, call, put } = createHalBench();
    call('display_show_image', put([6, 0, 2, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 0, 1, 2]));
    expect([...bench.board.display.pixels.subarray(0, 12)]).toEqual([1, 2, 3, 4, 5, 7, 8, 9, 0, 1, 0, 0]);
  });

  it('shows one character at once and moves for two', () => {
    const { call } = createHalBench();
    expect(call('display_show_text', 'A', 400, false, false)).toBe(false);
    expect(call('display_show_text', 'AB', 400, false, false)).toBe(true);
    expect(call('display_show_text', '', 400, false, false)).toBe(false);
  });

  it('waits 804 ms for two characters of 400 ms on the 6 ms tick', () => {
    const { call, bench } = createHalBench();
    call('display_show_text', 'AB', 400, false, false);
    expect(call('display_wait')).toBe(null);
    expect(bench.nowMs).toBe(804);
  });

  it('shows a sequence put together piece by piece', () => {
    const { bench, call, put } = withHeart();
    call('display_begin');
    call('display_add_image', AT);
    call('display_add_image', put([1, 0, 1, 0, 0, 9]));
    call('display_add_text', 'I');
    expect(call('display_run', 100, false, true)).toBe(true);
    expect(call('display_wait')).toBe(null);
    expect(bench.picture()).toBe('.....\n.....\n.....\n.....\n.....');
  });

  it('ends what moves when the wait is cut short by a Ctrl-C', () => {
    const { bench, call, interrupted } = withHeart();
    call('display_scroll', 'hello', 150, false, false);
    expect(interrupted(1000, 'display_wait')).toBe(null);
    const picture = bench.picture();
    bench.passMs(1000);
    expect(bench.picture()).toBe(picture);
  });

  it('checks places and brightness', () => {
    const { call } = createHalBench();
    expect(call('display_set_pixel', 5, 0, 1)).toBe(-1);
    expect(call('display_set_pixel', 0, 0, 10)).toBe(-2);
    expect(call('display_set_pixel', 1, 2, 7)).toBe(0);
    expect(call('display_get_pixel', 1, 2)).toBe(7);
    expect(call('display_get_pixel', 0, -1)).toBe(-1);
  });

  it('gives its pins away while it is off', () => {
    const { call } = createHalBench();
    call('display_off');
    expect([call('display_is_on'), call('pin_read', 3)]).toEqual([false, 0]);
    expect(call('display_on')).toBeNull();
    expect(call('pin_read', 3)).toBe(-1);
    call('display_off');
    call('music_pitch', 440, -1, 3);
    expect(call('display_on')).toBe('Pin 3 in music mode');
  });
});
