import { describe, expect, it } from 'vitest';
import type { HuskyResult } from '#devices/huskylens';
import { maqueenLite } from '#robots/maqueen-lite/type';
import { idealTraits } from '#robots/traits';
import { createReality } from './reality';

const spot = { x: 34, y: 7 };
const stopped = { left: 0, right: 0 };

/** A reality whose time stands still unless the test moves it. */
function realityAt(amount: number, seed: number) {
  const time = { us: 0 };
  return { time, reality: createReality(amount, seed, () => time.us) };
}

describe('reality 0', () => {
  it('changes nothing', () => {
    const { reality } = realityAt(0, 5);
    const hit = { distanceMm: 300, hitMm: { x: 1, y: 2 } };
    expect(reality.body(maqueenLite.body)).toBe(maqueenLite.body);
    expect(reality.supply({ left: 1, right: 1 })).toBe(1);
    expect(reality.reflectance(0.3, spot)).toBe(0.3);
    expect(reality.echo(hit)).toBe(hit);
    expect(reality.miss()).toBe(0);
    const seen: readonly HuskyResult[] = [{ kind: 'block', x: 160, y: 120, width: 75, height: 75, id: 5 }];
    expect(reality.seen(seen)).toBe(seen);
  });

  it('leaves a robot that was measured its motors, its battery and its ultrasonic sensor', () => {
    const motors = { ...idealTraits.motors, difference: 0.1, charge: 0.9 };
    const ultrasonic = { offsetMm: 20, scale: 1 };
    const reality = createReality(0, 5, () => 0, { ...idealTraits, motors, ultrasonic });
    expect(reality.body(maqueenLite.body).strength).toEqual([1.1, 0.9]);
    expect(reality.supply(stopped)).toBe(0.9);
    expect(reality.echo({ distanceMm: 300, hitMm: null }).distanceMm).toBe(320);
  });
});

describe('reality 1', () => {
  it('makes one motor 3 to 6 percent stronger and the other as much weaker, either one', () => {
    const lefts = Array.from({ length: 40 }, (_, seed) => {
      const [left, right] = realityAt(1, seed).reality.body(maqueenLite.body).strength!;
      expect(left + right).toBeCloseTo(2, 12);
      return left;
    });
    for (const left of lefts) expect(Math.abs(left - 1)).toBeGreaterThanOrEqual(0.03);
    for (const left of lefts) expect(Math.abs(left - 1)).toBeLessThanOrEqual(0.06);
    expect(lefts.some((left) => left > 1)).toBe(true);
    expect(lefts.some((left) => left < 1)).toBe(true);
  });

  it('is the same robot with the same seed', () => {
    expect(realityAt(1, 3).reality.body(maqueenLite.body)).toEqual(realityAt(1, 3).reality.body(maqueenLite.body));
  });

  it('lets the battery sag by 8 percent at full duty', () => {
    const { reality } = realityAt(1, 3);
    expect(reality.supply(stopped) - reality.supply({ left: 1, right: -1 })).toBeCloseTo(0.08, 12);
    expect(reality.supply(stopped)).toBeGreaterThan(0.88);
  });

  it('lets a line sensor tremble from step to step, by 0.14 at most, and not within a step', () => {
    const { reality, time } = realityAt(1, 3);
    const seen = new Set<number>();
    for (let step = 0; step < 200; step++) {
      time.us = step * 4000;
      const value = reality.reflectance(0.5, spot);
      time.us += 1999;
      expect(reality.reflectance(0.5, spot)).toBe(value);
      expect(Math.abs(value - 0.5)).toBeLessThanOrEqual(0.14);
      seen.add(value);
    }
    expect(seen.size).toBeGreaterThan(190);
    expect(reality.reflectance(1, spot)).toBeLessThanOrEqual(1);
    expect(reality.reflectance(0, spot)).toBeGreaterThanOrEqual(0);
  });

  it('lets measured moves miss their end by a standard deviation of 1, half of that at reality 0.5, by seed and moment', () => {
    const misses = (amount: number, seed: number) => {
      const { time, reality } = realityAt(amount, seed);
      return Array.from({ length: 2000 }, (_, step) => {
        time.us = step * 4000;
        return reality.miss();
      });
    };
    const all = misses(1, 3);
    const mean = all.reduce((sum, miss) => sum + miss, 0) / all.length;
    const deviation = Math.sqrt(all.reduce((sum, miss) => sum + (miss - mean) ** 2, 0) / all.length);
    expect(Math.abs(mean)).toBeLessThan(0.1);
    expect(Math.abs(deviation - 1)).toBeLessThan(0.05);
    expect(misses(1, 3)).toEqual(all);
    expect(misses(0.5, 3)).toEqual(all.map((miss) => miss / 2));
    expect(misses(1, 4).slice(0, 5)).not.toEqual(all.slice(0, 5));
  });

  it('lets what a camera finds tremble by 3 px at most, anew in each picture, and not within one', () => {
    const { reality, time } = realityAt(1, 3);
    const tag: HuskyResult = { kind: 'block', x: 160, y: 120, width: 75, height: 75, id: 5 };
    const places = new Set<string>();
    for (let picture = 0; picture < 60; picture++) {
      time.us = picture * 33_333;
      const [one] = reality.seen([tag]);
      time.us += 30_000;
      expect(reality.seen([tag])).toEqual([one]);
      if (one?.kind !== 'block') throw new Error('a block stays one');
      for (const [now, still] of [
        [one.x, 160],
        [one.y, 120],
        [one.width, 75],
        [one.height, 75],
      ] as const)
        // prettier-ignore
        expect(Math.abs(now - still)).toBeLessThanOrEqual(3);
      places.add([one.x, one.y, one.width, one.height].join());
    }
    expect(places.size).toBeGreaterThan(50);
  });

  it('keeps the ends of a line in the picture', () => {
    const { reality, time } = realityAt(1, 3);
    for (let picture = 0; picture < 60; picture++) {
      time.us = picture * 33_333;
      const [line] = reality.seen([{ kind: 'arrow', tail: [0, 239], head: [319, 0], id: 1 }]);
      if (line?.kind !== 'arrow') throw new Error('an arrow stays one');
      const [x, y] = [line.tail[0], line.head[0]];
      expect([x >= 0, x <= 3, y >= 316, y <= 319, line.tail[1] <= 239, line.head[1] >= 0]).not.toContain(false);
    }
  });

  it('misses about one echo in fifty, and the others are at most 7 mm wrong at 30 cm', () => {
    const { reality, time } = realityAt(1, 3);
    let missed = 0;
    for (let step = 0; step < 5000; step++) {
      time.us = step * 4000;
      const { distanceMm } = reality.echo({ distanceMm: 300, hitMm: { x: 0, y: 0 } });
      if (distanceMm === Infinity) missed++;
      else expect(Math.abs(distanceMm - 300)).toBeLessThanOrEqual(7);
    }
    expect(missed).toBeGreaterThan(60);
    expect(missed).toBeLessThan(140);
  });
});
