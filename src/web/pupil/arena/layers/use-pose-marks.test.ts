import { describe, expect, it } from 'vitest';
import { defaultScene } from '#scene/scene';
import { robotAtStart } from '../picture/arranged';
import { poseMarks } from './use-pose-marks';

describe('the marks of the robot’s place', () => {
  const at = (xMm: number, yMm: number, headingDeg: number) => ({
    ...robotAtStart(defaultScene()),
    pose: { xMm, yMm, headingRad: (headingDeg * Math.PI) / 180 },
  });

  it('have one decimal: 123.46 mm, −0.02 mm and 90 degrees are 123.5, 0.0 and 90.0', () => {
    expect(poseMarks(at(123.46, -0.02, 90))).toEqual({ xMm: '123.5', yMm: '0.0', headingDeg: '90.0' });
  });

  it('turn the heading into −180 … 180: 350 degrees are −10.0, half a turn either way is 180.0', () => {
    expect(poseMarks(at(0, 0, 350)).headingDeg).toBe('-10.0');
    expect(poseMarks(at(0, 0, -180)).headingDeg).toBe('180.0');
    expect(poseMarks(at(0, 0, 540.01)).headingDeg).toBe('180.0');
  });

  it('are empty without a robot', () => {
    expect(poseMarks(null)).toEqual({ xMm: '', yMm: '', headingDeg: '' });
  });
});
