import { describe, expect, it } from 'vitest';
import { editProblem } from '#scene/check-edit';
import { applyEdit, type SceneEdit } from '#scene/edit';
import { inverse } from '#scene/inverse';
import { boundsOf } from '#scene/kinds/index';
import type { Scene, SceneObject } from '#scene/scene';
import { block, course, footprint, mover, stroke, target, wall } from '../testing/desk';
import type { Selection } from '../tools/tool';
import { aligned, distributed } from './align';
import { mirrored } from './mirror';
import { reordered, type Order } from './order';
import { sizedAlike } from './same-size';

const of = (ids: readonly string[], robot = false): Selection => ({ ids, robot });
const done = (scene: Scene, edit: SceneEdit | null): Scene => (edit ? applyEdit(scene, edit) : scene);
const sized = (id: string, at: readonly [number, number], size: readonly [number, number], turn = 0): SceneObject =>
  ({ ...block(id, at, turn), size }) as SceneObject;

describe('the order of painting', () => {
  const scene = course(
    stroke('a', [100, 100], [300, 100]),
    target('z', [200, 100]),
    stroke('b', [100, 100], [300, 100]),
    stroke('far', [100, 500], [300, 500]),
    stroke('c', [100, 100], [300, 100]),
  );
  const ids = (order: Order, ...chosen: readonly string[]): string =>
    done(scene, reordered(scene, of(chosen), order)).objects.map(({ id }) => id).join(' '); // prettier-ignore

  it('is changed to the very front or back of their layer; several keep theirs among themselves', () => {
    expect(ids('front', 'a')).toBe('z b far c a');
    expect(ids('back', 'c')).toBe('c a z b far');
    expect(ids('front', 'a', 'b')).toBe('z far c a b');
    expect(ids('back', 'far', 'c')).toBe('far c a z b');
  });

  it('is changed by one step past the next thing that it touches, whatever lies between', () => {
    expect(ids('forward', 'a')).toBe('z b a far c');
    expect(ids('forward', 'b')).toBe('a z far c b');
    expect(ids('backward', 'c')).toBe('a z c b far');
    expect(ids('forward', 'a', 'b')).toBe('z far c a b');
  });

  it('stays where nothing would be seen of it', () => {
    expect(reordered(scene, of(['c']), 'front')).toBeNull();
    expect(reordered(scene, of(['far']), 'forward')).toBeNull();
    expect(reordered(scene, of(['z']), 'back')).toBeNull();
    expect(reordered(scene, of([], true), 'front')).toBeNull();
  });

  it('is one edit that undo takes back exactly', () => {
    const edit = reordered(scene, of(['a', 'c']), 'back')!;
    expect(applyEdit(applyEdit(scene, edit), inverse(scene, edit))).toEqual(scene);
  });
});

describe('aligning', () => {
  const scene = course(sized('a', [100, 100], [50, 50]), sized('b', [300, 200], [100, 20]), wall('w', [500, 300], [500, 400])); // prettier-ignore
  const places = (to: Parameters<typeof aligned>[2]) =>
    done(scene, aligned(scene, of(['a', 'b', 'w']), to)).objects.map((object) => ('at' in object ? object.at : 'from' in object ? object.from : null)); // prettier-ignore

  it('brings edges and middles onto one line', () => {
    expect(places('left')).toEqual([[100, 100], [125, 200], [80, 300]]); // prettier-ignore
    expect(places('right')).toEqual([[480, 100], [455, 200], [500, 300]]); // prettier-ignore
    expect(places('upright')).toEqual([[290, 100], [290, 200], [290, 300]]); // prettier-ignore
    expect(places('top')).toEqual([[100, 375], [300, 390], [500, 300]]); // prettier-ignore
    expect(places('bottom')).toEqual([[100, 100], [300, 85], [500, 75]]); // prettier-ignore
    expect(places('level')).toEqual([[100, 238], [300, 238], [500, 188]]); // prettier-ignore
  });

  it('takes the start of the robot along, and needs two things', () => {
    const there = done(scene, aligned(scene, of(['a'], true), 'bottom', footprint));
    expect(there.robot.at).toEqual([600, 105]);
    expect(aligned(scene, of(['a']), 'left')).toBeNull();
    expect(aligned(scene, of(['a', 'b']), 'left')).not.toBeNull();
  });

  it('leaves equal gaps between three or more; the outermost stay', () => {
    const row = course(block('a', [100, 100]), block('c', [600, 120]), sized('b', [200, 110], [100, 50]));
    const even = done(row, distributed(row, of(['a', 'b', 'c']), 'x')).objects;
    expect(even).toEqual([block('a', [100, 100]), block('c', [600, 120]), sized('b', [350, 110], [100, 50])]);
    expect(distributed(row, of(['a', 'b']), 'x')).toBeNull();
    const column = course(block('a', [100, 100]), block('b', [100, 180]), block('c', [100, 500]));
    expect(done(column, distributed(column, of(['a', 'b', 'c']), 'y')).objects[1]).toEqual(block('b', [100, 300]));
  });
});

describe('mirroring', () => {
  it('leaves everything where a course can hold it, far outside, too', () => {
    const wide = { ...stroke('s', [1060, 19_800], [1060, 300]), width: 429 } as SceneObject;
    const scene = course(wide, wall('w', [1058, 90], [465, 361]));
    const edit = mirrored(scene, of(['s', 'w']), 'y');
    expect(edit && editProblem(scene, edit)).toBeNull();
    expect(done(scene, edit).objects[1]).toMatchObject({ from: [1058, 20_000] });
  });

  it('swaps left and right: places, angles, ends and points', () => {
    const scene = course(
      block('b', [100, 100], 1),
      wall('w', [200, 100], [300, 200]),
      stroke('s', [100, 300], [150, 400], [300, 300]),
      mover('m', [200, 500], [300, 500]),
    );
    const all = of(['b', 'w', 's', 'm']);
    const right = done(scene, mirrored(scene, of(['w', 's']), 'x')).objects;
    expect(right[1]).toEqual(wall('w', [200, 100], [100, 200]));
    expect(right[2]).toEqual(stroke('s', [300, 300], [250, 400], [100, 300]));
    expect(done(scene, mirrored(scene, of(['b']), 'x')).objects[0]).toEqual(block('b', [100, 100], 7));
    expect(done(scene, mirrored(scene, of(['m']), 'x')).objects[3]).toEqual(mover('m', [300, 500], [200, 500]));
    const twice = done(scene, mirrored(scene, all, 'y'));
    expect(done(twice, mirrored(twice, all, 'y')).objects).toEqual(scene.objects);
  });

  it('turns a polygon over, and keeps it where it is', () => {
    const corners = [[0, 0], [60, 0], [0, 30]] as const; // prettier-ignore
    const polygon = { ...sized('p', [300, 300], [60, 30]), angle: 30, corners } as SceneObject;
    const scene = course(polygon);
    const over = done(scene, mirrored(scene, of(['p']), 'x'));
    expect(over.objects[0]).toMatchObject({ angle: 330, corners: [[60, 0], [0, 0], [60, 30]] }); // prettier-ignore
    expect(boundsOf(over.objects[0]!).minX).toBeCloseTo(boundsOf(polygon).minX, 0);
    expect(boundsOf(over.objects[0]!).maxX).toBeCloseTo(boundsOf(polygon).maxX, 0);
  });

  it('turns the start of the robot round, and leaves words readable', () => {
    const label: SceneObject = { type: 'label', id: 'l', at: [300, 300], text: 'Start', height: 30, angle: 45 };
    const scene = course(label);
    expect(done(scene, mirrored(scene, of(['l']), 'x')).objects[0]).toEqual({ ...label, angle: 315 });
    expect(done(scene, mirrored(scene, of([], true), 'x', footprint)).robot).toMatchObject({
      at: [620, 450],
      heading: 180,
    });
    expect(mirrored(scene, of([]), 'x')).toBeNull();
  });
});

describe('the same size', () => {
  it('is that of the first one that was chosen', () => {
    const scene = course(sized('a', [100, 100], [30, 40]), sized('b', [300, 100], [100, 100], 1), wall('w', [500, 100], [500, 400]), wall('v', [600, 100], [700, 100])); // prettier-ignore
    const alike = done(scene, sizedAlike(scene, of(['b', 'a', 'v', 'w']))).objects;
    expect(alike[0]).toEqual(sized('a', [100, 100], [100, 100]));
    expect(alike.slice(1)).toEqual(scene.objects.slice(1));
    expect(done(scene, sizedAlike(scene, of(['w', 'v']))).objects[3]).toEqual(wall('v', [500, 100], [800, 100]));
    expect(sizedAlike(scene, of(['a']))).toBeNull();
  });

  it('is also its height, if it has one of its own', () => {
    const low = { ...sized('a', [100, 100], [30, 40]), height: 30 } as SceneObject;
    const scene = course(low, block('b', [300, 100]), target('t', [600, 600]), { ...wall('w', [500, 100], [500, 400]), height: 20 } as SceneObject, wall('v', [600, 100], [600, 400])); // prettier-ignore
    const alike = done(scene, sizedAlike(scene, of(['a', 'b', 't']))).objects;
    expect(alike[1]).toMatchObject({ size: [30, 40], height: 30 });
    expect('height' in (alike[2] ?? {})).toBe(false);
    expect(done(scene, sizedAlike(scene, of(['v', 'w']))).objects[3]).toEqual(wall('w', [500, 100], [500, 400]));
  });
});
