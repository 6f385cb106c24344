import { describe, expect, it } from 'vitest';
import { defaultScene, type Tag } from '#scene/scene';
import { coursePdf } from './pdf-course';
import { tagPages } from './pdf-tags';
import { planPrint } from './print-plan';

const tag = (number: number, side: number, more: Partial<Tag> = {}): Tag => ({ type: 'tag', id: `t${String(number)}`, at: [100, 100], number, side, angle: 0, ...more }); // prettier-ignore
const placesOf = (...objects: readonly Tag[]): number[][] =>
  tagPages({ ...defaultScene(), objects }).map((page) => page.map(({ tag: { number } }) => number));

describe('the sheets of tags', () => {
  it('hold the tags that stand, side by side as there is room; those that lie are printed with the floor', () => {
    expect(placesOf(tag(1, 60), tag(2, 60), tag(3, 60), tag(4, 60, { flat: true }))).toEqual([[1, 2, 3]]);
    expect(placesOf(...Array.from({ length: 8 }, (_, i) => tag(i + 1, 60)))).toEqual([
      [1, 2, 3, 4, 5, 6],
      [7, 8],
    ]);
    expect(placesOf(tag(1, 60), tag(2, 300), tag(3, 60))).toEqual([[1], [2], [3]]);
    expect(placesOf()).toEqual([]);
  });

  it('are pages of the print, each tag as large as in the course', () => {
    const scene = { ...defaultScene(), objects: [tag(5, 80)] };
    const plan = planPrint(scene.size, 'exact');
    if (!('tiles' in plan)) throw new Error('does not fit');
    const words = { name: '', planTitle: '', steps: [] };
    const pdf = coursePdf(scene, plan, { isCompressed: false, outlines: false, background: null }, words);
    expect(pdf.getNumberOfPages()).toBe(2);
    // The black square: 80 mm are 226.772 points.
    expect(pdf.output()).toMatch(/226\.77\d? -226\.77\d? re/);
  });
});
