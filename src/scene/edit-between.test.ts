import { describe, expect, it } from 'vitest';

import { createRng } from '#core/rng';

import { applyEdit, type SceneEdit } from './edit';
import { editBetween } from './edit-between';
import { defaultScene, type Block, type Scene } from './scene';

const block = (id: string, x = 0): Block => ({ type: 'block', id, at: [x, 0], size: [50, 50], turn: 0 });
const empty = defaultScene();
const withBlocks = (...ids: string[]): Scene => ({ ...empty, objects: ids.map((id) => block(id)) });

/** The edit that was found, and that it does what it must. */
function found(before: Scene, after: Scene): SceneEdit | null {
  const edit = editBetween(before, after);
  expect(edit === null ? before : applyEdit(before, edit)).toEqual(after);
  return edit;
}

describe('the edit between two courses', () => {
  it('is none between a course and itself', () => {
    const scene = withBlocks('a');
    expect(found(scene, scene)).toBeNull();
  });

  it('adds what lies on top and removes what is gone', () => {
    const [one, two] = [withBlocks('a'), withBlocks('a', 'b')];
    const after = { ...two, objects: [one.objects[0]!, two.objects[1]!] };
    expect(found(one, after)).toEqual({ type: 'add', objects: [block('b')] });
    expect(found(after, { ...one, objects: after.objects.slice(1) })).toEqual({ type: 'remove', ids: ['a'] });
  });

  it('puts an object back between two others', () => {
    const before = withBlocks('a', 'b', 'c');
    const without = applyEdit(before, { type: 'remove', ids: ['b'] });
    expect(found(without, before)).toEqual({
      type: 'replace',
      changes: [{ id: 'a', by: [block('a'), block('b')] }],
    });
  });

  it('puts objects back below all others', () => {
    const before = withBlocks('a', 'b', 'c');
    found(applyEdit(before, { type: 'remove', ids: ['a', 'b'] }), before);
  });

  it('tells only the object that moved', () => {
    const before = withBlocks('a', 'b');
    const after = applyEdit(before, { type: 'replace', changes: [{ id: 'b', by: [block('b', 100)] }] });
    expect(found(before, after)).toEqual({ type: 'replace', changes: [{ id: 'b', by: [block('b', 100)] }] });
  });

  it('begins anew where the order is another one', () => {
    found(withBlocks('a', 'b'), withBlocks('b', 'a'));
    found(withBlocks('a'), withBlocks('b'));
    found(withBlocks('a'), withBlocks());
    found(withBlocks(), withBlocks('b'));
  });

  it('tells the start, the task and the size', () => {
    const before = withBlocks('a');
    const after: Scene = {
      ...before,
      name: 'Other',
      size: [500, 400],
      task: { seconds: 10, noTouch: true },
      robot: { ...before.robot, heading: 90 },
    };
    expect(found(before, after)).toMatchObject({ type: 'all' });
  });

  it('leads from any of 500 courses to the next', () => {
    const rng = createRng(5);
    const pick = (): Scene => {
      const ids = ['a', 'b', 'c', 'd', 'e', 'f', 'g'].filter(() => rng.unit() < 0.6);
      return {
        ...empty,
        objects: ids.map((id) => block(id, rng.unit() < 0.3 ? 50 : 0)).sort(() => (rng.unit() < 0.1 ? -1 : 0)),
      };
    };
    let before = pick();
    for (let round = 0; round < 500; round += 1) {
      const after = pick();
      found(before, after);
      before = after;
    }
  });
});
