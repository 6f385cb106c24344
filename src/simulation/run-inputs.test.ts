import { describe, expect, it } from 'vitest';
import { Clock } from '#core/clock';
import { defaultScene, type Scene, type SceneObject } from '#scene/scene';
import { CourseWorld } from './course/course-world';
import type { InputAction, InputEvent } from './input';
import { RunInputs } from './run-inputs';

const block = (id: string): SceneObject => ({ type: 'block', id, at: [300, 300], size: [50, 50], angle: 0 });
const scene: Scene = { ...defaultScene(), size: [1200, 900], objects: [block('b')] };
const interrupt: InputAction = { type: 'interrupt' };
const remove: InputAction = { type: 'edit', edit: { type: 'remove', ids: ['b'] } };
const lift: InputAction = { type: 'place-block', id: 'b', pose: { xMm: 100, yMm: 100, headingDeg: 0 } };

/** Inputs of a run whose check asks only whether the block that is moved exists. */
function inputs(replayed: readonly InputEvent[] = []) {
  const clock = new Clock();
  const arena = new CourseWorld(scene);
  const check = (action: InputAction, _course: Scene, movable: ReadonlySet<string>): string | null =>
    action.type === 'place-block' && !movable.has(action.id) ? `There is no block ${action.id}.` : null;
  return { clock, arena, inputs: new RunInputs(replayed, { names: ['1'], checks: [check] }, arena, clock) };
}

describe('what is done to a run', () => {
  it('is taken once, logged with the time at which it takes effect', () => {
    const { inputs: it } = inputs();
    it.add(interrupt);
    expect(it.takeDue()).toEqual({ action: interrupt, device: null });
    expect(it.takeDue()).toBeNull();
    expect(it.log).toEqual([{ timeUs: 0, action: interrupt }]);
  });

  it('waits for its time when it is replayed', () => {
    const { clock, inputs: it } = inputs([{ timeUs: 8000, action: interrupt }]);
    expect(it.takeDue()).toBeNull();
    clock.advanceTo(8000);
    expect(it.takeDue()).toEqual({ action: interrupt, device: null });
    expect(it.log).toEqual([{ timeUs: 8000, action: interrupt }]);
  });

  it('is refused in words when it is impossible, and leaves no trace', () => {
    const { inputs: it } = inputs();
    expect(() => it.add({ ...lift, id: 'x' })).toThrow(new RangeError('There is no block x.'));
    expect(it.takeDue()).toBeNull();
    expect(it.log).toEqual([]);
  });

  it('is checked after the edits that wait for the same step', () => {
    const { inputs: it } = inputs();
    it.add(lift);
    it.add(remove);
    expect(() => it.add(lift)).toThrow('There is no block b.');
  });

  it('is passed over when an edit meanwhile has removed what it is about', () => {
    const { arena, clock, inputs: it } = inputs([{ timeUs: 4000, action: lift }]);
    arena.take({ ...scene, objects: [] });
    clock.advanceTo(4000);
    expect(it.takeDue()).toBeNull();
    expect(it.log).toEqual([]);
  });
});
