import { describe, expect, it } from 'vitest';
import { rulerTicks } from './draw-rulers';

describe('the rulers', () => {
  it('carry a number each 10 cm and a mark each 2 cm on an arena of 800 mm that is 640 px wide', () => {
    const ticks = rulerTicks(800, 0.8);
    expect(ticks.filter((tick) => tick.label !== null).map((tick) => tick.label)).toEqual([
      ...['0', '10', '20', '30', '40', '50', '60', '70', '80'],
    ]);
    expect(ticks[1]?.mm).toBe(20);
  });

  it('carry a number each metre on an arena of 10 m', () => {
    const labels = rulerTicks(10_000, 0.06).flatMap((tick) => tick.label ?? []);
    expect(labels.slice(0, 3)).toEqual(['0', '100', '200']);
  });
});
