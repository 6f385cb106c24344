import { describe, expect, it } from 'vitest';
import { applyEdit } from '#scene/edit';
import { nextSize, resized, robotSizes } from './robot-size';
import { course, footprint } from './testing/desk';

describe('robot size', () => {
  it('goes by steps from a half to three times and back', () => {
    const up = [0.5];
    for (let next = nextSize(0.5, 1); next !== null; next = nextSize(next, 1)) up.push(next);
    expect(up).toEqual(robotSizes);
    expect(nextSize(3, -1)).toBe(2.5);
    expect(nextSize(0.5, -1)).toBeNull();
  });

  it('goes from a size of a file to the next step', () => {
    expect(nextSize(1.1, 1)).toBe(1.25);
    expect(nextSize(1.1, -1)).toBe(1);
  });

  it('keeps a robot that grows at the edge inside the arena', () => {
    const scene = { ...course(), robot: { ...course().robot, at: [1140, 870] as const } };
    const edit = resized(scene, 1, footprint);
    expect(edit && applyEdit(scene, edit).robot).toMatchObject({ scale: 1.25, at: [1125, 862] });
  });
});
