import { describe, expect, it } from 'vitest';
import { defaultScene, type Tag } from '#scene/scene';
import { coursePdf } from './pdf-course';
import { tagPages } from './pdf-tags';
import { planPrint } from './print-plan';

const tag = (number: number, side: number, more: Partial<Tag> = {}): Tag => ({ type: 'tag', id: `t${String(number)}`, at: [100, 100], number, side, angle: 0, ...more }); // prettier-ignore
const placesOf = (...objects: readonly Tag[]): number[][] =>
  tagPages({ ...defaultScene(), objects }).map((page) => page.map(({ tag: { number } }) => number));

function printed(...objects: readonly Tag[]) {
  const scene = { ...defaultScene(), objects };
  const plan = planPrint(scene.size, 'exact');
  if (!('tiles' in plan)) throw new Error('does not fit');
  const words = { name: '', planTitle: '', steps: [] };
  return coursePdf(scene, plan, { isCompressed: false, outlines: false, background: null }, words);
}

/** The first two sides of all quadrilaterals on the sheets, in mm: right and down, right and down. */
const squaresIn = (pdf: string): number[][] =>
  [...pdf.matchAll(/([\d.]+) ([\d.]+) m\s+([\d.]+) ([\d.]+) l\s+([\d.]+) ([\d.]+) l\s+([\d.]+) ([\d.]+) l\s+h/g)].map(
    (found) => {
      const [x = 0, y = 0, x2 = 0, y2 = 0, x3 = 0, y3 = 0] = found
        .slice(1)
        .map((points) => (Number(points) * 25.4) / 72);
      return [x2 - x, y - y2, x3 - x2, y2 - y3].map((mm) => Math.round(mm) + 0);
    },
  );

describe('the sheets of tags', () => {
  it('hold the tags that stand, side by side as there is room; those that lie are printed with the floor', () => {
    expect(placesOf(tag(1, 60), tag(2, 60), tag(3, 60), tag(4, 60, { flat: true }))).toEqual([[1, 2, 3]]);
    expect(placesOf(...Array.from({ length: 8 }, (_, i) => tag(i + 1, 60)))).toEqual([
      [1, 2, 3, 4, 5, 6],
      [7, 8],
    ]);
    expect(placesOf(tag(1, 60), tag(2, 300), tag(3, 60))).toEqual([[1], [2], [3]]);
    expect(placesOf(tag(1, 40), tag(2, 155), tag(3, 40))).toEqual([[1], [2], [3]]);
    expect(placesOf()).toEqual([]);
  });

  it('are pages of the print, each tag as large as in the course', () => {
    const pdf = printed(tag(5, 80));
    expect(pdf.getNumberOfPages()).toBe(2);
    expect(squaresIn(pdf.output())).toContainEqual([80, 0, 0, 80]);
  });

  it('are not needed for a tag that lies: its pattern is printed with the floor, turned as it is', () => {
    const pdf = printed(tag(5, 80, { flat: true, angle: 90 }));
    expect(pdf.getNumberOfPages()).toBe(1);
    expect(squaresIn(pdf.output())).toContainEqual([0, -80, 80, 0]);
  });
});
