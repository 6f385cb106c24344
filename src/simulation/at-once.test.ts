import { describe, expect, it } from 'vitest';
import { applyEdit, type SceneEdit } from '#scene/edit';
import { stepOf } from '#scene/history';
import { defaultScene, type Scene, type SceneObject } from '#scene/scene';
import { movesBodies } from './at-once';

const wall: SceneObject = { type: 'wall', id: 'w', from: [0, 0], to: [100, 0], thickness: 10 };
const block: SceneObject = { type: 'block', id: 'b', at: [300, 300], size: [50, 50], angle: 0 };
const stroke: SceneObject = { type: 'stroke', id: 's', points: [[0, 0], [9, 9]], width: 20, color: 'black' }; // prettier-ignore
const add = (...objects: readonly SceneObject[]): SceneEdit => ({ type: 'add', objects });
const moves = (edit: SceneEdit, scene: Scene = defaultScene()): boolean => movesBodies(stepOf(scene, edit));

describe('what makes the picture of a stopped run wrong', () => {
  it('is a block that was put somewhere, not a line', () => {
    expect(moves(add(block))).toBe(true);
    expect(moves(add(stroke))).toBe(false);
  });

  it('is a wall that is taken away, also with a line', () => {
    const course = applyEdit(defaultScene(), add(stroke, wall));
    expect(moves({ type: 'remove', ids: ['s'] }, course)).toBe(false);
    expect(moves({ type: 'remove', ids: ['s', 'w'] }, course)).toBe(true);
    expect(moves({ type: 'clear' }, course)).toBe(true);
  });

  it('is another start or size of the arena, not another task', () => {
    expect(moves({ type: 'robot', robot: { heading: 90 } })).toBe(true);
    expect(moves({ type: 'course', changes: { size: [500, 500] } })).toBe(true);
    expect(moves({ type: 'course', changes: { name: 'New', task: { seconds: 10, noTouch: true } } })).toBe(false);
  });
});
