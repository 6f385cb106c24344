import { describe, expect, it } from 'vitest';
import type { Vec } from '#core/geometry';
import { exactCos, exactSin } from '#core/exact-math';
import { createRng } from '#core/rng';
import { squaredDistance } from '#scene/outline';
import { sceneLimits, type Point, type Scene, type Stroke } from '#scene/scene';
import { penTool } from './pen-tool';
import { contextOf, course, drag, freely, newObjects, stroke, used } from '../testing/desk';
import { walk } from '../testing/random-course';
import type { Drag, ToolOptions } from './tool';

function drawn(one: Drag, options: Partial<ToolOptions> = {}, scene: Scene = course()): Stroke {
  const [object, ...more] = newObjects(scene, used(penTool, one, contextOf(scene, options)));
  if (object?.type !== 'stroke' || more.length > 0) throw new Error('not one stroke');
  return object;
}

const along = (path: readonly Vec[]): Drag => ({ ...drag(), path });

/** How far a place is from a line in mm. */
const farFrom = ({ x, y }: Vec, points: readonly Point[]): number =>
  Math.sqrt(
    Math.min(
      ...points.map(([toX, toY], index) => {
        const [fromX, fromY] = points[index - 1] ?? [toX, toY];
        return squaredDistance({ x, y }, { x: fromX, y: fromY }, { x: toX, y: toY });
      }),
    ),
  );

const circle = (radius: number, places: number): readonly Vec[] =>
  Array.from({ length: places }, (_, i) => {
    const angle = (i * 2 * Math.PI) / places;
    return { x: 600 + radius * exactCos(angle), y: 450 + radius * exactSin(angle) };
  });

describe('pen', () => {
  it('draws a line of the chosen width and colour', () => {
    expect(drawn(drag([100, 100], [200, 100], [200, 300]), { penWidth: 15, penColor: 'red' })).toEqual({
      type: 'stroke',
      id: 'stroke-1',
      points: [
        [100, 100],
        [200, 100],
        [200, 300],
      ],
      width: 15,
      color: 'red',
    });
  });

  it('makes a dot where it is tapped', () => {
    expect(drawn(drag([103, 98])).points).toEqual([[103, 98]]);
    expect(drawn(drag([103, 98], [104, 99], [103, 97])).points).toEqual([[103, 98]]);
  });

  it('leaves no gap, however fast it scribbles: no place of 20,000 is farther than 2 mm from the line', () => {
    const path = walk(createRng(1), { x: 600, y: 450 }, 20_000, 25).map(({ x, y }) => ({
      x: Math.abs(x % 1200),
      y: Math.abs(y % 900),
    }));
    const { points } = drawn(freely(along(path)));
    expect(points.length).toBeLessThan(20_000);
    for (let i = 0; i < path.length; i += 97) expect(farFrom(path[i]!, points)).toBeLessThan(2);
  });

  it('needs few points for a straight line drawn with 500 places', () => {
    const path = Array.from({ length: 500 }, (_, i) => ({ x: 100 + i, y: 300 + 0.4 * (i % 2) }));
    expect(drawn(along(path)).points).toHaveLength(2);
  });

  it('does not keep the tremble of a finger, and stays within 2 mm and the rounding of where it went', () => {
    const rng = createRng(1);
    const shaken = circle(300, 400).map(({ x, y }) => ({ x: x + 2.4 * (rng.unit() - 0.5), y: y + 2.4 * (rng.unit() - 0.5) })); // prettier-ignore
    const mouse = drawn(freely(along(shaken))).points;
    const finger = drawn(freely({ ...along(shaken), reachMm: 35 })).points;
    expect(finger.length).toBeLessThan(mouse.length / 2);
    for (const place of shaken) expect(farFrom(place, finger)).toBeLessThan(2.8);
  });

  it('closes a track whose end comes back to its start within reach', () => {
    const { points } = drawn(along(circle(200, 200).slice(0, 199)));
    expect(points[points.length - 1]).toEqual(points[0]);
  });

  it('leaves a track open that ends 40 mm before its start, or that is drawn free', () => {
    const open = drawn(along(circle(200, 200).slice(0, 193))).points;
    expect(open[open.length - 1]).not.toEqual(open[0]);
    const finger = drawn({ ...along(circle(200, 200).slice(0, 193)), reachMm: 73 }).points;
    expect(finger[finger.length - 1]).not.toEqual(finger[0]);
    const free = drawn(freely(along(circle(200, 200).slice(0, 199)))).points;
    expect(free[free.length - 1]).not.toEqual(free[0]);
  });

  it('draws nothing that lies wholly outside the arena', () => {
    expect(penTool.edit(drag([-100, 100], [-100, 500]), contextOf(course()))).toBeNull();
    expect(drawn(drag([-100, 100], [200, 100])).points).toHaveLength(2);
  });

  it('becomes coarser rather than have a gap when the course has room for 50 points more', () => {
    const most = Array.from({ length: sceneLimits.points - 50 }, (_, i): Point => [i % 1000, i % 700]);
    const path = walk(createRng(2), { x: 600, y: 450 }, 5000, 30);
    const { points } = drawn(freely(along(path)), {}, course(stroke('full', ...most)));
    expect(points.length).toBeLessThanOrEqual(50);
    expect(points.length).toBeGreaterThan(2);
    expect(points[points.length - 1]).toEqual([Math.round(path[4999]!.x), Math.round(path[4999]!.y)]);
  });

  it('shows its ink while it draws freely, and its edit while it draws straight', () => {
    expect(penTool.ink?.(contextOf(course(), { penWidth: 30, penColor: 'blue' }))).toEqual({
      width: 30,
      color: 'blue',
    });
    expect(penTool.ink?.(contextOf(course(), { penShape: 'straight' }))).toBeNull();
  });
});

describe('pen with a ruler', () => {
  const straight = { penShape: 'straight' } as const;

  it('draws from start to end whatever lies between, in one of eight directions', () => {
    expect(drawn(drag([100, 100], [250, 400], [398, 112]), straight).points).toEqual([
      [100, 100],
      [400, 100],
    ]);
  });

  it('goes on exactly from the ends of other lines', () => {
    const scene = course(stroke('a', [103, 107], [300, 300]), stroke('b', [507, 311], [700, 311]));
    expect(drawn(drag([298, 303], [503, 308]), { ...straight, penColor: 'red' }, scene).points).toEqual([
      [300, 300],
      [507, 311],
    ]);
    expect(penTool.marks?.(drag([298, 303], [503, 308]), contextOf(scene, straight), true)).toEqual([
      { type: 'snap', at: { x: 300, y: 300 } },
      { type: 'snap', at: { x: 507, y: 311 } },
    ]);
  });

  it('takes any direction when it is free', () => {
    expect(drawn(freely(drag([100, 100], [398, 112])), straight).points).toEqual([
      [100, 100],
      [398, 112],
    ]);
  });
});

describe('pen that smooths', () => {
  const curve = { penShape: 'curve' } as const;

  it('takes out a tremble of 3 mm', () => {
    const path = Array.from({ length: 400 }, (_, i) => ({ x: 100 + 2 * i, y: 400 + 3 * exactSin(i / 2) }));
    const { points } = drawn(along(path), curve);
    // The ends stay where they were drawn.
    for (const [x, y] of points) if (x > 130 && x < 870) expect(Math.abs(y - 400)).toBeLessThanOrEqual(1);
  });

  it('makes a circle of 100 mm radius no more than 2 mm smaller, and closed', () => {
    const { points } = drawn(along(circle(100, 120)), curve);
    expect(points[0]).toEqual(points[points.length - 1]);
    for (const [x, y] of points) {
      const radius = Math.sqrt((x - 600) * (x - 600) + (y - 450) * (y - 450));
      expect(Math.abs(radius - 99)).toBeLessThan(2);
    }
  });

  it('rounds a corner and keeps both ends', () => {
    const { points } = drawn(drag([100, 100], [400, 100], [400, 400]), curve);
    expect(points[0]).toEqual([100, 100]);
    expect(points[points.length - 1]).toEqual([400, 400]);
    expect(points.length).toBeGreaterThan(4);
    expect(farFrom({ x: 400, y: 100 }, points)).toBeGreaterThan(3);
  });
});
