import { describe, expect, it } from 'vitest';
import { applyEdit } from '#scene/edit';
import { editProblem } from '#scene/check-edit';
import { sceneLimits, type SceneObject } from '#scene/scene';
import { copied, copiedBy, copiesMade, duplicated, pasted } from './clipboard';
import { block, checkpoint, course, footprint, stroke, target, wall } from './testing/desk';
import type { Selection } from './tools/tool';

const of = (ids: readonly string[], robot = false): Selection => ({ ids, robot });

describe('copying', () => {
  it('puts copies beside the originals by their own extent, with ids of their own, and selects them', () => {
    const scene = course(block('block-1', [300, 300]), stroke('s', [300, 350], [300, 450]));
    const copy = duplicated(scene, of(['block-1', 's']));
    expect(copy?.selection).toEqual(of(['block-2', 'stroke-1']));
    expect(copy && applyEdit(scene, copy.edit).objects).toEqual([
      ...scene.objects,
      block('block-2', [360, 300]),
      stroke('stroke-1', [360, 350], [360, 450]),
    ]);
  });

  it('takes the first side that is free: right, left, below, above; for a level line below first', () => {
    const place = (...others: readonly SceneObject[]) => {
      const made = duplicated(course(block('b', [100, 850]), ...others), of(['b']), null, footprint);
      const [first] = made?.edit.type === 'add' ? made.edit.objects : [];
      return first && 'at' in first ? first.at : null;
    };
    expect(place()).toEqual([160, 850]);
    const walled = wall('w', [150, 700], [150, 900]);
    expect(place(walled)).toEqual([220, 850]);
    expect(place(walled, wall('v', [1000, 0], [1000, 900]), wall('u', [150, 830], [1000, 830]))).toEqual([1060, 850]);
    const right = wall('w', [130, 850], [1200, 850]);
    expect(place(right)).toEqual([40, 850]);
    expect(place(right, wall('v', [70, 870], [20, 870]))).toEqual([100, 790]);
    const line = duplicated(course(wall('w', [100, 500], [400, 500])), of(['w']));
    expect(line?.edit).toMatchObject({ objects: [wall('wall-1', [100, 480], [400, 480])] });
  });

  it('never puts a copy into another thing or the robot, but onto a field', () => {
    const scene = course(target('t', [540, 450]), block('b', [500, 450]));
    const copy = duplicated(scene, of(['b']), null, footprint);
    expect(copy?.edit).toMatchObject({ objects: [{ at: [740, 450] }] });
  });

  it('puts a copy that has room nowhere 20 mm aside, where it can be seen', () => {
    const copy = duplicated(course(stroke('s', [10, 10], [1190, 890])), of(['s']));
    expect(copy?.edit).toMatchObject({ objects: [{ points: [[30, -10], [1210, 870]] }] }); // prettier-ignore
  });

  it('goes on in the direction and distance of the last copy, also after it was moved', () => {
    let scene = course(block('b', [300, 300]));
    const first = duplicated(scene, of(['b']))!;
    scene = applyEdit(scene, first.edit);
    const second = duplicated(scene, first.selection, first.copies);
    expect(second?.edit).toEqual({ type: 'add', objects: [block('block-2', [420, 300])] });
    scene = applyEdit(scene, { type: 'replace', changes: [{ id: 'block-1', by: [block('block-1', [350, 400])] }] });
    const third = duplicated(scene, first.selection, first.copies);
    expect(third?.edit).toEqual({ type: 'add', objects: [block('block-2', [400, 500])] });
    expect(duplicated(scene, of(['b']), first.copies)?.edit).toMatchObject({ objects: [{ at: [360, 300] }] });
  });

  it('goes on by the step of copies that were dragged with Alt', () => {
    let scene = course(block('b', [100, 300]));
    const dragged = copiedBy(scene, of(['b']), { x: 200, y: 0 })!;
    const copies = copiesMade(scene, dragged.edit);
    scene = applyEdit(scene, dragged.edit);
    expect(duplicated(scene, dragged.selection, copies)?.edit).toMatchObject({ objects: [{ at: [500, 300] }] });
    expect(copiesMade(scene, { type: 'add', objects: [block('new', [0, 0])] })).toBeNull();
    expect(copiesMade(scene, { type: 'remove', ids: ['b'] })).toBeNull();
  });

  it('pastes into another course where it was, as plain data that a clipboard can hold', () => {
    const clip = copied(course(block('b', [300, 300])), of(['b']))!;
    const plain = JSON.parse(JSON.stringify(clip)) as typeof clip;
    expect(pasted(course(block('block-1', [10, 10])), plain)?.edit).toEqual({
      type: 'add',
      objects: [block('block-2', [300, 300])],
    });
    expect(pasted(course(block('block-1', [300, 300])), plain)?.edit).toMatchObject({ objects: [{ at: [360, 300] }] });
  });

  it('pastes at the pointer by whole cm, and beside it where something is there', () => {
    const clip = copied(course(block('b', [305, 300])), of(['b']))!;
    expect(pasted(course(), clip, { x: 811, y: 197 })?.edit).toMatchObject({ objects: [{ at: [815, 200] }] });
    const taken = course(block('b', [800, 200]));
    expect(pasted(taken, clip, { x: 811, y: 197 })?.edit).toMatchObject({ objects: [{ at: [875, 200] }] });
  });

  it('copies by the step of a drag; nothing where it would lie on its original', () => {
    const scene = course(block('b', [300, 300]));
    expect(copiedBy(scene, of(['b']), { x: 20, y: 0.4 })?.edit).toMatchObject({ objects: [{ at: [320, 300] }] });
    expect(copiedBy(scene, of(['b']), { x: 0.2, y: 0 })).toBeNull();
  });

  it('numbers pasted checkpoints on', () => {
    const scene = course(checkpoint('a', [300, 300], 1), checkpoint('b', [500, 300], 2));
    const copy = duplicated(scene, of(['a', 'b']));
    const after = copy && applyEdit(scene, copy.edit);
    expect(after?.objects.map((object) => (object.type === 'checkpoint' ? object.number : 0))).toEqual([1, 2, 3, 4]);
  });

  it('keeps the copies in the arena', () => {
    expect(duplicated(course(block('b', [1170, 300])), of(['b']))?.edit).toMatchObject({
      objects: [{ at: [1110, 300] }],
    });
    const copy = pasted(course(), { objects: [block('b', [300, 300])] }, { x: 5000, y: -5000 });
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
