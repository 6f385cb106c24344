import { describe, expect, it } from 'vitest';
import type { Scene } from '#scene/scene';
import { checkpoint, contextOf, course, drag, newObjects, used } from '../testing/desk';
import type { Drag, ToolOptions } from './tool';
import { nextCheckpoint } from '../kinds/zone';
import { zoneTool } from './zone-tool';

const put = (one: Drag, options: Partial<ToolOptions> = {}, scene: Scene = course()) =>
  newObjects(scene, used(zoneTool, one, contextOf(scene, options)));

describe('zone', () => {
  it('is a target of 200 × 200 mm where it is tapped', () => {
    expect(put(drag([402, 399]))).toEqual([
      {
        type: 'target',
        id: 'target-1',
        at: [400, 400],
        size: [200, 200],
        angle: 0,
        round: false,
        number: 0,
        blocks: 0,
      },
    ]);
  });

  it('is the rectangle of a drag, also a round one', () => {
    expect(put(drag([100, 100], [400, 300]), { zone: 'forbidden', zoneShape: 'round' })).toMatchObject([
      { type: 'forbidden', at: [250, 200], size: [300, 200], round: true },
    ]);
  });

  it('wants as many blocks as are chosen, if it is a target', () => {
    expect(put(drag([400, 400]), { zoneBlocks: 3 })).toMatchObject([{ blocks: 3 }]);
    expect(put(drag([400, 400]), { zoneBlocks: 3, zone: 'forbidden' })).toMatchObject([{ blocks: 0 }]);
  });

  it('numbers checkpoints on from the highest', () => {
    expect(put(drag([400, 400]), { zone: 'checkpoint' })).toMatchObject([{ number: 1, size: [150, 150] }]);
    const scene = course(checkpoint('a', [100, 100], 1), checkpoint('b', [100, 400], 4));
    expect(put(drag([400, 400]), { zone: 'checkpoint' }, scene)).toMatchObject([{ number: 5 }]);
  });

  it('fills gaps once 99 is used, and makes no hundredth checkpoint', () => {
    const upTo = (count: number) => Array.from({ length: count }, (_, i) => checkpoint(`c${i}`, [100, 100], 99 - i));
    expect(nextCheckpoint(course(...upTo(98)))).toBe(1);
    expect(nextCheckpoint(course(...upTo(99)))).toBeNull();
    expect(put(drag([400, 400]), { zone: 'checkpoint' }, course(...upTo(99)))).toEqual([]);
  });

  it('stays inside the arena', () => {
    expect(put(drag([1100, 800], [1500, 1500]))).toMatchObject([{ at: [1150, 850], size: [100, 100] }]);
    expect(put(drag([1500, 800], [1600, 900]))).toEqual([]);
  });
});
