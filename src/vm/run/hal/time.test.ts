import { describe, expect, it } from 'vitest';
import { createHalBench, type HalBench } from '../testing/hal-bench';

describe('time syscalls', () => {
  it('wraps ticks at 2³⁰', () => {
    const { bench, call } = createHalBench();
    bench.passUs(2 ** 30);
    expect(call('ticks_us')).toBe(5);
    expect(call('ticks_ms')).toBe(Math.floor((2 ** 30 + 10) / 1000));
    expect(call('running_time')).toBe(1_073_741);
  });

  it('sleeps whole milliseconds and at once returns from a negative time', () => {
    const { timed } = createHalBench();
    expect(timed('sleep_ms', 10.9)).toEqual({ value: 0, us: 10_005 });
    expect(timed('sleep_s', 0.01)).toEqual({ value: 0, us: 10_005 });
    expect(timed('sleep_us', 500)).toEqual({ value: null, us: 505 });
    expect(timed('sleep_us', 5000)).toEqual({ value: null, us: 5005 });
    expect(timed('sleep_ms', -3)).toEqual({ value: -1, us: 5 });
    expect(timed('sleep_ms', 'a')).toEqual({ value: -1, us: 5 });
  });

  it('sleeps on to the same moment after a callback, also beyond 32 bits of µs', () => {
    const { bench, call, interrupted } = createHalBench();
    bench.passUs(2 ** 32);
    const moment = interrupted(4000, 'sleep_ms', 10);
    expect(moment).toBe(String(2 ** 32 + 10_005));
    expect(call('sleep_until', moment)).toBe(0);
    expect(bench.clock.nowUs).toBe(2 ** 32 + 10_005);
  });
});

describe('run_every', () => {
  it('queues its callback on the 6 ms grid: every 20 ms means after 24, 42, 60 ms', () => {
    const { bench, call, queued } = createHalBench();
    call('run_every', 3, 0, 20);
    bench.passMs(23);
    expect(queued).toEqual([]);
    bench.passMs(1);
    expect(queued).toEqual([3]);
    bench.passMs(36);
    expect(queued).toEqual([3, 3, 3]);
  });

  it('rests while interrupts are off and ends with run_every_stop', () => {
    const { bench, call, queued } = createHalBench();
    call('run_every', 0, 0, 6);
    expect(call('set_irq', false)).toBe(true);
    bench.passMs(30);
    expect(queued).toEqual([]);
    expect(call('set_irq', true)).toBe(false);
    bench.passMs(6);
    call('run_every_stop');
    bench.passMs(100);
    expect(queued).toEqual([0]);
  });
});

/** A wire goes high at `atUs` and low again after `lengthUs`. */
const withPulse = (atUs: number, lengthUs: number, wire = 'P1'): HalBench => {
  const hal = createHalBench();
  const chip = hal.bench.chip(wire);
  chip.drive(0);
  hal.bench.clock.at(atUs, () => chip.drive(1));
  hal.bench.clock.at(atUs + lengthUs, () => chip.drive(0));
  return hal;
};

describe('pulse', () => {
  it('measures a pulse of 583 µs exactly', () => {
    const { bench, call } = withPulse(1000, 583);
    expect(call('pulse', 1, true, 30_000)).toBe(583);
    expect(bench.clock.nowUs).toBe(1583);
  });

  it('counts a level that is there already from now on', () => {
    const { bench, call } = withPulse(0, 1000);
    bench.passUs(100);
    expect(call('pulse', 1, true, 30_000)).toBe(1000 - 105);
  });

  it('gives −2 when nothing came for the time-out, −1 when it did not end', () => {
    const early = withPulse(5000, 100);
    expect(early.timed('pulse', 1, true, 2000)).toEqual({ value: -2, us: 2005 });
    const long = withPulse(1000, 5000);
    expect(long.timed('pulse', 1, true, 2000)).toEqual({ value: -1, us: 3000 });
  });

  it('starts the time-out anew when the pulse begins', () => {
    const { call } = withPulse(1900, 1900);
    expect(call('pulse', 1, true, 2000)).toBe(1900);
  });

  it('measures on a pin that something holds', () => {
    const { call } = withPulse(1000, 583, 'P3');
    expect(call('pulse', 3, true, 5000)).toBe(583);
    expect(call('pin_mode', 3)).toBe('display');
  });
});
