import { describe, expect, it } from 'vitest';
import { defaultScene } from '#scene/scene';
import { startElsewhere } from './use-live-course';

const { robot } = defaultScene(); // 600 | 450, heading 0

describe('the outline at the start of the robot', () => {
  it('shows when the robot has driven off or turned', () => {
    expect(startElsewhere(robot, { xMm: 620, yMm: 450, headingRad: 0 })).toBe(robot);
    expect(startElsewhere(robot, { xMm: 600, yMm: 450, headingRad: 1 })).toBe(robot);
  });

  it('does not show while it stands there, also after a full turn, nor without a robot', () => {
    expect(startElsewhere(robot, { xMm: 601, yMm: 450, headingRad: 2 * Math.PI + 0.01 })).toBeNull();
    expect(startElsewhere(robot, null)).toBeNull();
  });
});
