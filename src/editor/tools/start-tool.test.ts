import { describe, expect, it } from 'vitest';
import { startTool } from './start-tool';
import { contextOf, course, drag, freely, used } from '../testing/desk';
import type { Drag } from './tool';

const start = (one: Drag, scale = 1) => {
  const scene = { ...course(), robot: { ...course().robot, scale } };
  return used(startTool, one, contextOf(scene)).robot;
};

describe('start', () => {
  it('puts the robot where it is tapped, on the 10 mm grid, and leaves its heading', () => {
    expect(start(drag([303, 298]))).toMatchObject({ at: [300, 300], heading: 0 });
    expect(start(freely(drag([303, 298])))).toMatchObject({ at: [303, 298], heading: 0 });
  });

  it('turns it to where the drag goes, in steps of 15°, or of 1° when it is free', () => {
    expect(start(drag([300, 300], [300, 500]))).toMatchObject({ at: [300, 300], heading: 90 });
    expect(start(drag([300, 300], [500, 340]))).toMatchObject({ heading: 15 });
    expect(start(drag([300, 300], [100, 299]))).toMatchObject({ heading: 180 });
    expect(start(freely(drag([300, 300], [500, 340])))).toMatchObject({ heading: 11 });
  });

  it('keeps all of the robot inside the arena: 40 mm of it are behind the axle, 60 mm before it', () => {
    expect(start(drag([2, 1]))).toMatchObject({ at: [40, 30] });
    expect(start(drag([1199, 899]))).toMatchObject({ at: [1140, 870] });
    expect(start(drag([1199, 899]), 2)).toMatchObject({ at: [1080, 840] });
    expect(start(drag([1199, 450], [1199, 700]))).toMatchObject({ at: [1170, 450], heading: 90 });
  });

  it('moves the robot by a drag of it, and leaves its heading', () => {
    expect(start(drag([610, 460], [713, 358]))).toMatchObject({ at: [700, 350], heading: 0 });
    expect(start(freely(drag([610, 460], [713, 358])))).toMatchObject({ at: [703, 348], heading: 0 });
  });

  it('turns the robot by a drag of the knob before it, in steps of 15°, and leaves its place', () => {
    expect(start(drag([676, 450], [600, 560]))).toMatchObject({ at: [600, 450], heading: 90 });
    expect(start(drag([676, 450], [676, 466]))).toMatchObject({ at: [600, 450], heading: 15 });
  });

  it('does nothing outside the arena, or where the robot is already', () => {
    expect(startTool.edit(drag([1300, 300]), contextOf(course()))).toBeNull();
    expect(startTool.edit(drag([600, 450]), contextOf(course()))).toBeNull();
  });
});
