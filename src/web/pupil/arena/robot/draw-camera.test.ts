import { describe, expect, it } from 'vitest';
import type { CameraState } from '#robots/robot';
import { sightOutline } from './draw-camera';

const sight = { nearMm: 60, nearSlope: 0.6, farMm: 300, farSlope: 0.5 };
const outlineOf = (endsMm: readonly number[]) => {
  const camera: CameraState = {
    ...{ fromMm: { x: 0, y: 0 }, headingRad: 0, sight, endsMm },
    algorithm: 'line',
    seen: [],
  };
  return sightOutline(camera).map(({ x, y }) => [Math.round(x), Math.round(y)]);
};

describe('the floor that a camera sees', () => {
  it('has no fold where a thing in the middle alone is nearer than the floor seen first', () => {
    expect(outlineOf([300, 20, 300])).toEqual([
      [60, -36],
      [300, -150],
      [60, 0],
      [300, 150],
      [60, 36],
    ]);
  });

  it('is a line at the things that are nearer all over, not behind them', () => {
    expect(outlineOf([20, 30, 20]).map(([x]) => x)).toEqual([30, 30, 30, 30, 30]);
  });
});
