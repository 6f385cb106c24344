import { describe, expect, it } from 'vitest';
import { rulerLabels, rulerTicks } from './draw-rulers';
import { fitView, zoomLimits, zoomView, type ArenaSize } from '../view/view-transform';

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

describe('the numbers of the rulers', () => {
  /** Digits of 7 px, as in the sans-serif at 12 px. */
  const measure = (text: string): number => 7 * text.length;
  const arenas: readonly ArenaSize[] = [
    [200, 200],
    [1200, 900],
    [3000, 2000],
    [10_000, 10_000],
  ];

  it('never touch each other and are never cut off, in arenas of 20 cm to 10 m, on 320 to 2000 px, at each zoom', () => {
    for (const arena of arenas)
      for (const widthPx of [320, 390, 700, 2000]) {
        const canvas = { widthPx, heightPx: 400 };
        const { min, max } = zoomLimits(arena, canvas);
        for (let pxPerMm = min; pxPerMm < max; pxPerMm *= 1.07) {
          const fit = fitView(arena, canvas);
          const view = zoomView(fit, pxPerMm / fit.pxPerMm, { x: widthPx / 3, y: 200 }, arena, canvas);
          const labels = rulerLabels(
            rulerTicks(arena[0], view.pxPerMm),
            (mm) => view.leftPx + mm * view.pxPerMm,
            { from: 20, to: widthPx - 3 },
            measure,
          );
          expect(labels.length).toBeGreaterThan(0);
          labels.forEach(({ text, at }, i) => {
            const next = labels[i + 1];
            expect(at - measure(text) / 2).toBeGreaterThanOrEqual(20);
            expect(at + measure(text) / 2).toBeLessThanOrEqual(widthPx - 3);
            if (next) expect(next.at - measure(next.text) / 2 - (at + measure(text) / 2)).toBeGreaterThanOrEqual(6);
          });
        }
      }
  });

  it('say the unit once, at the last one in sight', () => {
    const labels = rulerLabels(rulerTicks(800, 0.8), (mm) => 0.8 * mm, { from: 0, to: 300 }, measure);
    expect(labels.map(({ text }) => text)).toEqual(['0', '10', '20', '30 cm']);
  });
});
