import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';

import { radOf } from '#core/angle';
import type { Vec } from '#core/geometry';
import { boundsAll } from '#editor/bounds';
import { kindOf } from '#editor/kinds/index';
import { distanceMm, minus, nearestOn, plus, toVec, turned } from '#editor/plane';
import { brought } from '#editor/parts/bring';
import { readyPart, type ReadyName } from '#editor/parts/ready-parts';
import { applyEdit } from '#scene/edit';
import { boundsOf } from '#scene/kinds/index';
import { findProblems } from '#scene/rules';
import { defaultScene, type Scene, type Stroke } from '#scene/scene';
import { soloRun } from '#simulation/run-setup';
import { Simulation } from '#simulation/simulation';

let firmware: WebAssembly.Module;
beforeAll(() => {
  firmware = new WebAssembly.Module(readFileSync('.cache/vm/vm.wasm'));
});

/** The end of a track so far, and its direction. */
interface End {
  readonly at: Vec;
  readonly deg: number;
}

/** Parts one behind the other, in the direction of the drive, and by how much each bends to the left. */
const loop: readonly (readonly [name: ReadyName, deg: number])[] = [
  ['long', 0],
  ['curve', 90],
  ['gap', 0],
  ['curve', 90],
  ['straight', 0],
  ['crossing', 0],
  ['curve', 90],
  ['straight', 0],
  ['curve', 90],
];

const linesOf = ({ objects }: Scene): readonly Stroke[] => objects.filter((object) => object.type === 'stroke');

/** Joins a part to the end of a track as a hand does, which is 3 mm beside it: the ends snap. */
function joined(scene: Scene, end: End, [name, bend]: (typeof loop)[number]): { scene: Scene; end: End } {
  const objects = readyPart(name).objects.map((object) => kindOf(object).turned(object, { x: 0, y: 0 }, end.deg));
  const lines = objects.filter((object) => object.type === 'stroke');
  const from = toVec(lines[0]!.points[0]!);
  const to = toVec((name === 'gap' ? lines[1]! : lines[0]!).points.at(-1)!);
  const { minX, minY, maxX, maxY } = boundsAll(objects.map(boundsOf))!;
  const middle = { x: (minX + maxX) / 2, y: (minY + maxY) / 2 };
  const beside = plus(plus(end.at, minus(middle, from)), { x: 2, y: -2 });
  const made = brought({ scene, footprint: [] }, { objects }, beside, { free: false, reachMm: 8 })!;
  return { scene: applyEdit(scene, made.edit), end: { at: plus(end.at, minus(to, from)), deg: end.deg + bend } };
}

function trackFrom(start: Vec): { scene: Scene; end: End } {
  const robot = { ...defaultScene().robot, type: 'maqueen-lite', at: [480, 150] as const };
  let track: { scene: Scene; end: End } = { scene: { ...defaultScene(), robot }, end: { at: start, deg: 0 } };
  for (const part of loop) track = joined(track.scene, track.end, part);
  return track;
}

/** How far a place is from the next line, in mm. */
const besideMm = (lines: readonly Stroke[], place: Vec): number =>
  Math.min(
    ...lines.flatMap(({ points }) =>
      points.slice(1).map((point, i) => distanceMm(nearestOn(toVec(points[i]!), toVec(point), place), place)),
    ),
  );

describe('a track of the parts for lines', () => {
  it('closes: nine parts, each brought to the end of the one before, end where they began', () => {
    const { scene, end } = trackFrom({ x: 450, y: 150 });
    expect(end).toEqual({ at: { x: 450, y: 150 }, deg: 360 });
    const ends = linesOf(scene).flatMap(({ points }) => [points[0]!, points.at(-1)!].map(String));
    // Only the ends at the gap and the two of the crossing's other line have no neighbour.
    const alone = ends.filter((place) => ends.filter((other) => other === place).length === 1);
    expect([alone.length, findProblems(scene, [])]).toEqual([4, []]);
  });

  it('is followed by a Maqueen Lite once round and more, over gap and crossing', async () => {
    const { scene } = trackFrom({ x: 450, y: 150 });
    const main = readFileSync('courses/closed-line/main.py', 'utf8');
    const set = { scene, files: { 'main.py': main }, robot: 'maqueen-lite', board: 'auto', seed: 1, reality: 0, keepTrace: true }; // prettier-ignore
    const run = await Simulation.create(soloRun(set), firmware);
    run.advanceTo(40_000_000);
    const trace = run.takeTrace();
    const lines = linesOf(scene);
    // The sensors, not the axle, are on the line; in the gap the next line is 15 mm away.
    const far = trace.map(({ xMm, yMm, headingRad }) =>
      besideMm(lines, plus({ x: xMm, y: yMm }, turned({ x: 40, y: 0 }, (headingRad * 180) / Math.PI))),
    );
    expect(Math.max(...far)).toBeLessThan(35);
    expect(run.snapshot().robot!.turnedRad).toBeGreaterThan(radOf(540));
    const places = [[600, 150], [900, 375], [600, 600], [300, 375]] as const; // prettier-ignore
    for (const place of places)
      expect(Math.min(...trace.map(({ xMm, yMm }) => distanceMm({ x: xMm, y: yMm }, toVec(place))))).toBeLessThan(30);
  });
});
