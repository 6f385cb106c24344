import { describe, expect, it } from 'vitest';
import { robotTypes } from '#robots/index';
import { defaultScene } from '#scene/scene';
import { robotAtStart } from '../picture/arranged';
import { placeOf } from './overlays';

const [look] = robotTypes;
if (look === undefined) throw new Error('no robots');
const robotAt = (headingRad: number) => ({
  ...robotAtStart(defaultScene()),
  pose: { xMm: 500, yMm: 400, headingRad },
});

describe('a chain of lights on a robot', () => {
  it('is a ring of 59 mm around the middle of the body for 24 lights, 18 mm ahead of the axle', () => {
    const place = placeOf('ring', 24, { now: robotAt(0), look, scale: 1 });
    expect(place.atMm.x).toBeCloseTo(518, 6);
    expect(place.atMm.y).toBeCloseTo(400, 6);
    expect((24 * place.unitMm) / Math.PI).toBeCloseTo(58.8, 1);
  });

  it('grows and turns with the robot', () => {
    const place = placeOf('ring', 24, { now: robotAt(Math.PI / 2), look, scale: 2 });
    expect(place.atMm.x).toBeCloseTo(500, 6);
    expect(place.atMm.y).toBeCloseTo(436, 6);
    expect(place.unitMm).toBeCloseTo(15.4, 6);
  });

  it('is drawn smaller for 256 lights, so that it stays on a robot 9 cm wide', () => {
    const { unitMm } = placeOf('zigzag', 256, { now: robotAt(0), look, scale: 1 });
    expect(16 * unitMm).toBeLessThanOrEqual(92);
  });
});
