import { describe, expect, it } from 'vitest';

import { applyEdit, type SceneEdit } from '#scene/edit';
import { defaultScene, type SceneObject } from '#scene/scene';

import { waitsForStart } from './waiting';

const start = defaultScene();
const wall: SceneObject = { type: 'wall', id: 'w', from: [0, 0], to: [100, 0], thickness: 10 };
const block: SceneObject = { type: 'block', id: 'b', at: [300, 300], size: [50, 50], angle: 0 };
const stroke: SceneObject = { type: 'stroke', id: 's', points: [[0, 0], [9, 9]], width: 20, color: 'black' }; // prettier-ignore
const after = (...edits: readonly SceneEdit[]) => edits.reduce(applyEdit, start);
const add = (...objects: readonly SceneObject[]): SceneEdit => ({ type: 'add', objects });

describe('what of a change waits for the next start', () => {
  it('is a wall, the robot’s start and the size of the arena', () => {
    expect(waitsForStart(start, after(add(wall)))).toBe(true);
    expect(waitsForStart(start, after({ type: 'robot', robot: { at: [100, 100] } }))).toBe(true);
    expect(waitsForStart(start, after({ type: 'course', changes: { size: [500, 500] } }))).toBe(true);
  });
  it('is no line, no block and no task', () => {
    expect(waitsForStart(start, after(add(stroke, block)))).toBe(false);
    const task = { seconds: 10, noTouch: true };
    expect(waitsForStart(start, after({ type: 'course', changes: { task } }))).toBe(false);
  });
  it('is nothing once the wall has gone again', () =>
    expect(waitsForStart(start, after(add(stroke, wall), { type: 'remove', ids: ['w'] }))).toBe(false));
});
