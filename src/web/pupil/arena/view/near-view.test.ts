import { describe, expect, it } from 'vitest';

import type { Pose } from '#core/geometry';
import { newObject } from '#editor/kinds/index';
import { usualToolOptions } from '#editor/tools/tool-options';
import { defaultScene, type SceneObject } from '#scene/scene';

import { nearestMm, nearView } from './near-view';
import { fitView, toPx } from './view-transform';

const arena = [1200, 900] as const;
const canvas = { widthPx: 640, heightPx: 450 };
const wall = (y: number): SceneObject => ({ type: 'wall', id: 'w', from: [100, y], to: [1100, y], thickness: 10 });

describe('robot and nearest obstacle', () => {
  it('is as near as the wall beside it', () => {
    expect(nearestMm({ x: 600, y: 300 }, [wall(400)], arena)).toBeCloseTo(95, 0);
  });

  it('is as near as the edge of an empty arena', () => {
    expect(nearestMm({ x: 600, y: 300 }, [], arena)).toBe(300);
    expect(nearestMm({ x: 1150, y: 300 }, [], arena)).toBe(50);
  });

  it('bumps into no zone', () => {
    const zone = newObject(defaultScene(), 'target', [600, 350], usualToolOptions);
    expect(zone).not.toBeNull();
    expect(nearestMm({ x: 600, y: 300 }, zone === null ? [] : [zone], arena)).toBe(300);
  });

  it('is as near as a block is now, not where it was before it was pushed and turned', () => {
    const block: SceneObject = { type: 'block', id: 'b', at: [300, 300], size: [100, 50], angle: 0 };
    const nearest = (x: number, y: number, pose?: Pose): number =>
      nearestMm({ x, y }, [block], arena, pose === undefined ? null : { blocks: { b: pose }, movers: {} });
    expect(nearest(400, 300)).toBeCloseTo(50);
    const pushed = { xMm: 600, yMm: 450, headingRad: Math.PI / 2 };
    expect(nearest(400, 300, pushed)).toBeCloseTo(Math.hypot(175, 100)); // it is upright: 50 wide, 100 high
    expect(nearest(600, 300, pushed)).toBeCloseTo(100);
    const aslant = { ...pushed, headingRad: Math.PI / 4 };
    expect(nearest(600 + 100, 450 + 100, aslant)).toBeCloseTo(Math.hypot(100, 100) - 50);
  });

  it('is as near as a moving obstacle is now', () => {
    const mover: SceneObject = { type: 'mover', id: 'm', at: [300, 300], to: [900, 300], size: [50, 50], angle: 90, speed: 100, spiked: false }; // prettier-ignore
    const moved = { blocks: {}, movers: { m: { xMm: 700, yMm: 300, headingRad: Math.PI / 2 } } };
    expect(nearestMm({ x: 600, y: 300 }, [mover], arena, moved)).toBeCloseTo(75);
  });

  it('has both in sight, larger than the whole arena shows them', () => {
    const at = { x: 600, y: 300 };
    const view = nearView(at, 100, arena, canvas);
    expect(view.pxPerMm).toBeGreaterThan(fitView(arena, canvas).pxPerMm * 2);
    const middle = toPx(view, at);
    const obstacle = toPx(view, { x: 600, y: 400 });
    expect([middle.x, middle.y]).toEqual([expect.closeTo(328, 0), expect.closeTo(216, 0)]);
    expect(obstacle.y).toBeGreaterThan(18);
  });

  it('never shows less than the whole arena does', () => {
    expect(nearView({ x: 600, y: 450 }, 5000, arena, canvas).pxPerMm).toBeCloseTo(fitView(arena, canvas).pxPerMm);
  });
});
