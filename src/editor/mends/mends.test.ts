import { describe, expect, it } from 'vitest';

import { applyEdit } from '#scene/edit';
import { findProblems, type RuleCode } from '#scene/rules';
import type { Scene, SceneObject } from '#scene/scene';
import { mendAll, mendOf } from './mends';
import { block, checkpoint, course, footprint, stroke, target, wall } from '../testing/desk';

/** The course after everything that can be mended was, and the problems that are left. */
function mended(scene: Scene): { readonly scene: Scene; readonly left: readonly RuleCode[] } {
  const edit = mendAll(scene, findProblems(scene, footprint), footprint);
  const after = edit === null ? scene : applyEdit(scene, edit);
  return { scene: after, left: findProblems(after, footprint).map(({ code }) => code) };
}
const codes = (scene: Scene): readonly RuleCode[] => findProblems(scene, footprint).map(({ code }) => code);
const object = (scene: Scene, id: string): SceneObject | undefined => scene.objects.find((one) => one.id === id);

describe('a tap that mends a course', () => {
  it('fetches everything in that a smaller arena has left outside, and puts nothing into each other', () => {
    const far = [block('a', [1100, 800]), block('b', [1100, 860]), stroke('line', [700, 700], [1000, 700])];
    const scene: Scene = { ...course(...far), size: [600, 400], robot: { ...course().robot, at: [1000, 800] } };
    expect(codes(scene)).toEqual(['robot-outside', 'object-outside', 'object-outside', 'object-outside']);
    const { scene: after, left } = mended(scene);
    expect(left).toEqual([]);
    expect(object(after, 'line')).toMatchObject({ points: [[290, 390], [590, 390]] }); // prettier-ignore
    expect(after.robot.at[0]).toBeLessThanOrEqual(540);
  });

  it('has a guard without its field guard the nearest one, if there is any', () => {
    const guard: SceneObject = {
      ...{
        type: 'mover',
        id: 'g',
        at: [300, 300],
        to: [300, 300],
        size: [50, 50],
        angle: 0,
        speed: 100,
        spiked: false,
      },
      chases: { zone: 'gone', reach: 400 },
    };
    const { scene, left } = mended(course(guard, target('far', [1000, 700]), target('near', [300, 600])));
    expect([object(scene, 'g'), left]).toEqual([{ ...guard, chases: { zone: 'near', reach: 400 } }, []]);
    expect(mended(course(guard)).left).toEqual(['guard-without-zone']);
  });

  it('leaves outside what is larger than the arena', () => {
    const scene: Scene = { ...course(stroke('long', [0, 2000], [5000, 2000])), size: [600, 400] };
    expect(mendAll(scene, findProblems(scene, []), [])).toBeNull();
  });

  it('puts a block aside that stands under the robot, and no farther than it must', () => {
    const scene = course(block('under', [640, 450]));
    expect(codes(scene)).toEqual(['robot-inside']);
    const [problem] = findProblems(scene, footprint);
    const mend = problem && mendOf(scene, problem, footprint);
    expect(mend?.kind).toBe('block-aside');
    const { scene: after, left } = mended(scene);
    expect(left).toEqual([]);
    expect(after.robot).toBe(scene.robot);
    expect(object(after, 'under')).toMatchObject({ at: [690, 450] });
  });

  it('moves the robot out of a wall', () => {
    const scene = course(wall('across', [600, 300], [600, 600]));
    const { scene: after, left } = mended(scene);
    expect([codes(scene), left]).toEqual([['robot-inside'], []]);
    expect(after.objects).toBe(scene.objects);
    expect(after.robot.at).toEqual([650, 450]);
  });

  it('moves the robot off a forbidden zone, to where there is none', () => {
    const forbidden: SceneObject = { ...target('no', [600, 450]), type: 'forbidden' } as SceneObject;
    const scene = course(forbidden);
    expect([codes(scene), mended(scene).left]).toEqual([['start-on-forbidden'], []]);
  });

  it('moves a further robot’s start, and leaves the first one where it is', () => {
    const start: SceneObject = { type: 'start', id: 'second', at: [5, 5], heading: 0, robot: null, options: {}, name: '', color: 'teal' }; // prettier-ignore
    const scene = course(start);
    const { scene: after, left } = mended(scene);
    expect([codes(scene), left, after.robot]).toEqual([['robot-outside'], [], scene.robot]);
    expect(object(after, 'second')).toMatchObject({ at: [40, 30] });
  });

  it('numbers checkpoints anew, without doubles and gaps, in the order that they have', () => {
    const zones = [checkpoint('c', [900, 700], 5), checkpoint('a', [200, 200], 2), checkpoint('b', [200, 700], 2)];
    const { scene: after, left } = mended(course(...zones));
    expect(left).toEqual([]);
    expect(['a', 'b', 'c'].map((id) => object(after, id))).toMatchObject([{ number: 1 }, { number: 2 }, { number: 3 }]);
  });

  it('lets targets want no more blocks than there are, the greediest first', () => {
    const wanting = (id: string, x: number, blocks: number): SceneObject => ({ ...target(id, [x, 700]), blocks }) as SceneObject; // prettier-ignore
    const scene = course(wanting('one', 200, 1), wanting('many', 900, 5), block('a', [200, 200]), block('b', [400, 200]), block('c', [900, 200])); // prettier-ignore
    const { scene: after, left } = mended(scene);
    expect([codes(scene), left]).toEqual([['target-wants-too-many-blocks'], []]);
    expect([object(after, 'one'), object(after, 'many')]).toMatchObject([{ blocks: 1 }, { blocks: 2 }]);
  });

  it('does not turn a target for blocks into one for the robot where there is no block at all', () => {
    const scene = course({ ...target('one', [200, 700]), blocks: 2 } as SceneObject);
    expect(mended(scene)).toEqual({ scene, left: ['target-wants-too-many-blocks'] });
  });

  it('makes a target as large as the block that shall go in', () => {
    const small: SceneObject = { ...target('small', [200, 700]), blocks: 1, size: [30, 30] } as SceneObject;
    const { scene: after, left } = mended(course(small, block('a', [200, 200])));
    expect([left, object(after, 'small')]).toMatchObject([[], { size: [70, 70] }]);
  });

  it('parts blocks that stand in each other, and removes copies that nobody sees', () => {
    const { scene: after, left } = mended(course(block('a', [200, 200]), block('b', [220, 200])));
    expect([left, after.objects.length]).toEqual([[], 2]);
    const copies = course(wall('one', [100, 100], [300, 100]), wall('two', [100, 100], [300, 100]));
    expect(codes(copies)).toEqual(['covered']);
    expect(mended(copies).scene.objects).toEqual([copies.objects[1]]);
  });

  it('gives a task a time that would never end', () => {
    const scene: Scene = { ...course(), task: { ...course().task, noTouch: true } };
    expect([codes(scene), mended(scene).scene.task.seconds]).toEqual([['task-without-end'], 60]);
  });

  it('is one step: one edit for all problems, and taking it back is the course as it was', () => {
    const scene = course(block('under', [640, 450]), checkpoint('c', [200, 200], 4));
    const edit = mendAll(scene, findProblems(scene, footprint), footprint);
    expect(edit?.type).toBe('all');
  });
});
