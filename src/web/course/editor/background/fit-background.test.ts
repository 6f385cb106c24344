import { describe, expect, it } from 'vitest';
import { sceneLimits } from '#scene/scene';
import { fitBackground } from './fit-background';

describe('a picture taken in as floor', () => {
  it('fills the arena when it has its proportions, with a cell each 2 mm', () => {
    expect(fitBackground(4000, 3000, [1200, 900])).toEqual({ at: [0, 0], size: [1200, 900], cells: [600, 450] });
  });

  it('lies in the middle when it is narrower', () => {
    expect(fitBackground(100, 100, [1200, 900])).toEqual({ at: [150, 0], size: [900, 900], cells: [450, 450] });
  });

  it('has larger cells where there would be more than a million', () => {
    const { size, cells } = fitBackground(1000, 1000, [10_000, 10_000]);
    expect(size).toEqual([10_000, 10_000]);
    expect(cells).toEqual([1000, 1000]);
  });

  it('is stretched to the arena where that is asked for', () => {
    expect(fitBackground(100, 100, [1200, 900], 'arena')).toMatchObject({ at: [0, 0], size: [1200, 900] });
  });

  it('has the true size of a sheet of paper, upright or lying as the picture is', () => {
    expect(fitBackground(400, 300, [1200, 900], 'A4')).toMatchObject({ at: [452, 345], size: [297, 210] });
    expect(fitBackground(300, 400, [1200, 900], 'A3')).toMatchObject({ size: [297, 420], cells: [149, 210] });
  });

  it('stays within what a course may hold for each proportion', () => {
    for (const [width, height] of [
      [1, 40_000],
      [40_000, 1],
      [3, 7],
      [9999, 10_000],
    ] as const)
      // prettier-ignore
      for (const arena of [[200, 200], [10_000, 10_000], [1201, 333]] as const) {
        const { size, cells } = fitBackground(width, height, arena);
        expect(cells[0] * cells[1]).toBeLessThanOrEqual(sceneLimits.cells);
        expect(Math.min(...cells)).toBeGreaterThanOrEqual(1);
        expect(Math.min(...size)).toBeGreaterThanOrEqual(sceneLimits.backgroundMm.min);
        expect(Math.max(...size)).toBeLessThanOrEqual(sceneLimits.backgroundMm.max);
      }
  });
});
