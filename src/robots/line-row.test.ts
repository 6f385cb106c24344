import type { Vec } from '#core/geometry';
import { describe, expect, it } from 'vitest';
import { mountLineRow } from './line-row';
import type { LineReadings } from './traits';

const PLACES = [
  { name: 'left', atMm: { x: 40, y: 10 } },
  { name: 'right', atMm: { x: 40, y: -10 } },
] as const;
const MEASURE = { spotRadiusMm: 2.5, black: 100, floor: 230, most: 255 };

/** A row over a floor that is black where y > 0, half black after `step`. */
function mount(scale = 1, lineReadings: Readonly<Record<string, LineReadings>> = {}) {
  const asked: { spot: Vec; radiusMm: number }[] = [];
  let leftSees = 0;
  const ground = (spot: Vec, radiusMm: number): number => {
    asked.push({ spot, radiusMm });
    return spot.y > 0 ? leftSees : 1;
  };
  const row = mountLineRow({ ground, beforePaint: () => () => undefined, scale, lineReadings }, PLACES, MEASURE);
  return { row, asked, see: (reflectance: number) => void (leftSees = reflectance) };
}

describe('a row of line sensors', () => {
  it('reads 100 on black and 230 on bare floor, each sensor at its own place', () => {
    const { row } = mount();
    expect(row.states()).toEqual([
      { ...PLACES[0], bright: false, reading: 100 },
      { ...PLACES[1], bright: true, reading: 230 },
    ]);
  });

  it('reads no more than its register holds, however bright the silver', () => {
    const { row, see } = mount();
    see(1.4);
    row.sample();
    expect(row.states()[0]).toMatchObject({ bright: true, reading: 255 });
  });

  it('keeps what it saw until it looks again, then reads 165 half-way', () => {
    const { row, see } = mount();
    see(0.5);
    expect(row.reading('left')).toBe(100);
    row.sample();
    expect(row.reading('left')).toBe(165);
    expect(row.isBright('left')).toBe(false);
    see(0.6);
    row.sample();
    expect(row.isBright('left')).toBe(true);
  });

  it('reads what was measured of one sensor, which then is dark where the others are light', () => {
    const { row, see } = mount(1, { left: { black: 90, floor: 170 } });
    expect(row.reading('left')).toBe(90);
    see(0.75);
    row.sample();
    expect(row.reading('left')).toBe(150);
    expect(row.isBright('left')).toBe(false);
    expect(row.reading('right')).toBe(230);
  });

  it('looks twice as far ahead, at spots twice as wide, on a robot of scale 2', () => {
    expect(mount(2).asked).toEqual([
      { spot: { x: 80, y: 20 }, radiusMm: 5 },
      { spot: { x: 80, y: -20 }, radiusMm: 5 },
    ]);
  });
});
