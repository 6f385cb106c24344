import { describe, expect, it } from 'vitest';
import { gridSteps } from './draw-floor';

describe('the grid', () => {
  it('has lines each 5 cm at 0.7 px per mm, each cm at 2 px per mm', () => {
    expect(gridSteps(0.7)).toEqual({ fineMm: 10, mm: 50, strongMm: 500 });
    expect(gridSteps(2)).toEqual({ fineMm: 5, mm: 10, strongMm: 100 });
  });
});
