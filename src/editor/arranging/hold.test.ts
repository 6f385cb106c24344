import { describe, expect, it } from 'vitest';
import { applyEdit, type SceneEdit } from '#scene/edit';
import { inverse } from '#scene/inverse';
import type { RuleProblem } from '#scene/rules';
import type { Scene, SceneObject, Stroke } from '#scene/scene';
import { movingSelection, turnedBy } from '../arrange';
import { copied, duplicated, pasted } from '../clipboard';
import { describeEdit } from '../describe-edit';
import { handlesOf } from '../handles';
import { middleOf } from '../kinds/index';
import { thingsInLasso } from '../lasso';
import { puttingJoined } from '../lines/join-lines';
import { mendOf } from '../mends/mends';
import { withField } from '../object-edits';
import { removed, selectAll, takenBy, thingsAt, thingsIn } from '../selection';
import { block, checkpoint, contextOf, course, drag, footprint, stroke, used, wall } from '../testing/desk';
import { eraserTool } from '../tools/eraser-tool';
import { mazeTool } from '../tools/maze-tool';
import { nothingSelected, type Selection } from '../tools/tool';
import { aligned, distributed } from './align';
import { grouped, locked, ungrouped, unlocked } from './hold';
import { mirrored } from './mirror';
import { reordered } from './order';

const selectionOf = (...ids: readonly string[]): Selection => ({ ids, robot: false });
const fixed = (object: SceneObject): SceneObject => ({ ...object, lock: true });
/** A stroke that is being drawn. */
const drawn = (...line: Parameters<typeof stroke>): Stroke => stroke(...line) as Stroke;
const inGroup = (group: string, object: SceneObject): SceneObject => ({ ...object, group });
const after = (scene: Scene, edit: SceneEdit | null): readonly SceneObject[] =>
  (edit ? applyEdit(scene, edit) : scene).objects;

describe('a lock', () => {
  const scene = course(block('a', [300, 300]), block('b', [500, 300]));

  it('is put on and taken off, each as one step that can be taken back', () => {
    const edit = locked(scene, selectionOf('a'))!;
    const held = applyEdit(scene, edit);
    expect(held.objects).toEqual([fixed(block('a', [300, 300])), block('b', [500, 300])]);
    expect(applyEdit(held, inverse(scene, edit))).toEqual(scene);
    expect([locked(held, selectionOf('a')), unlocked(scene, selectionOf('a', 'b'))]).toEqual([null, null]);
    expect(after(held, unlocked(held, selectionOf('a', 'b')))).toEqual(scene.objects);
  });

  it('is told as what it is', () => {
    const held = course(fixed(block('a', [300, 300])), block('b', [500, 300]));
    expect(describeEdit(scene, locked(scene, selectionOf('a', 'b'))!)).toEqual({ type: 'locked', kind: 'block', count: 2 }); // prettier-ignore
    expect(describeEdit(held, unlocked(held, selectionOf('a'))!)).toEqual({ type: 'unlocked', kind: 'block', count: 1 }); // prettier-ignore
  });
});

describe('what is locked', () => {
  const held = course(
    fixed(block('a', [300, 300])),
    block('b', [500, 300]),
    fixed(stroke('s', [100, 600], [800, 600])),
  );
  const all = selectionOf('a', 'b', 's');

  it('is caught by no tap, no frame and no lasso, nor with all there is', () => {
    expect(thingsAt(held, { x: 300, y: 300 }, 8)).toEqual([]);
    expect(thingsIn(held, { x: 0, y: 0 }, { x: 1200, y: 900 })).toEqual(selectionOf('b'));
    expect(thingsInLasso(held, drag([0, 0], [1200, 0], [1200, 900], [0, 900]).path)).toEqual(selectionOf('b'));
    expect(selectAll(held, false)).toEqual(selectionOf('b'));
  });

  it('is found where somebody asks for the menu of it', () => {
    expect(thingsAt(held, { x: 300, y: 300 }, 8, [], () => true)).toEqual(['a']);
  });

  it('has no handles', () => {
    expect(handlesOf(held, selectionOf('a'), footprint)).toEqual([]);
    expect(handlesOf(held, selectionOf('b'), footprint)).not.toEqual([]);
  });

  it('stays as it is whatever is done to all that is selected', () => {
    const edits = [
      movingSelection(held, all, { x: 50, y: 0 }),
      turnedBy(held, all, 30),
      mirrored(held, all, 'x'),
      reordered(course(block('x', [300, 300]), ...held.objects), all, 'back'),
      removed(held, all),
    ];
    for (const edit of edits) {
      expect(edit).not.toBeNull();
      expect(after(held, edit).filter(({ lock }) => lock)).toEqual([held.objects[0], held.objects[2]]);
    }
    expect([removed(held, selectionOf('a')), aligned(held, all, 'left')]).toEqual([null, null]);
  });

  it('takes no numbers, not even by giving a checkpoint its number', () => {
    expect(withField(held, 'a', 'x', 400)).toBeNull();
    const numbers = course(checkpoint('one', [200, 200], 1), fixed(checkpoint('two', [500, 500], 2)));
    expect(withField(numbers, 'one', 'number', 2)).toBeNull();
    expect(withField(numbers, 'one', 'number', 3)).not.toBeNull();
  });

  it('is passed over by the eraser', () => {
    expect(used(eraserTool, drag([300, 300]), contextOf(held))).toBe(held);
    expect(used(eraserTool, drag([100, 300], [700, 300], [700, 700]), contextOf(held)).objects).toEqual([
      held.objects[0],
      held.objects[2],
    ]);
  });

  it('becomes no part of a new line or wall', () => {
    expect(after(held, puttingJoined(held, drawn('new', [800, 600], [900, 700])))).toHaveLength(4);
    const maze = course(fixed(wall('w', [200, 200], [400, 200])));
    const [first] = used(mazeTool, drag([500, 200]), contextOf(maze, { mazeCell: 200 })).objects;
    expect(first).toEqual(maze.objects[0]);
    expect(used(mazeTool, drag([300, 200]), contextOf(maze, { mazeCell: 200 }))).toBe(maze);
  });

  it('is mended by nobody', () => {
    const outside = course(fixed(block('a', [-40, 300])));
    const problem: RuleProblem = { code: 'object-outside', ids: ['a'], at: [-40, 300], params: { id: 'a' } } as never;
    expect(mendOf(outside, problem, footprint)).toBeNull();
    expect(mendOf(course(block('a', [-40, 300])), problem, footprint)).toMatchObject({ kind: 'bring-in' });
  });

  it('can be copied, and the copy is free', () => {
    const clip = copied(held, selectionOf('a'))!;
    for (const made of [duplicated(held, selectionOf('a')), pasted(held, clip)])
      expect(made?.edit).toMatchObject({ type: 'add', objects: [expect.not.objectContaining({ lock: true })] });
  });
});

describe('a group', () => {
  const scene = course(block('a', [300, 300]), block('b', [500, 300]), block('c', [700, 300]));
  const pair = applyEdit(scene, grouped(scene, selectionOf('a', 'b'))!);

  it('is made of what is selected, and dissolved, each as one step that can be taken back', () => {
    expect(pair.objects.map(({ group }) => group)).toEqual(['group-1', 'group-1', undefined]);
    const edit = ungrouped(pair, selectionOf('a'))!;
    const apart = applyEdit(pair, edit);
    expect(apart).toEqual(scene);
    expect(applyEdit(apart, inverse(pair, edit))).toEqual(pair);
    expect(describeEdit(scene, grouped(scene, selectionOf('a', 'b'))!)).toMatchObject({ type: 'grouped', count: 2 });
    expect(describeEdit(pair, edit)).toMatchObject({ type: 'ungrouped', count: 2 });
  });

  it('needs two things, and is not made again', () => {
    expect(grouped(scene, selectionOf('a'))).toBeNull();
    expect(grouped(pair, selectionOf('a', 'b'))).toBeNull();
    expect(ungrouped(scene, selectionOf('a', 'b'))).toBeNull();
  });

  it('takes another one in: groups are not nested', () => {
    const one = applyEdit(pair, grouped(pair, selectionOf('a', 'b', 'c'))!);
    expect(new Set(one.objects.map(({ group }) => group)).size).toBe(1);
  });

  it('is taken as a whole by a tap, a frame and a lasso', () => {
    expect(takenBy(pair, 'a', nothingSelected)).toEqual(selectionOf('a', 'b'));
    expect(takenBy(pair, 'c', nothingSelected)).toEqual(selectionOf('c'));
    expect(thingsIn(pair, { x: 250, y: 250 }, { x: 350, y: 350 })).toEqual(selectionOf('a', 'b'));
    expect(thingsInLasso(pair, drag([250, 250], [350, 250], [350, 350], [250, 350]).path)).toEqual(
      selectionOf('a', 'b'),
    );
  });

  it('gives one of it where one of it is selected already', () => {
    expect(takenBy(pair, 'b', selectionOf('a'))).toEqual(selectionOf('b'));
    expect(takenBy(pair, 'b', selectionOf('a', 'b'))).toEqual(selectionOf('a', 'b'));
  });

  it('goes as one thing where things are aligned and spread', () => {
    const three = course(
      ...[inGroup('g', block('a', [100, 300])), inGroup('g', block('b', [200, 400]))],
      ...[block('c', [500, 200]), block('d', [900, 600])],
    );
    const places = after(three, aligned(three, selectionOf('a', 'b', 'c', 'd'), 'top')).map(middleOf);
    expect(places).toEqual([{ x: 100, y: 500 }, { x: 200, y: 600 }, { x: 500, y: 600 }, { x: 900, y: 600 }]); // prettier-ignore
    expect(distributed(three, selectionOf('a', 'b', 'c'), 'x')).toBeNull();
  });

  it('is locked and unlocked as a whole', () => {
    const held = applyEdit(pair, locked(pair, takenBy(pair, 'a', nothingSelected))!);
    expect(held.objects.map(({ lock }) => lock)).toEqual([true, true, undefined]);
    expect(takenBy(held, 'a', nothingSelected)).toEqual(selectionOf('a', 'b'));
  });

  it('keeps a line of it that is drawn on', () => {
    const lines = course(inGroup('g', stroke('s', [100, 100], [300, 100])), inGroup('g', block('b', [500, 500])));
    expect(after(lines, puttingJoined(lines, drawn('new', [300, 100], [400, 200])))[0]).toMatchObject({ id: 's', group: 'g' }); // prettier-ignore
  });
});
