import { describe, expect, it } from 'vitest';
import { editProblem } from './check-edit';
import { applyEdit, type SceneEdit } from './edit';
import { inverse } from './inverse';
import { defaultScene, type Background, type Block, type Scene, type Stroke } from './scene';

const block = (id: string, x = 100): Block => ({ type: 'block', id, at: [x, 100], size: [50, 50], angle: 0 });
const line = (id: string, count = 2): Stroke => ({
  ...{ type: 'stroke', id, width: 20, color: 'black' },
  points: Array.from({ length: count }, (_, index) => [index % 1000, 0] as const),
});
const empty = defaultScene();
const scene: Scene = { ...empty, objects: [block('a'), line('s'), block('b'), line('t')] };

/** The inverse, held against what it promises. */
function inverseOf(edit: SceneEdit, before = scene): SceneEdit {
  const [after, back] = [applyEdit(before, edit), inverse(before, edit)];
  expect(editProblem(before, edit)).toBeNull();
  expect(editProblem(after, back)).toBeNull();
  expect(applyEdit(after, back)).toEqual(before);
  expect(applyEdit(before, inverse(after, back))).toEqual(after);
  return back;
}

describe('the inverse', () => {
  it('removes what was added, and clears what was the first of its kind', () => {
    expect(inverseOf({ type: 'add', objects: [block('x'), block('y')] })).toEqual({ type: 'remove', ids: ['x', 'y'] });
    expect(inverseOf({ type: 'add', objects: [block('x')], at: [1] })).toEqual({ type: 'remove', ids: ['x'] });
    expect(inverseOf({ type: 'add', objects: [block('x')] }, empty)).toEqual({ type: 'clear' });
  });

  it('puts removed objects back to their places', () => {
    const [a, s, b, t] = scene.objects;
    expect(inverseOf({ type: 'remove', ids: ['b', 'a'] })).toEqual({ type: 'add', objects: [a, b], at: [0, 2] });
    expect(inverseOf({ type: 'remove', ids: ['t'] })).toEqual({ type: 'add', objects: [t] });
    expect(inverseOf({ type: 'remove', ids: ['a', 's', 'b', 't'] })).toEqual({ type: 'add', objects: [a, s, b, t] });
    expect(inverseOf({ type: 'clear' })).toEqual({ type: 'add', objects: [a, s, b, t] });
  });

  it('puts one object back for its pieces, and restores what was replaced by none', () => {
    const [, s, b] = scene.objects;
    const cut: SceneEdit = { type: 'replace', changes: [{ id: 's', by: [line('s'), line('s2', 3)] }, { id: 'b', by: [] }] }; // prettier-ignore
    expect(inverseOf(cut)).toEqual({
      type: 'all',
      edits: [
        { type: 'replace', changes: [{ id: 's', by: [s] }, { id: 's2', by: [] }] }, // prettier-ignore
        { type: 'add', objects: [b], at: [2] },
      ],
    });
    inverseOf({ type: 'replace', changes: [{ id: 'a', by: [block('b', 7)] }, { id: 'b', by: [block('a', 8)] }] }); // prettier-ignore
    inverseOf({ type: 'replace', changes: [{ id: 'a', by: [] }, { id: 'b', by: [block('a', 8), block('b', 9)] }] }); // prettier-ignore
  });

  it('restores the named values of robot or course after a change', () => {
    expect(inverseOf({ type: 'robot', robot: { heading: 90, options: { S1: 'claw' } } })).toEqual({
      type: 'robot',
      robot: { heading: 0, options: {} },
    });
    const background: Background = { at: [0, 0], size: [100, 100], cells: [4, 3], levels: 'AAAA', picture: '' };
    expect(inverseOf({ type: 'course', changes: { name: 'Slalom', background } })).toEqual({
      type: 'course',
      changes: { name: '', background: null },
    });
  });

  it('undoes the last of several first', () => {
    const edits: SceneEdit[] = [
      { type: 'remove', ids: ['s'] },
      {
        type: 'all',
        edits: [
          { type: 'robot', robot: { heading: 9 } },
          { type: 'add', objects: [block('s')] },
        ],
      },
    ];
    expect(inverseOf({ type: 'all', edits })).toEqual({
      type: 'all',
      edits: [
        { type: 'remove', ids: ['s'] },
        { type: 'robot', robot: { heading: 0 } },
        { type: 'add', objects: [line('s')], at: [1] },
      ],
    });
  });

  it('restores the whole course for more than one edit can hold', () => {
    const whole = (of: Scene, edits: readonly SceneEdit[]): void =>
      expect(inverseOf({ type: 'all', edits }, of)).toMatchObject({
        edits: [{ type: 'clear' }, { type: 'add' }, { type: 'robot' }, { type: 'course' }],
      });
    const full: Scene = { ...empty, objects: Array.from({ length: 2000 }, (_, index) => block(`o${index}`)) };
    const clear: SceneEdit = { type: 'clear' };
    const turn: SceneEdit = { type: 'robot', robot: { heading: 9 } };
    whole(full, [clear, { type: 'add', objects: full.objects }, clear, { type: 'add', objects: full.objects }, clear, turn]); // prettier-ignore
    const shorter: SceneEdit = { type: 'replace', changes: [{ id: 's', by: [line('s', 39_999)] }] };
    whole({ ...empty, objects: [line('s', 40_000)] }, [shorter, clear]);
    const changes = full.objects.slice(1, 1200).map(({ id }, index) => [{ id: 'o0', by: [block('o0', index)] }, { id, by: [] }]); // prettier-ignore
    whole(full, changes.map((two): SceneEdit => ({ type: 'replace', changes: two }))); // prettier-ignore
  });
});
