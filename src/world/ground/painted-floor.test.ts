import { describe, expect, it } from 'vitest';

import type { FieldShape } from '../shapes';
import { createPaintedFloor } from './painted-floor';

const field: FieldShape = { atMm: { x: 100, y: 100 }, angleRad: 0, sizeMm: { x: 100, y: 60 }, reflectance: 0.8, shares: [0.2, 0.6, 0.2] }; // prettier-ignore
const line = { pointsMm: [{ x: 0, y: 100 }, { x: 200, y: 100 }], widthMm: 20 }; // prettier-ignore

describe('the painted floor', () => {
  it('has an infrared and a colour of its own for each paint; bare floor is 1 in all', () => {
    const floor = createPaintedFloor();
    floor.addField(field);
    expect([floor.reflectanceAt(100, 100, 4), floor.reflectanceAt(300, 100, 4)]).toEqual([0.8, 1]);
    expect(floor.sharesAt(100, 100, 4)).toEqual([0.2, 0.6, 0.2]);
    expect(floor.sharesAt(300, 100, 4)).toEqual([1, 1, 1]);
  });

  it('mixes by area on the edge of a field: half of each in the middle of it', () => {
    const floor = createPaintedFloor();
    floor.addField(field);
    const [red, green, blue] = floor.sharesAt(150, 100, 4);
    expect([red, green, blue]).toEqual([0.6, 0.8, 0.6].map((share) => expect.closeTo(share, 2) as number));
    floor.addField({ ...field, atMm: { x: 200, y: 100 }, shares: [1, 0, 0] });
    expect(floor.sharesAt(150, 100, 4)[1]).toBeCloseTo(0.3, 2);
  });

  it('has lines over all fields, and later fields over earlier ones, until they are taken away', () => {
    const floor = createPaintedFloor();
    const stroke = floor.addStroke({ ...line, reflectance: 0, shares: [0.1, 0.1, 0.1] });
    const below = floor.addField(field);
    const above = floor.addField({ ...field, reflectance: 0.3, shares: [0, 0, 1] });
    expect([floor.reflectanceAt(100, 100, 4), floor.reflectanceAt(100, 120, 4)]).toEqual([0, 0.3]);
    expect(floor.sharesAt(100, 120, 4)).toEqual([0, 0, 1]);
    below.setLayer(7);
    expect(floor.sharesAt(100, 120, 4)).toEqual([0.2, 0.6, 0.2]);
    for (const each of [stroke, below, above]) each.remove();
    expect([floor.reflectanceAt(100, 100, 4), ...floor.sharesAt(100, 120, 4)]).toEqual([1, 1, 1, 1]);
  });

  it('knows turned, round and many-cornered fields', () => {
    const floor = createPaintedFloor();
    floor.addField({ ...field, sizeMm: { x: 200, y: 20 }, angleRad: Math.PI / 2 });
    expect([floor.reflectanceAt(100, 190, 4), floor.reflectanceAt(190, 100, 4)]).toEqual([0.8, 1]);
    const round = createPaintedFloor();
    round.addField({ ...field, isRound: true });
    expect([round.reflectanceAt(140, 100, 4), round.reflectanceAt(147, 127, 4)]).toEqual([0.8, 1]);
    const corner = createPaintedFloor();
    corner.addField({ ...field, partsMm: [[{ x: -50, y: -30 }, { x: 50, y: -30 }, { x: -50, y: 30 }]] }); // prettier-ignore
    expect([corner.reflectanceAt(70, 90, 4), corner.reflectanceAt(140, 125, 4)]).toEqual([0.8, 1]);
  });

  it('lies over a picture, and a line over its edge mixes all three', () => {
    const floor = createPaintedFloor();
    const picture = { atMm: { x: 0, y: 0 }, sizeMm: { x: 300, y: 300 }, columns: 1, rows: 1, reflectances: Float32Array.of(0.5) }; // prettier-ignore
    floor.setFloor(picture);
    floor.addField(field);
    floor.addStroke({ ...line, widthMm: 4, reflectance: 0 });
    expect(floor.reflectanceAt(40, 130, 4)).toBe(0.5);
    const ink = 1 - floor.reflectanceAt(40, 100, 4) / 0.5;
    expect(floor.reflectanceAt(150, 100, 4)).toBeCloseTo((1 - ink) * 0.65, 2);
  });
});
