import { describe, expect, it } from 'vitest';
import type { Point, Wall } from '#scene/scene';
import { wallJoints } from './wall';

const wall = (from: Point, to: Point, thickness = 10): Wall => ({ type: 'wall', id: to.join(), from, to, thickness });

describe('walls that meet', () => {
  it('are joined where their ends are at the same place, as thick as the thinner one', () => {
    const walls = [wall([0, 0], [100, 0]), wall([100, 0], [200, 100], 6), wall([300, 0], [300, 100])];
    expect(wallJoints(walls)).toEqual([expect.objectContaining({ at: [100, 0], thickness: 6 })]);
  });

  it('have one joint however many of them meet there', () => {
    const walls = [wall([0, 0], [100, 0]), wall([100, 0], [100, 100]), wall([200, 50], [100, 0])];
    expect(wallJoints(walls)).toHaveLength(1);
  });
});
