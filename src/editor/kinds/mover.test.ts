import { describe, expect, it } from 'vitest';
import { applyEdit } from '#scene/edit';
import { stopsOf, wayOf } from '#scene/kinds/mover-way';
import { defaultScene, type Mover, type Point, type Scene, type SceneObject } from '#scene/scene';
import { handleDragged } from '../handle-drag';
import { handlesOf } from '../handles';
import { withField } from '../object-edits';
import { usualToolOptions } from '../tools/tool-options';
import type { Handle, ToolOptions } from '../tools/tool';
import { kindOf, newObject } from './index';
import { stopHandles, withFurtherStop, withoutStop } from './mover-stops';

const mover = (...[at = [0, 0], to = at, ...stops]: readonly Point[]): Mover => ({
  ...{ type: 'mover', id: 'm', at, to, size: [50, 50], angle: 0, speed: 100, spiked: false },
  ...(stops.length === 0 ? {} : { stops }),
});
const sceneOf = (...objects: readonly SceneObject[]): Scene => ({ ...defaultScene(), objects });
const selection = { ids: ['m'], robot: false };
const places = (object: Mover): readonly Point[] => stopsOf(object).map(({ at }) => at);

/** The mover after its handle of this kind and index was dragged to a place. */
function dragged(object: Mover, kind: Handle['kind'], index: number, to: Point): Mover {
  const scene = sceneOf(object);
  const handle = handlesOf(scene, selection, []).find((one) => one.kind === kind && one.index === index);
  if (!handle) throw new Error(`There is no handle ${kind} ${String(index)}.`);
  const context = { scene, selection, options: usualToolOptions, footprint: [] };
  const drag = { path: [handle.at, { x: to[0], y: to[1] }], free: false, adds: false, reachMm: 12 };
  const edit = handleDragged(handle, drag, context);
  return edit ? (applyEdit(scene, edit).objects[0] as Mover) : object;
}

/** A new mover as the tool puts it at (600 | 450). */
const made = (options: Partial<ToolOptions>, ...around: readonly SceneObject[]): Mover =>
  newObject(sceneOf(...around), 'mover', [600, 450], { ...usualToolOptions, ...options }) as Mover;
const target: SceneObject = {
  ...{ type: 'target', id: 'goal', at: [900, 450], size: [100, 100], angle: 0 },
  ...{ round: false, number: 0, blocks: 0 },
};

describe('the stops of a moving block', () => {
  const way = mover([100, 100], [400, 100], [400, 400]);

  it('are dragged each by its own handle', () => {
    expect(places(dragged(way, 'point', 1, [600, 100]))).toEqual([[100, 100], [600, 100], [400, 400]]); // prettier-ignore
    expect(places(dragged(way, 'point', 2, [400, 600]))).toEqual([[100, 100], [400, 100], [400, 600]]); // prettier-ignore
  });

  it('become more by a drag of the + beyond the end, or of the one on a leg', () => {
    expect(places(dragged(way, 'add', 3, [100, 400]))).toEqual([...places(way), [100, 400]]);
    expect(places(dragged(way, 'add', 1, [250, 250]))).toEqual([[100, 100], [250, 250], [400, 100], [400, 400]]); // prettier-ignore
  });

  it('can be those of a round trip on the way home, too', () => {
    const round: Mover = { ...way, loops: true };
    expect(stopHandles(round, 12).filter(({ kind }) => kind === 'add')).toMatchObject([{ index: 1 }, { index: 2 }, { index: 3, at: { x: 250, y: 250 } }]); // prettier-ignore
    expect(places(dragged(round, 'add', 3, [100, 400]))).toHaveLength(4);
  });

  it('are taken out of the way by a drag onto a neighbour; two always stay', () => {
    expect(places(dragged(way, 'point', 2, [405, 105]))).toEqual([[100, 100], [400, 100]]); // prettier-ignore
    expect(places(dragged(way, 'point', 1, [100, 100]))).toEqual([[100, 100], [400, 400]]); // prettier-ignore
    expect(places(dragged(mover([100, 100], [400, 100]), 'point', 1, [100, 100]))).toHaveLength(2);
  });

  it('wait as long as the others when they are new', () => {
    const waiting = { ...way, waits: [2, 2, 2] };
    expect(dragged(waiting, 'add', 3, [100, 400]).waits).toEqual([2, 2, 2, 2]);
    expect(dragged({ ...way, waits: [2] }, 'add', 3, [100, 400]).waits).toEqual([2]);
    expect(dragged({ ...way, waits: [0, 0, 3] }, 'point', 1, [100, 100]).waits).toEqual([0, 3]);
  });

  it('are 20 at most: then there is no + any more', () => {
    const many = mover(...Array.from({ length: 20 }, (_, i): Point => [50 * i, 100]));
    expect(stopHandles(many, 1).every(({ kind }) => kind === 'point')).toBe(true);
    expect(withFurtherStop(many, [1200, 900])).toBeNull();
  });

  it('come and go in the list, too', () => {
    expect(places(withFurtherStop(way, [1200, 900]) ?? way)).toHaveLength(4);
    expect(places(withoutStop(way, 0) ?? way)).toEqual([[400, 100], [400, 400]]); // prettier-ignore
    expect(withoutStop(mover([1, 1], [9, 9]), 1)).toBeNull();
  });
});

describe('what a moving block does', () => {
  it('is chosen beside the tool: to and fro, round, turning, chasing, guarding the nearest zone', () => {
    expect(made({})).toEqual({ ...mover([600, 450], [800, 450]), id: 'mover-1' });
    expect(made({ moverWay: 'round', moverWait: 1 })).toMatchObject({
      loops: true,
      stops: [[800, 650]],
      waits: [1, 1, 1],
    });
    expect(made({ moverWay: 'stays' })).toMatchObject({ to: [600, 450], spin: 90 });
    expect(made({ moverWay: 'stays', moverSpin: -30 })).toMatchObject({ spin: -30 });
    expect(made({ moverWay: 'chases' })).toMatchObject({ to: [600, 450], chases: {} });
    expect(made({ moverWay: 'guards' }, { ...target, id: 'far', at: [0, 0] }, target).chases).toEqual({ zone: 'goal' });
  });

  it('is, of a guard in a course without zones, to guard the target that will be put next', () =>
    expect(made({ moverWay: 'guards' }).chases).toEqual({ zone: 'target-1' }));

  it('can be changed in the list; nothing of the way is left where there is none', () => {
    const busy: Mover = { ...mover([100, 100], [400, 100], [400, 400]), waits: [1], phase: 2, loops: true, spin: 45 };
    const changed = (way: string): Mover | undefined => {
      const edit = withField(sceneOf(busy), 'm', 'way', way);
      return edit ? (applyEdit(sceneOf(busy), edit).objects[0] as Mover) : undefined;
    };
    expect(changed('chases')).toEqual({ ...mover([100, 100]), spin: 45, chases: {} });
    expect(changed('stays')).toEqual({ ...mover([100, 100]), spin: 45 });
    const { loops: _, ...fro } = busy;
    expect(changed('to-and-fro')).toEqual(fro);
    expect(wayOf(changed('guards') ?? busy)).toBe('guards');
    expect(changed('round')).toBeUndefined();
  });

  it('moves, turns and grows with its whole way', () => {
    const way = mover([100, 100], [400, 100], [400, 400]);
    const scene = sceneOf(way);
    const edit = withField(scene, 'm', 'x', 200) ?? { type: 'all', edits: [] };
    expect(places(applyEdit(scene, edit).objects[0] as Mover)).toEqual([[200, 100], [500, 100], [500, 400]]); // prettier-ignore
    const turned = kindOf(way).turned(way, { x: 0, y: 0 }, 90) as Mover;
    expect(places(turned)).toEqual([[-100, 100], [-100, 400], [-400, 400]]); // prettier-ignore
    const drag = { path: [], free: false, adds: false, reachMm: 12 };
    const grown = kindOf(way).sized?.(way, [1, 1], { x: 145, y: 145 }, drag) as Mover;
    expect(places(grown)).toEqual([[110, 110], [410, 110], [410, 410]]); // prettier-ignore
  });
});
