import { describe, expect, it } from 'vitest';

import { fanLabels, type FanEnd, type FanLabel } from './fan-labels';

const sight = { left: 0, top: 0, width: 700, height: 500 };

/** Ends at these depths on eight rays from (100, 250) to the right, at 0.65 px per mm. */
const endsAt = (...depthsMm: readonly number[]): readonly FanEnd[] =>
  depthsMm.map((depthMm, column) => {
    const slope = Math.tan((((3.5 - column) * 7.5) / 180) * Math.PI);
    const length = Math.hypot(1, slope);
    return {
      at: { x: 100 + depthMm * 0.65, y: 250 - depthMm * slope * 0.65 },
      along: { x: 1 / length, y: -slope / length },
      depthMm,
    };
  });

const texts = (labels: readonly FanLabel[]): readonly string[] => labels.map(({ text }) => text);

function overlaps(labels: readonly FanLabel[]): readonly string[] {
  return labels.flatMap((one, at) =>
    labels.slice(at + 1).flatMap((other) => {
      const [a, b] = [one.box, other.box];
      const isOver = a.left < b.left + b.width && b.left < a.left + a.width && a.top < b.top + b.height && b.top < a.top + a.height; // prettier-ignore
      return isOver ? [`${one.text} over ${other.text}`] : [];
    }),
  );
}

describe('the numbers of a fan', () => {
  it('are all there where there is room, the nearest with its unit and last, over the others', () => {
    const labels = fanLabels(endsAt(420, 440, 450, 460, 470, 320, 230, 180), sight);
    expect(texts(labels).toSorted()).toEqual(['18 cm', '23', '32', '42', '44', '45', '46', '47']);
    expect(labels.at(-1)).toMatchObject({ text: '18 cm', isNearest: true });
  });

  it.each([30, 60, 100, 180, 300, 600])('never lie over each other, at a wall %i mm ahead', (mm) => {
    const labels = fanLabels(endsAt(mm, mm, mm, mm, mm - 1, mm, mm, mm), sight);
    expect(overlaps(labels)).toEqual([]);
    expect(labels.at(-1)?.isNearest).toBe(true);
  });

  it('of the edges stay where there is no room for all, at a wall 100 mm ahead', () => {
    const labels = fanLabels(endsAt(100, 101, 102, 99, 103, 104, 105, 106), sight);
    expect(texts(labels)).toContain('10');
    expect(labels.length).toBeLessThan(8);
  });

  it('lie in sight, also those of a wall at the edge of the picture', () => {
    const labels = fanLabels(endsAt(900, 905, 910, 915, 920, 925, 930, 935), sight);
    for (const { box } of labels) {
      expect(box.left + box.width).toBeLessThanOrEqual(700);
      expect(box.top).toBeGreaterThanOrEqual(0);
    }
    expect(overlaps(labels)).toEqual([]);
  });

  it('are none where nothing is in range', () => expect(fanLabels([], sight)).toEqual([]));
});
