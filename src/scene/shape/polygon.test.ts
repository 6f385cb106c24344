import { describe, expect, it } from 'vitest';
import { exactCos, exactSin } from '#core/exact-math';
import { zoneHolds, zoneOverlaps } from '../kinds/zone';
import { overlapMm, type Outline } from '../outline';
import { stuckBlocks } from '../overlaps';
import type { Block, Point, Zone } from '../scene';
import { forManySeeds, wholeFrom } from '../testing/fuzz';
import { areaOf } from './polygon';
import { polygonFault } from './polygon-fault';
import { ownOutline, ownParts, shapeParts } from './shape';

/** An L: the square of 100 mm without its upper right quarter. */
const ELL: readonly Point[] = [[0, 0], [100, 0], [100, 50], [50, 50], [50, 100], [0, 100]]; // prettier-ignore
const areaMm2 = (outline: Outline): number => areaOf(outline.map(({ x, y }): Point => [x, y]));

describe('a polygon', () => {
  it('falls into convex parts that are as large together as it is, and lie beside each other', () => {
    forManySeeds(300, (rng) => {
      const count = wholeFrom(rng, 3, 40);
      const corners = Array.from({ length: count }, (_, index): Point => {
        const [far, rad] = [wholeFrom(rng, 100, 400), (index * 2 * Math.PI) / count];
        return [Math.round(far * exactCos(rad)), Math.round(far * exactSin(rad))];
      });
      if (polygonFault(corners)) return;
      const shape = { size: [300, 200] as Point, corners };
      const parts = ownParts(shape);
      const sum = parts.reduce((all, part) => all + areaMm2(part), 0);
      if (Math.abs(sum - areaMm2(ownOutline(shape))) > 60) throw new Error(JSON.stringify(corners));
      for (const [index, one] of parts.entries())
        for (const other of parts.slice(index + 1))
          if (overlapMm(one, other) > 1e-6) throw new Error(`overlap: ${JSON.stringify(corners)}`);
    });
  });

  it('is the same whichever way round its corners go, and wherever its figure lies', () => {
    const shape = { size: [100, 100] as Point, corners: ELL };
    const other = { ...shape, corners: ELL.map(([x, y]): Point => [3 * x - 7, 3 * y + 9]).reverse() };
    const sorted = (outline: Outline) => outline.map(({ x, y }) => `${x.toFixed(9)} ${y.toFixed(9)}`).sort();
    expect(sorted(ownOutline(other))).toEqual(sorted(ownOutline(shape)));
    expect(ownParts(shape)).toHaveLength(2);
  });

  it('holds what lies in it as a zone, not what lies in its hollow', () => {
    const zone: Zone = { type: 'target', id: 't', at: [100, 100], size: [100, 100], angle: 0, round: false, corners: ELL, number: 0, blocks: 0 }; // prettier-ignore
    const at = (x: number, y: number, angle = 0) => zoneHolds({ ...zone, angle }, { x, y });
    expect([at(75, 75), at(125, 125), at(100, 120), at(101, 120)]).toEqual([true, false, true, false]);
    expect([at(75, 75, 90), at(75, 125, 90), at(125, 125, 90)]).toEqual([true, false, true]);
    const spot = (x: number, y: number): Outline => [{ x, y }, { x: x + 5, y }, { x, y: y + 5 }]; // prettier-ignore
    expect([zoneOverlaps(zone, spot(110, 110)), zoneOverlaps(zone, spot(96, 110))]).toEqual([false, true]);
  });

  it('has room as a block in the hollow of another, and for a round one beside a corner', () => {
    const block = (id: string, at: Point, more: Partial<Block> = {}): Block => ({
      ...{ type: 'block', id, at, size: [40, 40], angle: 0, ...more },
    });
    const ell = block('l', [100, 100], { size: [100, 100], corners: ELL });
    expect(stuckBlocks([ell, block('b', [125, 125])])).toEqual([]);
    expect(stuckBlocks([ell, block('b', [110, 110])])).toHaveLength(1);
    expect(stuckBlocks([block('a', [0, 0]), block('b', [36, 36])])).toHaveLength(1);
    expect(stuckBlocks([block('a', [0, 0]), block('b', [36, 36], { round: true })])).toEqual([]);
  });

  it('has its parts in the world where it is turned to', () => {
    const [part] = shapeParts({ at: [100, 100], size: [60, 60], angle: 90, corners: [[0, 0], [2, 0], [1, 2]] }); // prettier-ignore
    expect(part?.map(({ x, y }) => [Math.round(x), Math.round(y)]).sort()).toEqual([[130, 130], [130, 70], [70, 100]]); // prettier-ignore
  });
});
