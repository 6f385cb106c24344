import { describe, expect, it } from 'vitest';

import { exactTan } from '#core/exact-math';
import { depthGrid, type DepthView } from './depth-grid';
import { movingObstacle, stillObstacle, type Obstacle } from './distance-cone';

const tangentAt = (deg: number): number => exactTan((deg * Math.PI) / 180);
const EIGHT = [26.25, 18.75, 11.25, 3.75, -3.75, -11.25, -18.75, -26.25].map(tangentAt);

/** A lens 104 mm above the floor that sees 8 × 8 cells. */
const VIEW: DepthView = { heightMm: 104, columns: EIGHT, rows: EIGHT, rangeMm: 4000, leastFloorSlope: tangentAt(5) };

/** Whole mm row by row from the lens at the origin, looking along x; `-` is nothing, figures of the floor have an `f`. */
function seen(obstacles: readonly Obstacle[], headingRad = 0, view = VIEW): readonly string[] {
  const cells = depthGrid({ x: 0, y: 0 }, headingRad, view, obstacles).map(({ depthMm, isFloor }) =>
    depthMm === Infinity ? '-' : `${String(Math.round(depthMm))}${isFloor ? 'f' : ''}`,
  );
  return view.rows.map((_, row) => cells.slice(8 * row, 8 * row + 8).join(' '));
}

const eight = (cell: string): string => Array(8).fill(cell).join(' ');

function box(nearMm: number, farMm: number, [right, left]: readonly [number, number], heightMm?: number): Obstacle {
  return stillObstacle(
    [
      { x: nearMm, y: right },
      { x: farMm, y: right },
      { x: farMm, y: left },
      { x: nearMm, y: left },
    ],
    heightMm,
  );
}

describe('a depth grid', () => {
  it('sees the floor in its lower rows, at the same depth in all columns; the flattest row loses it', () => {
    expect(seen([])).toEqual([...Array<string>(5).fill(eight('-')), eight('523f'), eight('306f'), eight('211f')]);
  });

  it('sees a wall across its axis at the same depth everywhere', () => {
    expect(seen([box(200, 210, [-1000, 1000])])).toEqual(Array(8).fill(eight('200')));
  });

  it('sees over a wall that ends below its ray', () => {
    // 250 mm at 450 mm: the two upper rows pass at 265 and 326 mm.
    const rows = seen([box(450, 460, [-2000, 2000], 250)]);
    expect(rows.slice(0, 3)).toEqual([eight('-'), eight('-'), eight('450')]);
    expect(rows.slice(5)).toEqual([eight('450'), eight('306f'), eight('211f')]);
  });

  it('sees the front of a low thing in the rows that come down to it, and its top behind', () => {
    // 60 mm high, 230 to 290 mm ahead: row 5 is at 58 mm there, row 6 at 26 mm, row 7 at the floor before.
    expect(seen([box(230, 290, [-500, 500], 60)]).slice(3)).toEqual(['-', '-', '230', '230', '211f'].map(eight));
    // The same 30 mm nearer: row 5 passes its front edge at 64 mm and meets its top at (104 − 60) / tan 11.25°.
    expect(seen([box(200, 260, [-500, 500], 60)])[5]).toBe(eight('221'));
  });

  it('looks through its columns: the first is the left one', () => {
    // 30 mm wide, ahead to the left: only the ray at 18.75° meets it.
    const rows = seen([box(400, 420, [125, 155], 250)]);
    expect(rows[3]).toBe('- 400 - - - - - -');
  });

  it('sees round and turned things, and none behind it', () => {
    const pole: Obstacle = {
      cornersMm: [],
      radiusMm: 25,
      heightMm: 250,
      pose: () => ({ xMm: 300, yMm: 0, headingRad: 0 }),
    };
    expect(seen([pole])[3]).toBe('- - - 283 283 - - -');
    expect(seen([pole], Math.PI)[3]).toBe(eight('-'));
    const corners = [
      { x: -50, y: -50 },
      { x: 50, y: -50 },
      { x: 50, y: 50 },
      { x: -50, y: 50 },
    ];
    const diamond = movingObstacle(corners, () => ({ xMm: 300, yMm: 0, headingRad: Math.PI / 4 }), 250);
    expect(seen([diamond])[3]).toBe('- - 286 245 245 286 - -');
  });

  it('turns with its heading', () => {
    expect(seen([box(-10, 10, [300, 310], 250)], Math.PI / 2)[3]).toBe('- - - - - - - -');
    expect(seen([box(-100, 100, [300, 310], 250)], Math.PI / 2)[3]).toBe('- - 300 300 300 300 - -');
  });

  it('gives 0 from inside a thing, and nothing beyond its range', () => {
    expect(seen([box(-10, 50, [-50, 50], 250)])[3]).toBe(eight('0'));
    expect(seen([box(4001, 4100, [-9000, 9000])])[3]).toBe(eight('-'));
    expect(seen([box(4000, 4100, [-9000, 9000])])[3]).toBe(eight('4000'));
  });
});
