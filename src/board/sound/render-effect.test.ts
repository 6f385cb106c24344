import { describe, expect, it } from 'vitest';
import type { EffectPart } from './effect';
import { EFFECT_RATE, renderEffect } from './render-effect';

const PLAIN: EffectPart = {
  waveform: 3,
  startVolume: 1023,
  endVolume: 1023,
  startHz: 1000,
  endHz: 1000,
  durationMs: 500,
  shape: 1,
  steps: 128,
  fx: 0,
  fxParameter: 1,
  fxSteps: 24,
};

/** Cycles a second around a moment of an effect, counted by its rises through zero. */
function hzAt(samples: Float32Array, ms: number, widthMs = 20): number {
  const from = Math.max(0, Math.floor(((ms - widthMs / 2) * EFFECT_RATE) / 1000));
  const part = samples.subarray(from, from + Math.floor((widthMs * EFFECT_RATE) / 1000));
  let rises = 0;
  for (let i = 1; i < part.length; i++) if (part[i - 1]! < 0 && part[i]! >= 0) rises++;
  return Math.round((rises * 1000) / widthMs);
}

const peak = (samples: Float32Array): number => samples.reduce((most, sample) => Math.max(most, Math.abs(sample)), 0);

describe('synthesiser of effects', () => {
  it('makes 44,100 samples a second', () => {
    expect(renderEffect([PLAIN]).length).toBe(22_050);
    expect(renderEffect([PLAIN, { ...PLAIN, durationMs: 100 }]).length).toBe(26_460);
    expect(renderEffect([{ ...PLAIN, durationMs: 0 }]).length).toBe(0);
  });

  it('sounds 1000 Hz in every waveform but noise, within full scale', () => {
    for (const waveform of [0, 1, 2, 3]) {
      const samples = renderEffect([{ ...PLAIN, waveform }]);
      expect(Math.abs(hzAt(samples, 250, 100) - 1000)).toBeLessThanOrEqual(10);
      expect(peak(samples)).toBeLessThanOrEqual(1);
      expect(peak(samples)).toBeGreaterThan(0.98);
    }
  });

  it('makes noise of many values, the same every time', () => {
    const noise = renderEffect([{ ...PLAIN, waveform: 4 }]);
    expect(new Set(noise).size).toBeGreaterThan(200);
    expect(renderEffect([{ ...PLAIN, waveform: 4 }])).toEqual(noise);
  });

  it('glides in a line from 500 to 2500 Hz', () => {
    const samples = renderEffect([{ ...PLAIN, startHz: 500, endHz: 2500 }]);
    expect([50, 250, 450].map((ms) => hzAt(samples, ms))).toEqual([700, 1500, 2300]);
  });

  it('rises fast and then slowly with the logarithmic shape', () => {
    const samples = renderEffect([{ ...PLAIN, startHz: 500, endHz: 2500, shape: 18 }]);
    expect(hzAt(samples, 50)).toBeGreaterThan(1400);
    expect(Math.abs(hzAt(samples, 400) - 2550)).toBeLessThan(100);
  });

  it('bends with the curve and climbs a major scale with shape 8', () => {
    const curve = renderEffect([{ ...PLAIN, startHz: 500, endHz: 2500, shape: 2 }]);
    expect(Math.abs(hzAt(curve, 350) - 2500)).toBeLessThan(60);
    const scale = renderEffect([{ ...PLAIN, startHz: 400, shape: 8, steps: 8, durationMs: 800 }]);
    // The first notes of just intonation above 400 Hz.
    for (const [ms, hz] of [
      [50, 400],
      [150, 450],
      [250, 500],
      [350, 533],
    ] as const) {
      expect(Math.abs(hzAt(scale, ms, 80) - hz)).toBeLessThan(15);
    }
  });

  it('grows silent from volume 255 to 0', () => {
    const samples = renderEffect([{ ...PLAIN, endVolume: 0 }]);
    expect(peak(samples.subarray(0, 500))).toBeGreaterThan(0.97);
    expect(peak(samples.subarray(21_500))).toBeLessThan(0.06);
    expect(Math.abs(peak(samples.subarray(11_000, 11_100)) - 0.5)).toBeLessThan(0.04);
  });

  it('wavers between 1000 and 2000 Hz with a vibrato of 2', () => {
    const samples = renderEffect([{ ...PLAIN, shape: 0, fx: 1, fxParameter: 2, fxSteps: 200 }]);
    const heard = new Set(Array.from({ length: 9 }, (_, i) => Math.round(hzAt(samples, 25 + 50 * i, 30) / 100) * 100));
    expect([...heard].sort()).toEqual([1000, 2000]);
  });

  it('stays whole with extreme values', () => {
    const extreme = { ...PLAIN, startHz: 9999, endHz: 9999, steps: 9999, fx: 2, fxParameter: 9999, fxSteps: 9999 };
    for (const shape of [0, 1, 2, 5, 6, 8, 9, 14, 17, 18, 99]) {
      const samples = renderEffect([{ ...extreme, shape, durationMs: 50 }]);
      expect(samples.every((sample) => Number.isFinite(sample) && Math.abs(sample) <= 1)).toBe(true);
    }
  });
});
