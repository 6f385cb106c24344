import type { Point } from '#scene/scene';

/** The ring to tick off: its middle above the base line and right of the edge, and its radius, in parts of the type size. */
export const RING = { aboveBase: 0.35, left: 0.6, radius: 0.48 } as const;

/** From one star to the next, in parts of the type size. */
const STAR_STEP = 1.25;

/** Stars of five points to colour in, side by side: the corners of each. @param at where the edge meets the base line */
export const starsAt = (count: number, [left, base]: Point, sizeMm: number): readonly (readonly Point[])[] =>
  Array.from({ length: count }, (_, star) =>
    starAt([left + (RING.left + STAR_STEP * star) * sizeMm, base - RING.aboveBase * sizeMm], sizeMm),
  );

const starAt = ([x, y]: Point, sizeMm: number): readonly Point[] =>
  Array.from({ length: 10 }, (_, corner) => {
    const radius = (corner % 2 === 0 ? 0.58 : 0.26) * sizeMm;
    const angle = (corner * Math.PI) / 5;
    return [x + radius * Math.sin(angle), y - radius * Math.cos(angle)];
  });
