import { describe, expect, it } from 'vitest';

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
