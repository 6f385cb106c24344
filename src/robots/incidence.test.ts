import { describe, expect, it } from 'vitest';
import { heardCone, incidenceOption } from './incidence';
import { robotTypes } from './index';
import { SR04_CONE } from './sonar';

const limitDeg = (incidence: string): number =>
  ((heardCone(SR04_CONE, { incidence }).incidenceLimitRad ?? Math.PI / 2) * 180) / Math.PI;

describe('slanted walls', () => {
  it('are all heard, unless the option says otherwise', () => {
    expect(heardCone(SR04_CONE, {})).toBe(SR04_CONE);
    expect(heardCone(SR04_CONE, { incidence: 'all' })).toBe(SR04_CONE);
  });

  it('are heard up to 45° or 25° aslant', () => {
    expect(limitDeg('45')).toBeCloseTo(45, 9);
    expect(limitDeg('25')).toBeCloseTo(25, 9);
  });

  it('are an option of every robot', () => {
    for (const { options } of robotTypes) expect(options).toContainEqual(expect.objectContaining(incidenceOption));
  });
});
