import { describe, expect, it } from 'vitest';
import type { Vec } from '#core/geometry';
import { exactTan } from '#core/exact-math';
import { createWorld } from '../world';
import type { CameraView, TagShape } from './camera';

const tan = (deg: number): number => exactTan((deg * Math.PI) / 180);

/** A lens 90 mm above the floor that looks 15° down, with 8 × 6 cells. */
const VIEW: CameraView = {
  ...{ heightMm: 90, tiltRad: Math.PI / 12, columns: 8, rows: 6, rangeMm: 3000 },
  ...{ acrossTan: tan(23), uprightTan: 0.75 * tan(23) },
};
const FROM: Vec = { x: 500, y: 500 };
const tag = ({ atMm = { x: 800, y: 500 }, angleRad = Math.PI, isFlat = false }: Partial<TagAt> = {}): TagShape => ({
  ...{ number: 5, sideMm: 60, rimMm: 7.5, isFlat },
  pose: () => ({ xMm: atMm.x, yMm: atMm.y, headingRad: angleRad }),
});
interface TagAt {
  readonly atMm: Vec;
  readonly angleRad: number;
  readonly isFlat: boolean;
}
const world = () => createWorld({ widthMm: 2000, heightMm: 1000 });

/** The cells as letters: `.` floor, `r` red floor, `R` red thing, `#` thing without a colour, a space nothing. */
function seen(of: ReturnType<typeof world>, headingRad = 0): string[] {
  return of
    .camera(FROM, headingRad, VIEW)
    .picture()
    .map((row) =>
      row
        .map(({ shares, isFloor }) => {
          if (shares === null) return isFloor ? '?' : '#';
          const isRed = shares[1] < 0.5;
          return isFloor ? (isRed ? 'r' : '.') : 'R';
        })
        .join(''),
    );
}

const RED = [0.7, 0.1, 0.1] as const;

describe('the picture of a camera', () => {
  it('has the floor below the horizon, and the edge of the arena above', () => {
    expect(seen(world())).toEqual(['########', '........', '........', '........', '........', '........']);
  });

  it('sees a red field on the floor, ahead to the left', () => {
    const of = world();
    // 300 mm ahead; the third row from below looks at 292 mm.
    of.addField({ atMm: { x: 790, y: 560 }, angleRad: 0, sizeMm: { x: 60, y: 60 }, reflectance: 0.9, shares: RED });
    expect(seen(of)).toEqual(['########', '........', '........', '.rr.....', '........', '........']);
  });

  it('sees a red block, which hides the floor behind it, and over a low one', () => {
    const of = world();
    const block = { angleRad: 0, fixed: true, sizeMm: { x: 40, y: 100 }, shares: RED };
    of.addBlock({ ...block, atMm: { x: 800, y: 500 }, heightMm: 40 });
    const rows = seen(of);
    expect(rows[2]).toBe('..RRRR..');
    expect(rows[1]).toBe('........');
    expect(seen(of, Math.PI).some((row) => row.includes('R'))).toBe(false);
  });

  it('looks only through the rows that are asked for', () => {
    expect(world().camera(FROM, 0, VIEW).picture([5]).length).toBe(1);
  });
});

describe('the floor that a camera sees', () => {
  const SLOPES = [-0.3, 0, 0.3];
  const ends = (of: ReturnType<typeof world>): number[] =>
    of.camera(FROM, 0, VIEW).floorEnds(SLOPES, 700).map(Math.round); // prettier-ignore

  it('ends at a wall, and goes on beside it', () => {
    const of = world();
    expect(ends(of)).toEqual([700, 700, 700]);
    of.addWall({ fromMm: { x: 800, y: 500 }, toMm: { x: 800, y: 900 }, thicknessMm: 10, heightMm: 250 });
    expect(ends(of)).toEqual([700, 295, 295]);
  });

  it('goes over a low block whose shadow ends before, and ends at one that hides its end', () => {
    const block = { angleRad: 0, fixed: true, sizeMm: { x: 40, y: 40 }, heightMm: 40 };
    const near = world();
    near.addBlock({ ...block, atMm: { x: 700, y: 500 } });
    expect(ends(near)[1]).toBe(700);
    const far = world();
    far.addBlock({ ...block, atMm: { x: 1100, y: 500 } });
    expect(ends(far)[1]).toBe(580);
  });
});

describe('a tag before a camera', () => {
  const tags = (of: ReturnType<typeof world>, headingRad = 0) => of.camera(FROM, headingRad, VIEW).tags();

  it('is recognised with the corners of its square: 60 mm are 75 px at 300 mm', () => {
    const of = world();
    of.addTag(tag({}));
    const [one] = tags(of);
    const xs = one!.corners.map(({ x }) => 320 * x);
    expect(one!.number).toBe(5);
    expect(Math.max(...xs) - Math.min(...xs)).toBeGreaterThan(70);
    expect(Math.max(...xs) - Math.min(...xs)).toBeLessThan(80);
    expect(Math.max(...xs) + Math.min(...xs)).toBeCloseTo(320, 6);
  });

  it('lies on the floor, too', () => {
    const of = world();
    of.addTag(tag({ isFlat: true }));
    expect(tags(of).map(({ number }) => number)).toEqual([5]);
  });

  it('is not recognised from behind, from the side, from too far, half outside the picture or behind the camera', () => {
    for (const more of [
      { angleRad: 0 },
      { angleRad: Math.PI / 2 },
      { atMm: { x: 1900, y: 500 } },
      { atMm: { x: 800, y: 620 } },
      { atMm: { x: 300, y: 500 }, angleRad: 0 },
    ]) {
      const of = world();
      of.addTag(tag(more));
      expect(tags(of)).toEqual([]);
    }
  });

  it('is seen on the wall that it is stuck to, and not through a block; it can be taken away', () => {
    const of = world();
    of.addWall({ fromMm: { x: 805, y: 300 }, toMm: { x: 805, y: 700 }, thicknessMm: 10 });
    const takeAway = of.addTag(tag({}));
    expect(tags(of).length).toBe(1);
    const block = of.addBlock({
      atMm: { x: 700, y: 480 },
      angleRad: 0,
      fixed: true,
      sizeMm: { x: 30, y: 30 },
      heightMm: 60,
    });
    expect(tags(of).length).toBe(0);
    of.removeBlock(block);
    expect(tags(of).length).toBe(1);
    takeAway();
    expect(tags(of).length).toBe(0);
  });
});
