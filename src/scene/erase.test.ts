import type { Vec } from '#core/geometry';
import { createRng } from '#core/rng';
import { describe, expect, it } from 'vitest';
import { erased, eraserAlong } from './erase';
import { squaredDistance } from './outline';
import type { Point, Stroke } from './scene';

const stroke = (points: readonly Point[], width = 20): Stroke => ({
  ...{ type: 'stroke', id: 's', points, width, color: 'black' },
});
const vec = ([x, y]: Point): Vec => ({ x, y });
const line = stroke([
  [0, 0],
  [200, 0],
]);

describe('an eraser', () => {
  it('leaves a gap as wide as itself when it crosses a line: both round ends touch it', () => {
    const across = eraserAlong(
      [
        { x: 100, y: -50 },
        { x: 100, y: 50 },
      ],
      15,
    );
    expect(erased(line, across)).toEqual([
      [
        [0, 0],
        [75, 0],
      ],
      [
        [125, 0],
        [200, 0],
      ],
    ]);
  });

  it('removes the end of a line when it goes along it', () => {
    expect(
      erased(
        line,
        eraserAlong(
          [
            { x: 200, y: 0 },
            { x: 150, y: 0 },
          ],
          10,
        ),
      ),
    ).toEqual([
      [
        [0, 0],
        [130, 0],
      ],
    ]);
  });

  it('leaves nothing of a line that it covers', () => {
    expect(
      erased(
        line,
        eraserAlong(
          [
            { x: 0, y: 0 },
            { x: 200, y: 5 },
          ],
          10,
        ),
      ),
    ).toEqual([]);
    expect(erased(stroke([[50, 50]]), eraserAlong([{ x: 60, y: 50 }], 5))).toEqual([]);
    expect(
      erased(
        stroke([
          [50, 50],
          [50, 50],
        ]),
        eraserAlong([{ x: 60, y: 50 }], 5),
      ),
    ).toEqual([]);
  });

  it('changes nothing if it only touches the edge, or is elsewhere', () => {
    expect(erased(line, eraserAlong([{ x: 100, y: 20 }], 10))).toBeNull();
    expect(erased(line, eraserAlong([{ x: 100, y: 300 }], 10))).toBeNull();
    expect(erased(stroke([[50, 50]]), eraserAlong([{ x: 70, y: 50 }], 5))).toBeNull();
    expect(erased(line, eraserAlong([], 10))).toBeNull();
  });

  it('takes a disc when it dabs once', () => {
    const [left, right] = erased(line, eraserAlong([{ x: 100, y: 0 }], 10)) ?? [];
    expect([left?.at(-1), right?.[0]]).toEqual([
      [80, 0],
      [120, 0],
    ]);
  });

  it('leaves no paint in between when it was moved so fast that the pointer was seen only twice', () => {
    const zigzag = stroke(Array.from({ length: 200 }, (_, index): Point => [index * 10, index % 2 === 0 ? 0 : 300]));
    const pieces = erased(
      zigzag,
      eraserAlong(
        [
          { x: -100, y: 150 },
          { x: 2100, y: 150 },
        ],
        10,
      ),
    );
    expect(pieces).toHaveLength(200);
  });

  it('goes over a place again without changing it further', () => {
    const eraser = eraserAlong(
      [
        { x: 90.3, y: -20.7 },
        { x: 111.9, y: 44.4 },
      ],
      7.5,
    );
    for (const points of erased(
      stroke([
        [0, 3],
        [77, 1],
        [200, 9],
      ]),
      eraser,
    ) ?? [])
      expect(erased(stroke(points), eraser)).toBeNull();
  });

  it('takes what is nearer than its radius and half the width, and nothing else: random lines and ways', () => {
    for (let seed = 1; seed <= 60; seed++) {
      const rng = createRng(seed);
      const place = (): Vec => ({ x: rng.unit() * 400, y: rng.unit() * 400 });
      const points = Array.from({ length: 12 }, (): Point => [rng.u32() % 400, rng.u32() % 400]);
      const path = Array.from({ length: 40 }, place);
      const pieces = erased(stroke(points, 10), eraserAlong(path, 8));
      if (pieces === null) throw new Error(`seed ${seed} erases nothing`);
      for (let probe = 0; probe < 300; probe++) {
        const at = 1 + (rng.u32() % 11);
        const share = rng.unit();
        const [from, to] = [vec(points[at - 1]!), vec(points[at]!)];
        const paint = { x: from.x + (to.x - from.x) * share, y: from.y + (to.y - from.y) * share };
        const toWay = distanceMm(paint, path);
        const left = Math.min(Infinity, ...pieces.map((piece) => distanceMm(paint, piece.map(vec))));
        // The reach is 8 + 10 / 2 mm; whole mm, the simplified way and crumbs below 1 mm blur it a little.
        if (toWay > 13 + 1.5) expect(left).toBeLessThan(0.75);
        if (toWay < 13 - 1.5) expect(left).toBeGreaterThan(0.5);
      }
    }
  });
});

const distanceMm = (place: Vec, path: readonly Vec[]): number =>
  Math.sqrt(Math.min(...path.map((to, index) => squaredDistance(place, path[index - 1] ?? to, to))));
