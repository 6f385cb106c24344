import { describe, expect, it } from 'vitest';
import { applyEdit } from '#scene/edit';
import { editProblem } from '#scene/check-edit';
import { sceneLimits } from '#scene/scene';
import { copied, duplicated, pasted } from './clipboard';
import { block, checkpoint, course, stroke } from './testing/desk';
import type { Selection } from './tools/tool';

const of = (ids: readonly string[], robot = false): Selection => ({ ids, robot });

describe('copying', () => {
  it('pastes 20 mm beside the original, with ids of its own, and selects the copies', () => {
    const scene = course(block('block-1', [300, 300]), stroke('s', [100, 100], [200, 100]));
    const copy = duplicated(scene, of(['block-1', 's']));
    expect(copy?.selection).toEqual(of(['block-2', 'stroke-1']));
    expect(copy && applyEdit(scene, copy.edit).objects).toEqual([
      ...scene.objects,
      block('block-2', [320, 280]),
      stroke('stroke-1', [120, 80], [220, 80]),
    ]);
  });

  it('pastes into another course, as plain data that a clipboard can hold', () => {
    const clip = copied(course(block('b', [300, 300])), of(['b']));
    const paste =
      clip && pasted(course(block('block-1', [10, 10])), JSON.parse(JSON.stringify(clip)) as typeof clip, 2);
    expect(paste?.edit).toEqual({ type: 'add', objects: [block('block-2', [340, 260])] });
  });

  it('numbers pasted checkpoints on', () => {
    const scene = course(checkpoint('a', [300, 300], 1), checkpoint('b', [500, 300], 2));
    const copy = duplicated(scene, of(['a', 'b']));
    const after = copy && applyEdit(scene, copy.edit);
    expect(after?.objects.map((object) => (object.type === 'checkpoint' ? object.number : 0))).toEqual([1, 2, 3, 4]);
  });

  it('keeps the copies in the arena', () => {
    const copy = duplicated(course(block('b', [1210, -10])), of(['b']));
    expect(copy?.edit).toMatchObject({ objects: [{ at: [1215, -15] }] });
  });

  it('does nothing without objects; the start of the robot is not copied', () => {
    expect(copied(course(block('b', [300, 300])), of([], true))).toBeNull();
    expect(duplicated(course(), of(['gone']))).toBeNull();
  });

  it('asks for more than a full course takes, so that the editor can say why it refuses', () => {
    const scene = course(...Array.from({ length: sceneLimits.objects - 1 }, (_, i) => block(`b${i}`, [300, 300])));
    expect(duplicated(scene, of(['b0']))?.edit.type).toBe('add');
    const made = duplicated(scene, of(['b0', 'b1']));
    expect(made && editProblem(scene, made.edit)?.code).toBe('too-many');
  });
});
