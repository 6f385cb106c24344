import { describe, expect, it } from 'vitest';
import type { SceneObject, Wall } from '#scene/scene';
import { addedTo, areMany, placeInView } from './still-cache';

const wall = (id: string): Wall => ({ type: 'wall', id, from: [0, 0], to: [100, 0], thickness: 10 });
const line = (points: number): SceneObject => ({
  type: 'stroke',
  id: 'l',
  points: Array.from({ length: points }, (_, i) => [i, 0] as const),
  width: 20,
  color: 'black',
});

describe('the kept picture of a course', () => {
  it('is only kept for much: 500 walls or a line of 20,000 points, not for 20 walls', () => {
    expect(areMany(Array.from({ length: 500 }, (_, i) => wall(String(i))))).toBe(true);
    expect(areMany([line(20_000)])).toBe(true);
    expect(areMany(Array.from({ length: 20 }, (_, i) => wall(String(i))))).toBe(false);
  });

  it('has only the new line added after a stroke of the pen', () => {
    const before = [wall('a'), wall('b')];
    expect(addedTo(before, [...before, line(5)])).toBe(1);
    expect(addedTo(before, before)).toBe(0);
  });

  it('is painted anew when something was taken away or is another', () => {
    const before = [wall('a'), wall('b')];
    expect(addedTo(before, before.slice(1))).toBeNull();
    expect(addedTo(before, [wall('a'), ...before.slice(1)])).toBeNull();
  });

  it('moves with the view, and is stretched while the zoom changes', () => {
    const made = { pxPerMm: 1, leftPx: 40, bottomPx: 600 };
    const canvas = { widthPx: 800, heightPx: 640 };
    expect(placeInView(made, { ...made, leftPx: 50 }, canvas)).toEqual({ left: 10, top: 0, width: 800, height: 640 });
    // The arena's lower left corner lies at 40 | 600 in the picture and shall lie at 0 | 700.
    const box = placeInView(made, { pxPerMm: 2, leftPx: 0, bottomPx: 700 }, canvas);
    expect(box).toEqual({ left: -80, top: -500, width: 1600, height: 1280 });
  });
});
