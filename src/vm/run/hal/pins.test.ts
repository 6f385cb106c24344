import { describe, expect, it } from 'vitest';
import { createHalBench } from '../testing/hal-bench';

describe('pin syscalls', () => {
  it('writes and reads levels, each for 5 µs', () => {
    const { bench, call, timed } = createHalBench();
    expect(timed('pin_write', 0, 1)).toEqual({ value: 0, us: 5 });
    expect(bench.board.wire('P0').level).toBe(1);
    expect(timed('pin_read', 1)).toEqual({ value: 0, us: 5 });
    bench.chip('P1').drive(1);
    expect(call('pin_read', 1)).toBe(1);
  });

  it('answers −1 for a pin that the display holds and −2 for a level that is none', () => {
    const { call } = createHalBench();
    expect(call('pin_write', 3, 1)).toBe(-1);
    expect(call('pin_read', 3)).toBe(-1);
    expect(call('pin_read_analog', 3)).toBe(-1);
    expect(call('pin_write', 0, 2)).toBe(-2);
    expect(call('pin_mode', 3)).toBe('display');
  });

  it('rounds broken analog values: 1023.4 is 1023, 1023.5 is too much', () => {
    const { bench, call } = createHalBench();
    expect(call('pin_write_analog', 0, 511.6)).toBe(0);
    expect(bench.board.wire('P0').pwm?.dutyFraction).toBeCloseTo(0.5, 3);
    expect(call('pin_write_analog', 0, 1023.4)).toBe(0);
    expect(call('pin_write_analog', 0, 1023.5)).toBe(-2);
    expect(call('pin_write_analog', 0, -1)).toBe(-2);
    expect(call('pin_write_analog', 0, 'a')).toBe(-3);
  });

  it('reads analog in 91 µs', () => {
    const { bench, timed } = createHalBench();
    bench.chip('P2').driveAnalog(0.5);
    expect(timed('pin_read_analog', 2)).toEqual({ value: 512, us: 91 });
  });

  it('tells the pull only while the pin is a digital input', () => {
    const { call } = createHalBench();
    expect(call('pin_pull', 0)).toBe(-1);
    expect(call('pin_set_pull', 0, 0)).toBe(0);
    expect([call('pin_pull', 0), call('pin_read', 0)]).toEqual([0, 1]);
    call('pin_set_pull', 0, 1);
    expect([call('pin_pull', 0), call('pin_read', 0)]).toEqual([1, 0]);
  });

  it('shares one PWM period and refuses 0 µs', () => {
    const { call } = createHalBench();
    expect(call('pin_period', 0)).toBe(-1);
    call('pin_write_analog', 0, 100);
    call('pin_write_analog', 1, 100);
    call('pin_set_period', 0, 1000);
    expect(call('pin_period', 1)).toBe(1000);
    call('pin_set_period', 0, 0);
    expect(call('pin_period', 1)).toBe(1000);
  });
});

describe('finger syscalls', () => {
  it('counts two presses of button A and none of B', () => {
    const { bench, call } = createHalBench();
    for (let i = 0; i < 2; i++) {
      bench.board.buttonA.press();
      bench.passMs(60);
      bench.board.buttonA.release();
      bench.passMs(60);
    }
    expect([call('button_was', 0), call('button_presses', 0), call('button_presses', 0)]).toEqual([true, 2, 0]);
    expect([call('button_is', 1), call('button_was', 1), call('button_presses', 1)]).toEqual([false, false, 0]);
  });

  it('feels the logo and answers None for a pad that plays music', () => {
    const { bench, call } = createHalBench();
    expect(call('touch_is', 30)).toBe(false);
    bench.board.touch.get('pin_logo')?.press();
    bench.passMs(60);
    expect(call('touch_is', 30)).toBe(true);
    call('music_pitch', 440, -1, 0);
    expect(call('touch_is', 0)).toBeNull();
    expect(call('touch_set_kind', 1, 1)).toBe(0);
  });
});

describe('ws2812_write', () => {
  it('sends the bytes after 125 µs and 10 µs a byte', () => {
    const { bench, put, timed } = createHalBench();
    const got: number[][] = [];
    bench.board.wire('P15').onStream((bytes) => got.push([...bytes, bench.clock.nowUs]));
    expect(timed('ws2812_write', 15, put([1, 2, 3]), 3).us).toBe(155);
    expect(got).toEqual([[1, 2, 3, 155]]);
  });
});
