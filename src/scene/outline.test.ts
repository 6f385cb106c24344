import { createRng } from '#core/rng';
import type { Vec } from '#core/geometry';
import { describe, expect, it } from 'vitest';
import { boundsOf, reachesInto, solidParts } from './kinds/index';
import { legOutlines } from './kinds/mover';
import { zoneHolds, zoneOverlaps } from './kinds/zone';
import { boxOutline, convexHull, overlapMm, type Outline } from './outline';
import type { Mover, Point, SceneObject, Stroke, Zone } from './scene';

const zone = (change: Partial<Zone> = {}): Zone => ({
  ...{ type: 'target', id: 'z', at: [100, 100], size: [80, 40], angle: 0, round: false, number: 0, blocks: 0 },
  ...change,
});
const mover: Mover = {
  ...{ type: 'mover', id: 'm', at: [100, 100], to: [300, 100], size: [40, 20], angle: 90, speed: 100, spiked: false },
};
const stroke = (points: readonly Point[], width = 20): Stroke => ({
  ...{ type: 'stroke', id: 's', points, width, color: 'black' },
});
const square = (x: number, y: number, half: number): Outline =>
  boxOutline({ at: [x, y], size: [2 * half, 2 * half], angle: 0 });
const rounded = (outline: Outline = []): readonly (readonly [number, number])[] =>
  outline.map(({ x, y }) => [Number(x.toFixed(3)), Number(y.toFixed(3))]);

describe('the solid outline', () => {
  it('is a wall’s centre line with half its thickness to each side', () => {
    expect(rounded(...solidParts({ type: 'wall', id: 'w', from: [0, 50], to: [100, 50], thickness: 10 }))).toEqual([
      [0, 45],
      [100, 45],
      [100, 55],
      [0, 55],
    ]);
  });

  it('is the box of blocks, spikes and movers, exact to the bit when turned by quarters', () => {
    for (const type of ['block', 'fixed-block', 'spikes'] as const)
      expect(solidParts({ type, id: 'b', at: [100, 100], size: [40, 20], angle: 90 })).toEqual([
        [
          { x: 110, y: 80 },
          { x: 110, y: 120 },
          { x: 90, y: 120 },
          { x: 90, y: 80 },
        ],
      ]);
    expect(solidParts(mover)[0]).toHaveLength(4);
    expect(rounded(boxOutline({ at: [0, 0], size: [20, 20], angle: 45 }))[2]).toEqual([0, 14.142]);
  });

  it('is none for what lies flat on the floor', () => {
    const flat: readonly SceneObject[] = [
      stroke([[1, 1]]),
      zone(),
      { type: 'label', id: 'l', at: [0, 0], text: 'a', height: 30, angle: 0 },
    ];
    expect(flat.map(solidParts)).toEqual([[], [], []]);
  });

  it('reaches from end to end of a mover’s path', () => {
    expect(boundsOf(mover)).toEqual({ minX: 90, maxX: 310, minY: 80, maxY: 120 });
    expect(legOutlines(mover)[0]).toHaveLength(4);
    expect(legOutlines({ ...mover, to: [300, 200] })[0]).toHaveLength(6);
  });
});

describe('a zone', () => {
  it('holds what lies in it or on its edge', () => {
    const places: readonly Vec[] = [
      { x: 140, y: 120 },
      { x: 140.1, y: 100 },
      { x: 100, y: 119 },
      { x: 60, y: 80 },
      { x: 100, y: 120.1 },
    ];
    expect(places.map((place) => zoneHolds(zone(), place))).toEqual([true, false, true, true, false]);
  });

  it('does not hold its corners if it is round', () => {
    const round = zone({ round: true });
    expect(zoneHolds(round, { x: 140, y: 100 })).toBe(true);
    expect(zoneHolds(round, { x: 100, y: 120 })).toBe(true);
    expect(zoneHolds(round, { x: 128, y: 114 })).toBe(true); // 0.7² + 0.7² = 0.98
    expect(zoneHolds(round, { x: 129, y: 115 })).toBe(false); // 0.725² + 0.75² = 1.09
  });

  it('is turned to the left by an eighth', () => {
    const turned = zone({ angle: 45 });
    expect(zoneHolds(turned, { x: 126, y: 126 })).toBe(true);
    expect(zoneHolds(turned, { x: 126, y: 74 })).toBe(false);
  });

  it('holds the corners of a block of exactly its size, however both are turned', () => {
    for (let angle = 0; angle < 360; angle += 7.5)
      expect(
        boxOutline({ at: [100, 100], size: [80, 40], angle }).every((corner) => zoneHolds(zone({ angle }), corner)),
      ).toBe(true);
  });

  it('is overlapped by a body that covers a part of it, not by one that only touches it', () => {
    expect(zoneOverlaps(zone(), square(150, 100, 10))).toBe(false);
    expect(zoneOverlaps(zone(), square(149, 100, 10))).toBe(true);
    expect(zoneOverlaps(zone(), square(100, 100, 1))).toBe(true);
    expect(zoneOverlaps(zone(), square(100, 100, 500))).toBe(true);
  });

  it('is overlapped as random places in body and zone say if it is round', () => {
    const rng = createRng(5);
    const between = (min: number, max: number): number => min + rng.unit() * (max - min);
    let overlapping = 0;
    for (let round = 0; round < 400; round++) {
      const ellipse = zone({
        round: true,
        angle: (rng.u32() % 3600) / 10,
        size: [20 + (rng.u32() % 100), 20 + (rng.u32() % 100)],
      });
      const body: Outline = convexHull(Array.from({ length: 5 }, () => ({ x: between(20, 180), y: between(20, 180) })));
      const inBoth = Array.from({ length: 4000 }, () => ({ x: between(20, 180), y: between(20, 180) })).filter(
        (place) => zoneHolds(ellipse, place) && overlapMm([place], body) > 0,
      );
      const overlaps = zoneOverlaps(ellipse, body);
      if (inBoth.length > 0) expect(overlaps).toBe(true);
      if (overlaps) overlapping++;
      else expect(inBoth).toEqual([]);
    }
    expect(overlapping).toBeGreaterThan(100);
    expect(overlapping).toBeLessThan(395);
  });
});

describe('the bounds', () => {
  it('hold the width of a stroke', () => {
    expect(
      boundsOf(
        stroke([
          [10, 20],
          [110, 70],
        ]),
      ),
    ).toEqual({ minX: 0, minY: 10, maxX: 120, maxY: 80 });
  });

  it('are those of the ellipse of a round zone, not of its box', () => {
    const { minX, maxX, minY } = boundsOf(zone({ round: true, size: [100, 100], angle: 45 }));
    expect([minX, maxX, minY].map((mm) => Number(mm.toFixed(6)))).toEqual([50, 150, 50]);
  });

  it('grow with the text of a label', () => {
    const width = (text: string): number => {
      const { minX, maxX } = boundsOf({ type: 'label', id: 'l', at: [0, 0], text, height: 30, angle: 0 });
      return maxX - minX;
    };
    expect(width('Ziel')).toBeCloseTo(4 * 24);
    expect(width('Startplatz')).toBeCloseTo(10 * 24);
  });
});

describe('an object reaches into the arena', () => {
  const arena: Point = [1000, 800];
  const table: readonly [what: string, object: SceneObject, reaches: boolean][] = [
    ['a block half inside', { type: 'block', id: 'b', at: [1010, 400], size: [50, 50], angle: 0 }, true],
    ['a block beside it', { type: 'block', id: 'b', at: [1025, 400], size: [50, 50], angle: 0 }, false],
    [
      'a turned block whose corner reaches in',
      { type: 'block', id: 'b', at: [1030, 400], size: [50, 50], angle: 45 },
      true,
    ],
    [
      'a wall across a corner outside',
      { type: 'wall', id: 'w', from: [-200, 100], to: [100, -200], thickness: 10 },
      false,
    ],
    [
      'a wall across the whole arena',
      { type: 'wall', id: 'w', from: [-200, 100], to: [1200, 100], thickness: 10 },
      true,
    ],
    [
      'a line outside with its edge inside',
      stroke([
        [-9, 100],
        [-9, 200],
      ]),
      true,
    ],
    [
      'a line outside',
      stroke([
        [-10, 100],
        [-10, 200],
      ]),
      false,
    ],
    [
      'a line that passes from outside to outside',
      stroke([
        [-100, 100],
        [1100, 200],
      ]),
      true,
    ],
    ['a dot outside', stroke([[500, 811]]), false],
    ['a mover that comes in', { ...mover, at: [-100, 100], to: [100, 100] }, true],
    ['a mover that stays outside', { ...mover, at: [-100, 100], to: [-100, 500] }, false],
    ['a round zone at the corner', zone({ at: [1030, 830], size: [80, 80], round: true }), false],
    ['a square zone at the corner', zone({ at: [1030, 830], size: [80, 80] }), true],
    ['a label above it', { type: 'label', id: 'l', at: [500, 830], text: 'x', height: 30, angle: 0 }, false],
  ];
  it.each(table)('%s', (_what, object, reaches) => expect(reachesInto(object, arena)).toBe(reaches));
});
