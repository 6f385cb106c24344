import { describe, expect, it } from 'vitest';
import { createTurnWatch, rotationCentre, type Moment } from './rotation-centre';

/** A robot on a circle of `radiusMm` around (500 | 500), counter-clockwise, `degrees` after the start at its right. */
function onCircle(radiusMm: number, degrees: number): Moment {
  const rad = (degrees * Math.PI) / 180;
  return {
    timeUs: degrees * 500,
    pose: { xMm: 500 + radiusMm * Math.cos(rad), yMm: 500 + radiusMm * Math.sin(rad), headingRad: rad + Math.PI / 2 },
    turnedRad: rad,
    pathMm: radiusMm * Math.abs(rad),
  };
}
const straight = (xMm: number, pathMm = xMm): Moment => ({
  timeUs: xMm * 1000,
  pose: { xMm, yMm: 0, headingRad: 0 },
  turnedRad: 0,
  pathMm,
});

describe('the centre of rotation', () => {
  it.each([2, 30, 170, 300])('is the middle of the circle of 15 cm, seen over %s°', (degrees) => {
    const centre = rotationCentre(onCircle(150, 10), onCircle(150, 10 + degrees));
    expect(centre?.atMm.x).toBeCloseTo(500, 6);
    expect(centre?.atMm.y).toBeCloseTo(500, 6);
    expect(centre?.radiusMm).toBeCloseTo(150, 6);
  });

  it('lies on the other side for a turn to the right, and for one backwards', () => {
    const mirrored = ({ pose, turnedRad, ...rest }: Moment): Moment => ({
      ...rest,
      pose: { ...pose, yMm: -pose.yMm },
      turnedRad: -turnedRad,
    });
    const right = rotationCentre(mirrored(onCircle(150, 0)), mirrored(onCircle(150, 20)));
    expect([right?.atMm.x, right?.atMm.y].map((mm) => Math.round(mm ?? 0))).toEqual([500, -500]);
    const back = rotationCentre(onCircle(150, 20), { ...onCircle(150, 0), timeUs: 20_000, pathMm: 200 });
    expect([back?.atMm.x, back?.atMm.y].map((mm) => Math.round(mm ?? 0))).toEqual([500, 500]);
  });

  it('is the middle of the axle, 0 cm away, for a turn on the spot', () => {
    const centre = rotationCentre(onCircle(0, 0), onCircle(0, 30));
    expect(centre).toEqual({ atMm: { x: 500, y: 500 }, radiusMm: 0 });
  });

  it('is nowhere while the robot drives straight, stands, or goes round a circle of 2 m', () => {
    expect(rotationCentre(straight(0), straight(60))).toBeNull();
    expect(rotationCentre(straight(0), { ...straight(0), timeUs: 60_000 })).toBeNull();
    expect(rotationCentre(onCircle(2000, 0), onCircle(2000, 3))).toBeNull();
  });

  it('is nowhere between pictures that are half a second apart, as at the highest speed', () => {
    expect(rotationCentre(onCircle(150, 0), { ...onCircle(150, 90), timeUs: 500_000 })).toBeNull();
  });

  it('is nowhere when the hand has carried the robot', () => {
    expect(rotationCentre(onCircle(150, 0), { ...onCircle(600, 30), pathMm: 0 })).toBeNull();
  });
});

describe('watching the turns of a run', () => {
  it('looks back 60 ms and forgets what was before', () => {
    const watch = createTurnWatch();
    expect(watch.centre()).toBeNull();
    watch.note(straight(0));
    watch.note({ ...onCircle(150, 0), timeUs: 10_000_000, pathMm: 1000 });
    for (let degrees = 1; degrees <= 8; degrees += 1)
      watch.note({ ...onCircle(150, degrees), timeUs: 10_000_000 + degrees * 10_000, pathMm: 1000 + degrees * 2.7 });
    expect(watch.centre()?.radiusMm).toBeCloseTo(150, 6);
  });

  it('keeps what it has found while the run stands still, and forgets it when another run begins', () => {
    const watch = createTurnWatch();
    watch.note(onCircle(150, 0));
    watch.note(onCircle(150, 10));
    watch.note(onCircle(150, 10));
    expect(watch.centre()?.radiusMm).toBeCloseTo(150, 6);
    watch.note(onCircle(150, 0));
    expect(watch.centre()).toBeNull();
    watch.note(onCircle(150, 10));
    watch.note(null);
    expect(watch.centre()).toBeNull();
  });
});
