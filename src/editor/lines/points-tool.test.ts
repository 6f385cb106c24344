import { describe, expect, it } from 'vitest';
import { exactCos, exactSin } from '#core/exact-math';
import type { Vec } from '#core/geometry';
import { createRng } from '#core/rng';
import { isSame } from '#core/same';
import { editProblem } from '#scene/check-edit';
import { applyEdit } from '#scene/edit';
import { asKept } from '#scene/groups';
import { parseScene } from '#scene/parse';
import type { Point, Scene, SceneObject } from '#scene/scene';
import { serializeScene } from '#scene/serialize';
import { shapeOutline } from '#scene/shape/shape';
import { oneOf } from '#scene/testing/fuzz';
import { randomObject } from '#scene/testing/random-scene';
import { toPoint } from '../plane';
import { contextOf, course, drag, freely, stroke, taps, used } from '../testing/desk';
import { penTool } from '../tools/pen-tool';
import { linePointRemoved, pointsTool } from './points-tool';

const chosen = (scene: Scene) => contextOf(scene, {}, { ids: ['a'], robot: false });
const pointsOf = ({ objects }: Scene): readonly Point[] =>
  objects.flatMap((object: SceneObject) => (object.id === 'a' && object.type === 'stroke' ? object.points : []));
const bent = (scene: Scene, ...path: readonly Point[]) => pointsOf(used(pointsTool, drag(...path), chosen(scene)));
const marksOf = (scene: Scene, isNew: boolean) =>
  (pointsTool.marksAtRest?.(chosen(scene)) ?? []).filter((mark) => mark.type === 'point' && mark.isNew === isNew);

describe('the points of a finished line', () => {
  const corner = course(stroke('a', [100, 100], [300, 100], [300, 300]));

  it('show as handles, with one between each two', () => {
    expect(marksOf(corner, false)).toHaveLength(3);
    expect(marksOf(corner, true)).toMatchObject([{ at: { x: 200, y: 100 } }, { at: { x: 300, y: 200 } }]);
  });

  it('move alone, onto the grid', () => {
    expect(bent(corner, [301, 99], [402, 151])).toEqual([
      [100, 100],
      [400, 150],
      [300, 300],
    ]);
  });

  it('are added by dragging from between two', () => {
    expect(bent(corner, [200, 101], [200, 201])).toEqual([
      [100, 100],
      [200, 200],
      [300, 100],
      [300, 300],
    ]);
  });

  it('go when they are dragged onto a neighbour, and with Delete', () => {
    expect(bent(corner, [300, 100], [102, 103])).toEqual([
      [100, 100],
      [300, 300],
    ]);
    expect(pointsOf(applyEdit(corner, linePointRemoved(chosen(corner), { x: 302, y: 98 }, 8)!))).toHaveLength(2);
    expect(linePointRemoved(chosen(corner), { x: 200, y: 100 }, 8)).toBeNull();
  });

  it('are at least two', () => {
    const straight = course(stroke('a', [100, 100], [300, 100]));
    expect(linePointRemoved(chosen(straight), { x: 100, y: 100 }, 8)).toBeNull();
  });

  it('join another line where an end comes to its end', () => {
    const scene = course(...corner.objects, stroke('b', [500, 300], [700, 300]));
    const after = used(pointsTool, drag([300, 300], [497, 302]), chosen(scene));
    expect(after.objects).toHaveLength(1);
    expect(pointsOf(after).slice(-2)).toEqual([
      [500, 300],
      [700, 300],
    ]);
  });

  it('stay where they are after a tap', () => {
    expect(pointsTool.edit(drag([300, 100]), chosen(corner))).toBeNull();
    expect(pointsTool.edit(drag([700, 700], [750, 750]), chosen(corner))).toBeNull();
  });
});

describe('a curve with many points', () => {
  const scene = used(penTool, drag([400, 200], [800, 600]), contextOf(course(), { penShape: 'circle' }));
  const circle = course({ ...scene.objects[0]!, id: 'a' });

  it('shows few of them', () => {
    expect(pointsOf(circle).length).toBeGreaterThan(50);
    const count = marksOf(circle, false).length;
    expect(count).toBeGreaterThan(7);
    expect(count).toBeLessThan(30);
  });

  it('keeps its shape away from the one that moves, and is smooth around it', () => {
    const after = used(pointsTool, freely(drag([800, 400], [850, 400])), chosen(circle));
    const points = pointsOf(after);
    expect(points[0]).toEqual(points[points.length - 1]);
    const far = (at: Point) => Math.sqrt((at[0] - 600) * (at[0] - 600) + (at[1] - 400) * (at[1] - 400));
    expect(Math.max(...points.map(far))).toBeCloseTo(250, 0);
    expect(points.filter(([x]) => x < 600).every((at) => Math.abs(far(at) - 200) < 1)).toBe(true);
    for (let i = 1; i < points.length; i += 1) expect(turnDeg(points, i)).toBeLessThan(60);
  });

  it('is drawn out smoothly from between two, too', () => {
    const middle = marksOf(circle, true)[0] as { at: { x: number; y: number } };
    const from: Point = [middle.at.x, middle.at.y];
    const points = bent(circle, from, [from[0] + 15, from[1] + 15]);
    expect(points.length).toBeGreaterThanOrEqual(pointsOf(circle).length);
    for (let i = 1; i < points.length; i += 1) expect(turnDeg(points, i)).toBeLessThan(75);
  });

  /** The bend at a point in degrees, by the sine and cosine of exact maths alone. */
  function turnDeg(points: readonly Point[], index: number): number {
    const [a, b, c] = [points[index - 1]!, points[index]!, points[index + 1] ?? points[1]!];
    const cross = (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]);
    const dot = (b[0] - a[0]) * (c[0] - b[0]) + (b[1] - a[1]) * (c[1] - b[1]);
    let angle = 0;
    while (angle < 180 && Math.abs(cross) * exactCos(angle * RAD) > dot * exactSin(angle * RAD)) angle += 1;
    return angle;
  }
  const RAD = Math.PI / 180;
});

describe('the corners of a polygon', () => {
  const ell: readonly Point[] = [[0, 0], [100, 0], [100, 50], [50, 50], [50, 100], [0, 100]]; // prettier-ignore
  const block = (angle = 0): SceneObject => ({ type: 'block', id: 'a', at: [200, 200], size: [100, 100], angle, corners: ell }); // prettier-ignore
  const cornersAfter = (scene: Scene, ...path: readonly Point[]) => outlineOf(used(pointsTool, freely(drag(...path)), chosen(scene))); // prettier-ignore
  const outlineOf = ({ objects }: Scene) =>
    objects.flatMap((object) => (object.type === 'block' ? shapeOutline(object).map(toPoint) : []));

  it('show as handles, with one between each two', () => {
    expect([marksOf(course(block()), false).length, marksOf(course(block()), true).length]).toEqual([6, 6]);
    expect(marksOf(course({ type: 'block', id: 'a', at: [200, 200], size: [50, 50], angle: 0 }), false)).toEqual([]);
  });

  it('move alone: all others stay', () => {
    expect(cornersAfter(course(block()), [250, 150], [290, 130])).toEqual([
      ...[[150, 150], [290, 130], [250, 200], [200, 200], [200, 250], [150, 250]], // prettier-ignore
    ]);
  });

  it('move alone where it is turned, and it stays turned', () => {
    const before = outlineOf(course(block(90)));
    const after = used(pointsTool, freely(drag([250, 250], [270, 290])), chosen(course(block(90))));
    expect(after.objects[0]).toMatchObject({ angle: 90 });
    expect(before).toContainEqual([250, 250]);
    expect(outlineOf(after)).toEqual(before.map((at) => (isSame(at, [250, 250]) ? [270, 290] : at)));
  });

  it('are added from between two, and go onto a neighbour or with Delete', () => {
    const more = cornersAfter(course(block()), [200, 150], [200, 120]);
    expect([more.length, more[1]]).toEqual([7, [200, 120]]);
    expect(cornersAfter(course(block()), [200, 200], [202, 248])).toHaveLength(5);
    const removed = linePointRemoved(chosen(course(block())), { x: 250, y: 200 }, 8);
    expect(outlineOf(applyEdit(course(block()), removed!))).toHaveLength(5);
  });

  it('cannot be dragged so that edges cross, and are at least three', () => {
    expect(pointsTool.edit(freely(drag([150, 150], [270, 180])), chosen(course(block())))).toBeNull();
    const three: SceneObject = { ...block(), corners: [[0, 0], [2, 0], [1, 2]] } as SceneObject; // prettier-ignore
    expect(linePointRemoved(chosen(course(three)), { x: 150, y: 150 }, 8)).toBeNull();
  });
});

describe('any line or polygon', () => {
  it('stays one that can be saved after each of 500 drags from one of its points', () => {
    const rng = createRng(5);
    let done = 0;
    for (let run = 0; run < 500; run += 1) {
      const line = randomObject(rng, 'a');
      const scene = course(line, randomObject(rng, 'b'));
      const marks = pointsTool.marksAtRest?.(chosen(scene)) ?? [];
      if (marks.length === 0) continue;
      const mark = oneOf(rng, marks);
      const from: Vec = mark.type === 'point' ? mark.at : { x: 0, y: 0 };
      const path = [from, { x: from.x + 200 * (rng.unit() - 0.5), y: from.y + 200 * (rng.unit() - 0.5) }];
      const edit = pointsTool.edit({ path, free: rng.unit() < 0.5, adds: false, reachMm: 8 }, chosen(scene));
      if (!edit) continue;
      done += 1;
      expect(editProblem(scene, edit)).toBeNull();
      expect(parseScene(serializeScene(applyEdit(scene, edit)))).toEqual({ scene: asKept(applyEdit(scene, edit)) });
    }
    expect(done).toBeGreaterThan(40);
  });
});

describe('a line by clicks', () => {
  it('shows just its corners', () => {
    const scene = used(penTool, taps([100, 100], [300, 100], [300, 300], [600, 300]), contextOf(course(), { penShape: 'corners' })); // prettier-ignore
    expect(marksOf(course({ ...scene.objects[0]!, id: 'a' }), false)).toHaveLength(4);
  });
});
