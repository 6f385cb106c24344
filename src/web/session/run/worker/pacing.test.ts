import { describe, expect, it } from 'vitest';

import { createSpeedMeter, dueUs, nextPieceUs, withoutBacklog } from './pacing';

describe('pacing', () => {
  const anchor = { wallMs: 1000, simulatedUs: 500_000, speed: 2 } as const;

  it('lets 20 ms of simulated time pass in 10 ms at double speed', () => {
    expect(dueUs(anchor, 1010)).toBe(520_000);
  });

  it('lets a quarter of the time pass at a quarter of the speed', () => {
    expect(dueUs({ ...anchor, speed: 0.25 }, 1100)).toBe(525_000);
  });

  it('knows no limit at full speed', () => {
    expect(dueUs({ ...anchor, speed: 'max' }, 1001)).toBe(Infinity);
  });

  it('never lets time run backwards when the clock does', () => {
    expect(dueUs(anchor, 900)).toBe(500_000);
    expect(dueUs(anchor, 1000.0137)).toBe(500_027); // whole µs: the wall clock does not affect when a line begins
  });

  it('catches up after 100 ms of delay, but not after 101', () => {
    expect(withoutBacklog(anchor, 1100, 500_000)).toBe(anchor);
    expect(withoutBacklog(anchor, 1101, 500_000)).toEqual({ wallMs: 1101, simulatedUs: 500_000, speed: 2 });
  });

  it('asks for pieces of simulated time that take about a millisecond: between 4 and 64 ms', () => {
    expect(nextPieceUs(16_000, 0.1)).toBe(32_000);
    expect(nextPieceUs(64_000, 0.1)).toBe(64_000);
    expect(nextPieceUs(16_000, 1)).toBe(16_000);
    expect(nextPieceUs(16_000, 5)).toBe(8000);
    expect(nextPieceUs(4000, 50)).toBe(4000);
  });
});

describe('the speed meter', () => {
  it('says nothing before a quarter of a second has passed', () => {
    const meter = createSpeedMeter();
    meter.note(0, 0);
    meter.note(200, 200_000);
    expect(meter.factor()).toBeNull();
  });

  it('shows 0.6 when 600 ms were simulated in a second', () => {
    const meter = createSpeedMeter();
    for (let ms = 0; ms <= 1000; ms += 10) meter.note(ms, ms * 600);
    expect(meter.factor()).toBeCloseTo(0.6);
  });

  it('forgets what was more than about a second ago', () => {
    const meter = createSpeedMeter();
    for (let ms = 0; ms <= 2000; ms += 50) meter.note(ms, ms * 1000);
    for (let ms = 2050; ms <= 4000; ms += 50) meter.note(ms, 2_000_000 + (ms - 2000) * 4000);
    expect(meter.factor()).toBeCloseTo(4);
  });
});
