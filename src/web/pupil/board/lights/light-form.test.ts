import { describe, expect, it } from 'vitest';
import { layOut, litCount, shownAs } from './light-form';

const rounded = (places: readonly { x: number; y: number }[]): number[][] =>
  places.map(({ x, y }) => [Math.round(x * 100) / 100 + 0, Math.round(y * 100) / 100 + 0]);

describe('how a chain is shown', () => {
  it('is as usual beside the board until something else is chosen', () => {
    expect(shownAs(24, undefined, true)).toEqual({ form: 'ring', place: 'board' });
    expect(shownAs(24, { form: 'strip' }, true)).toEqual({ form: 'strip', place: 'board' });
    expect(shownAs(24, { place: 'robot' }, true)).toEqual({ form: 'ring', place: 'robot' });
  });

  it('is beside the board when there is no robot to put it on', () => {
    expect(shownAs(24, { place: 'robot' }, false).place).toBe('board');
  });
});

describe('the layout of a ring', () => {
  it('has light 0 on top, 6 of 24 on the right, 12 below: clockwise', () => {
    const { places, radius } = layOut('ring', 24);
    expect(rounded([0, 6, 12, 18].map((i) => places[i]!))).toEqual([
      [0, -3.82],
      [3.82, 0],
      [0, 3.82],
      [-3.82, 0],
    ]);
    expect(2 * Math.PI * radius).toBeCloseTo(24, 6);
  });

  it('does not let 2 lights lie on each other', () => {
    expect(rounded(layOut('ring', 2).places)).toEqual([
      [0, -1],
      [0, 1],
    ]);
  });
});

describe('the layout of a strip', () => {
  it('is one row for 8 lights and three rows of 10 for 30', () => {
    expect(layOut('strip', 8)).toMatchObject({ halfWidth: 4, halfHeight: 0.5 });
    const { places, ...size } = layOut('strip', 30);
    expect(size).toMatchObject({ halfWidth: 5, halfHeight: 1.5 });
    expect(rounded([0, 9, 10, 29].map((i) => places[i]!))).toEqual([
      [-4.5, -1],
      [4.5, -1],
      [-4.5, 0],
      [4.5, 1],
    ]);
  });

  it('leaves the last row of 25 lights half full', () => {
    expect(rounded([layOut('strip', 25).places[24]!])).toEqual([[-0.5, 1]]);
  });
});

describe('the layout of a matrix', () => {
  it('is 16 × 16 for 256 lights, 8 × 8 for 64, 8 × 4 for 32, 8 × 5 for 40', () => {
    const size = (count: number): number[] => {
      const { halfWidth, halfHeight } = layOut('matrix', count);
      return [2 * halfWidth, 2 * halfHeight];
    };
    expect([256, 64, 32, 40].map(size)).toEqual([
      [16, 16],
      [8, 8],
      [8, 4],
      [8, 5],
    ]);
    expect(size(37)).toEqual([8, 5]); // 37 has no factors
    expect(size(1)).toEqual([1, 1]);
  });

  it('begins each row on the left, and as a zigzag every second one on the right', () => {
    expect(rounded([15, 16].map((i) => layOut('matrix', 256).places[i]!))).toEqual([
      [7.5, -7.5],
      [-7.5, -6.5],
    ]);
    expect(rounded([15, 16, 31, 32].map((i) => layOut('zigzag', 256).places[i]!))).toEqual([
      [7.5, -7.5],
      [7.5, -6.5],
      [-7.5, -6.5],
      [-7.5, -5.5],
    ]);
  });

  it('has a place for each of 1 to 1024 lights, in every form', () => {
    for (const form of ['ring', 'strip', 'matrix', 'zigzag'] as const)
      for (const count of [1, 2, 3, 7, 8, 23, 97, 256, 509, 1024]) {
        const { places, halfWidth, halfHeight } = layOut(form, count);
        expect(new Set(rounded(places).map(String)).size, `${form} ${String(count)}`).toBe(count);
        expect(places.every(({ x, y }) => Math.abs(x) < halfWidth && Math.abs(y) < halfHeight)).toBe(true);
      }
  });
});

describe('lights that are on', () => {
  it('are those with any colour: 2 of 3', () => {
    expect(
      litCount([
        [0, 0, 0],
        [0, 1, 0],
        [255, 255, 255],
      ]),
    ).toBe(2);
  });
});
