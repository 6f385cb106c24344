import { describe, expect, it } from 'vitest';
import { applyEdit } from '#scene/edit';
import type { Scene } from '#scene/scene';
import { middleOfSelection, nudged, turnedByEighths } from './arrange';
import { block, course, footprint, mover, stroke, wall } from './testing/desk';
import type { Selection } from './tools/tool';

const of = (ids: readonly string[], robot = false): Selection => ({ ids, robot });
const nudge = (scene: Scene, selection: Selection, dx: number, dy: number): Scene => {
  const edit = nudged(scene, selection, dx, dy, footprint);
  return edit ? applyEdit(scene, edit) : scene;
};

describe('nudging', () => {
  it('moves everything that is selected by whole mm, and nothing else', () => {
    const scene = course(
      wall('w', [100, 100], [200, 100]),
      stroke('s', [10, 20], [30, 40]),
      mover('m', [300, 300], [400, 300]),
      block('b', [500, 500]),
    );
    const after = nudge(scene, of(['w', 's', 'm']), -1, 10);
    expect(after.objects).toEqual([
      wall('w', [99, 110], [199, 110]),
      stroke('s', [9, 30], [29, 50]),
      mover('m', [299, 310], [399, 310]),
      block('b', [500, 500]),
    ]);
    expect(after.objects[3]).toBe(scene.objects[3]);
  });

  it('moves the start of the robot with the objects, in one edit', () => {
    const after = nudge(course(block('b', [300, 300])), of(['b'], true), 10, 0);
    expect(after.objects).toEqual([block('b', [310, 300])]);
    expect(after.robot.at).toEqual([610, 450]);
  });

  it('stops where only 10 mm of a thing are left in the arena', () => {
    const scene = course(block('b', [1214, 300]));
    expect(nudge(scene, of(['b']), 10, 0).objects).toEqual([block('b', [1215, 300])]);
    expect(nudged(course(block('b', [1215, 300])), of(['b']), 1, 0)).toBeNull();
  });

  it('brings back what lies far outside', () => {
    const scene = course(block('b', [5000, 300]));
    expect(nudge(scene, of(['b']), -10, 0).objects).toEqual([block('b', [4990, 300])]);
    expect(nudge(scene, of(['b']), 10, 0)).toBe(scene);
  });

  it('is nothing without a selection', () => {
    expect(nudged(course(block('b', [300, 300])), of([]), 10, 0)).toBeNull();
  });
});

describe('turning a selection', () => {
  it('turns several by eighths about the middle of their middles', () => {
    const scene = course(block('a', [300, 300]), block('b', [500, 300]));
    expect(middleOfSelection(scene, of(['a', 'b']))).toEqual({ x: 400, y: 300 });
    const edit = turnedByEighths(scene, of(['a', 'b']), 2);
    expect(edit && applyEdit(scene, edit).objects).toEqual([block('a', [400, 200], 2), block('b', [400, 400], 2)]);
  });

  it('takes the robot along', () => {
    const scene = course(block('a', [400, 450]));
    const edit = turnedByEighths(scene, of(['a'], true), 4, footprint);
    const after = edit && applyEdit(scene, edit);
    expect(after?.robot).toMatchObject({ at: [400, 450], heading: 180 });
    expect(after?.objects).toEqual([block('a', [600, 450], 4)]);
  });

  it('is nothing by a whole turn', () => {
    expect(turnedByEighths(course(block('a', [300, 300])), of(['a']), 8)).toBeNull();
  });
});
