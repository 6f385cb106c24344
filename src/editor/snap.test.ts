import { describe, expect, it } from 'vitest';
import { createRng } from '#core/rng';
import { alongEighths, gridMm, intoArena, isInArena, onGrid, snappedLine, snappedTo } from './snap';

const rules = { size: [1200, 900] as const, reachMm: 8, free: false };
const nothing = { ends: [], walls: [] };

describe('the grid', () => {
  it('attracts every 10 mm, as far as the reach', () => {
    expect(onGrid({ x: 104.9, y: 95.1 }, 8)).toEqual({ x: 100, y: 100 });
    expect(onGrid({ x: 104, y: 98 }, 3)).toEqual({ x: 104, y: 100 });
    expect(gridMm(107, 2)).toBe(107);
  });
});

describe('one of eight directions', () => {
  it('is the nearest to the way, and a diagonal is exactly one', () => {
    const rng = createRng(9);
    for (let run = 0; run < 500; run += 1) {
      const to = { x: (rng.unit() - 0.5) * 1000, y: (rng.unit() - 0.5) * 1000 };
      const { x, y } = alongEighths({ x: 0, y: 0 }, to);
      expect(x === 0 || y === 0 || Math.abs(Math.abs(x) - Math.abs(y)) < 1e-9).toBe(true);
      // cos 22.5° of the way at least: no other of the eight directions is nearer.
      expect((x * to.x + y * to.y) / Math.sqrt((x * x + y * y) * (to.x * to.x + to.y * to.y))).toBeGreaterThan(0.9238);
    }
  });
});

describe('a line', () => {
  it('keeps its direction where it is cut off at the edge of the arena', () => {
    expect(snappedLine({ x: 1000, y: 500 }, { x: 1190, y: 690 }, nothing, rules)).toMatchObject({ to: [1190, 690] });
    expect(snappedLine({ x: 1100, y: 500 }, { x: 1500, y: 840 }, nothing, rules).to).toEqual([1200, 600]);
  });

  it('has an end that can be moved alone', () => {
    expect(snappedTo([100, 100], { x: 402, y: 106 }, nothing, rules)).toEqual([400, 100]);
    expect(snappedTo([103, 100], { x: 402, y: 106 }, nothing, { ...rules, free: true })).toEqual([402, 106]);
    expect(snappedTo([100, 100], { x: 402, y: 106 }, { ends: [[398, 109]], walls: [] }, rules)).toEqual([398, 109]);
  });

  it('is attracted from 25 mm at most, also by a finger that reaches 70 mm', () => {
    const finger = { ...rules, reachMm: 70 };
    expect(snappedTo([100, 100], { x: 400, y: 100 }, { ends: [[424, 100]], walls: [] }, finger)).toEqual([424, 100]);
    expect(snappedTo([100, 100], { x: 400, y: 100 }, { ends: [[426, 100]], walls: [] }, finger)).toEqual([400, 100]);
  });

  it('does not snap to the end that it starts from', () => {
    expect(snappedTo([100, 100], { x: 106, y: 100 }, { ends: [[100, 100]], walls: [] }, rules)).toEqual([110, 100]);
  });
});

describe('the arena', () => {
  it('holds its edge, and what is kept inside', () => {
    expect(isInArena({ x: 1200, y: 0 }, [1200, 900])).toBe(true);
    expect(isInArena({ x: 1205, y: 0 }, [1200, 900])).toBe(false);
    expect(isInArena({ x: 1205, y: 0 }, [1200, 900], 8)).toBe(true);
    expect(intoArena({ x: 1e9, y: -3 }, [1200, 900])).toEqual({ x: 1200, y: 0 });
  });
});
