import { describe, expect, it } from 'vitest';
import type { Vec } from '#core/geometry';
import { squaredDistance } from '#scene/outline';
import type { Point, Stroke } from '#scene/scene';
import { contextOf, course, drag, freely, newObjects, taps, used } from '../testing/desk';
import { penTool } from '../tools/pen-tool';
import type { Drag, PenShape } from '../tools/tool';

function drawn(penShape: PenShape, one: Drag): Stroke {
  const [object, ...more] = newObjects(course(), used(penTool, one, contextOf(course(), { penShape })));
  if (object?.type !== 'stroke' || more.length > 0) throw new Error('not one stroke');
  return object;
}

/** How far each place of a line, not only its points, is from a circle. */
function apartFromCircle(points: readonly Point[], centre: Vec, radiusMm: number): number {
  let most = 0;
  for (const [index, [x, y]] of points.entries()) {
    const [fromX, fromY] = points[index - 1] ?? [x, y];
    for (let share = 0; share <= 1; share += 0.1) {
      const [dx, dy] = [fromX + (x - fromX) * share - centre.x, fromY + (y - fromY) * share - centre.y];
      most = Math.max(most, Math.abs(Math.sqrt(dx * dx + dy * dy) - radiusMm));
    }
  }
  return most;
}

describe('pen by clicks', () => {
  it('draws from corner to corner and keeps no more points than clicks', () => {
    const { points } = drawn('corners', taps([100, 100], [300, 102], [300, 400], [500, 400]));
    expect(points).toEqual([
      [100, 100],
      [300, 100],
      [300, 400],
      [500, 400],
    ]);
  });

  it('goes on after each click, ends on the last corner and closes on the first', () => {
    const context = contextOf(course(), { penShape: 'corners' });
    expect(penTool.goesOn?.(drag([100, 100]), context)).toBe(true);
    expect(penTool.goesOn?.(taps([100, 100], [300, 100]), context)).toBe(true);
    expect(penTool.goesOn?.(taps([100, 100], [300, 100], [302, 103]), context)).toBe(false);
    expect(drawn('corners', taps([100, 100], [300, 100], [302, 103])).points).toHaveLength(2);
    const round = taps([100, 100], [300, 100], [300, 300], [103, 98]);
    expect(penTool.goesOn?.(round, context)).toBe(false);
    expect(drawn('corners', round).points).toEqual([
      [100, 100],
      [300, 100],
      [300, 300],
      [100, 100],
    ]);
  });

  it('rings the corners that end it', () => {
    const marks = penTool.marks?.(taps([100, 100], [300, 100], [300, 300], [200, 350]), contextOf(course(), { penShape: 'corners' }), false); // prettier-ignore
    expect(marks).toEqual([
      { type: 'snap', at: { x: 300, y: 300 } },
      { type: 'snap', at: { x: 100, y: 100 } },
    ]);
  });

  it('makes a dot of two clicks on one place', () => {
    expect(drawn('corners', taps([103, 98], [104, 99])).points).toHaveLength(1);
  });
});

describe('pen with arcs', () => {
  it('goes from the first click to the second through the third', () => {
    const { points } = drawn('arc', taps([400, 400], [600, 400], [500, 500]));
    expect([points[0], points[points.length - 1]]).toEqual([
      [400, 400],
      [600, 400],
    ]);
    expect(apartFromCircle(points, { x: 500, y: 400 }, 100)).toBeLessThan(0.5);
    expect(points.every(([, y]) => y >= 400)).toBe(true);
  });

  it('draws more than half of a circle, too', () => {
    const { points } = drawn('arc', taps([440, 320], [560, 320], [500, 500]));
    expect(apartFromCircle(points, { x: 500, y: 400 }, 100)).toBeLessThan(0.5);
    expect(points.some(([x]) => x <= 400)).toBe(true);
  });

  it('is done with one drag that bends', () => {
    const one = freely(drag([400, 400], [500, 500], [600, 400]));
    expect(penTool.goesOn?.(one, contextOf(course(), { penShape: 'arc' }))).toBe(false);
    expect(apartFromCircle(drawn('arc', one).points, { x: 500, y: 400 }, 100)).toBeLessThan(0.5);
  });

  it('waits for the bend after a straight drag, and after two clicks', () => {
    const context = contextOf(course(), { penShape: 'arc' });
    expect(penTool.goesOn?.(drag([400, 400], [600, 400]), context)).toBe(true);
    expect(penTool.goesOn?.(taps([400, 400], [600, 400]), context)).toBe(true);
    expect(penTool.goesOn?.(taps([400, 400], [600, 400], [500, 450]), context)).toBe(false);
  });

  it('is a straight line of two points when it does not bend', () => {
    expect(drawn('arc', taps([400, 400], [600, 400], [500, 400])).points).toHaveLength(2);
  });
});

describe('pen round a rectangle', () => {
  it('draws a circle of 100 mm radius that lies within half a millimetre, with few points, closed', () => {
    const { points } = drawn('circle', drag([400, 300], [600, 480]));
    expect(points[0]).toEqual(points[points.length - 1]);
    expect(apartFromCircle(points, { x: 500, y: 400 }, 100)).toBeLessThan(0.5);
    expect(points.length).toBeLessThan(70);
  });

  it('draws every circle of 20 to 500 mm within half a millimetre', () => {
    for (let radius = 20; radius <= 500; radius += 10) {
      const { points } = drawn('circle', drag([600 - radius, 500 - radius], [600 + radius, 500 + radius]));
      expect(apartFromCircle(points, { x: 600, y: 500 }, radius)).toBeLessThan(0.6);
    }
  });

  it('draws an oval as wide and as high as the drag, and with Shift a circle', () => {
    const one = drag([400, 300], [700, 400]);
    const extent = ({ points }: Stroke, at: 0 | 1): number =>
      Math.max(...points.map((point) => point[at])) - Math.min(...points.map((point) => point[at]));
    const oval = drawn('oval', one);
    expect([extent(oval, 0), extent(oval, 1)]).toEqual([300, 100]);
    const even = drawn('oval', { ...one, keeps: true });
    expect([extent(even, 0), extent(even, 1)]).toEqual([300, 300]);
  });

  it('draws from the middle with Alt', () => {
    const { points } = drawn('circle', { ...drag([500, 400], [600, 500]), alt: true });
    expect(apartFromCircle(points, { x: 500, y: 400 }, 100)).toBeLessThan(0.5);
  });

  it('rounds the corners of a rectangle with 100 mm, or a third of its shorter side', () => {
    const { points } = drawn('rounded', drag([200, 200], [800, 600]));
    expect(points).toContainEqual([700, 200]);
    expect(points).toContainEqual([800, 300]);
    expect(points[0]).toEqual(points[points.length - 1]);
    const onCorner = points.slice(0, -1).filter(([x, y]) => x >= 700 && y <= 300);
    expect(apartFromCircle(onCorner, { x: 700, y: 300 }, 100)).toBeLessThan(0.5);
    expect(drawn('rounded', drag([200, 200], [800, 290])).points).toContainEqual([770, 200]);
  });

  it('makes the same points whatever the direction of the drag', () => {
    expect(drawn('oval', drag([700, 400], [400, 300])).points).toEqual(drawn('oval', drag([400, 300], [700, 400])).points); // prettier-ignore
  });
});

describe('a curve in whole millimetres', () => {
  it('has no place of its pieces further than 0.5 mm from the curve, in all directions', () => {
    const { points } = drawn('oval', drag([100, 100], [1100, 800]));
    for (const [index, point] of points.entries()) {
      const before = points[index - 1] ?? point;
      const middle = { x: (before[0] + point[0]) / 2, y: (before[1] + point[1]) / 2 };
      const far = Math.sqrt(squaredDistance(middle, { x: before[0], y: before[1] }, { x: point[0], y: point[1] }));
      expect(far).toBeLessThan(0.5);
      const [x, y] = [(middle.x - 600) / 500, (middle.y - 450) / 350];
      expect(Math.abs(Math.sqrt(x * x + y * y) - 1) * 350).toBeLessThan(0.6);
    }
  });
});
