import { describe, expect, it } from 'vitest';
import { headingLabel, placeLabel } from './draw-hand';

describe('the label of what is held', () => {
  it('says 45° for an eighth of a turn and 180° for half a turn to the right', () => {
    expect(headingLabel(Math.PI / 4)).toBe('45°');
    expect(headingLabel(-Math.PI)).toBe('180°');
  });

  it('says 30.5 | 45 cm for 305 mm and 450.2 mm', () => {
    expect(placeLabel({ xMm: 305, yMm: 450.2, headingRad: 0 })).toBe('30.5 | 45 cm');
  });
});
