import { describe, expect, it } from 'vitest';
import { plainWorld, type WorldVariant } from '#check/task/task';
import { sceneWith, targetAt, taskWith } from '#check/testing/tasks';
import { applyEdit, type SceneEdit } from '#scene/edit';
import type { Scene, SceneObject } from '#scene/scene';
import {
  facing,
  frameOf,
  movedThing,
  nextThing,
  sceneOfWorld,
  thingAt,
  turnedThing,
  withEdit,
  withRow,
} from './world-things';
import { objectEdit } from './world-objects';

const wall = { type: 'wall', id: 'w', from: [500, 300], to: [500, 600], thickness: 10 } as const;
const kept = { ...wall, id: 'k', from: [100, 100], to: [900, 100], lock: true } as const;
const scene = sceneWith([targetAt(700, 450), wall, kept]);
const { robot } = scene;
const at = ([x, y]: readonly [number, number]) => ({ x, y });

describe('a thing of a small arena', () => {
  it('is found where it lies, the robot first, and nothing that is locked', () => {
    expect(thingAt(scene, at(robot.at), 0)).toBeNull();
    expect(thingAt(scene, { x: 503, y: 400 }, 0)).toBe('w');
    expect(thingAt(scene, { x: 700, y: 450 }, 0)).toBe('t');
    expect(thingAt(scene, { x: 500, y: 100 }, 0)).toBeUndefined();
    expect(nextThing(scene, null, 1)).toBe('t');
    expect(nextThing(scene, 'w', 1)).toBeNull();
    expect(nextThing(scene, null, -1)).toBe('w');
  });

  it('has a frame, unless it is gone', () => {
    expect(frameOf(scene, 'w')).toEqual({ minX: 495, minY: 300, maxX: 505, maxY: 600 });
    expect(frameOf(scene, 'x')).toBeNull();
  });

  it('is moved by whole mm, and its middle stays in the arena', () => {
    const moved = movedThing(scene, 'w', { x: 10.4, y: -20 })!;
    expect(applyEdit(scene, moved).objects[1]).toMatchObject({ from: [510, 280], to: [510, 580] });
    const [width] = scene.size;
    const far = applyEdit(scene, movedThing(scene, null, { x: 1e6, y: 0 })!);
    expect(far.robot.at).toEqual([width, robot.at[1]]);
    expect(movedThing(far, null, { x: 10, y: 0 })).toBeNull();
    expect(movedThing(scene, 'k', { x: 10, y: 0 })).toBeNull();
    const edge = sceneWith([{ ...wall, from: [0, 0], to: [20_000, 0] }], { size: [20_000, 1000] });
    expect(movedThing(edge, 'w', { x: 1000, y: 0 })).toBeNull(); // its end would be where no course has anything
  });

  it('is turned about its middle; the robot faces a place in steps of 5°', () => {
    expect(applyEdit(scene, turnedThing(scene, 'w', 90)!).objects[1]).toMatchObject({
      from: [650, 450],
      to: [350, 450],
    });
    expect(applyEdit(scene, turnedThing(scene, null, -5)!).robot).toMatchObject({ at: robot.at, heading: 355 });
    const [x, y] = robot.at;
    expect(applyEdit(scene, facing(scene, { x: x + 100, y: y + 3 }, 5)).robot.heading).toBe(0);
    expect(applyEdit(scene, facing(scene, { x, y: y + 100 }, 5)).robot.heading).toBe(90);
  });
});

describe('a hidden world', () => {
  const task = taskWith(scene);
  const hidden: WorldVariant = { ...plainWorld, id: '2', hidden: true };
  const sceneOf = (world: WorldVariant): Scene => sceneOfWorld(task, world);
  const after = (world: WorldVariant, thing: string | null, x: number): WorldVariant => ({
    ...world,
    ...withEdit(task, world, sceneOf(world), movedThing(sceneOf(world), thing, { x, y: 0 })!),
  });

  it('keeps what a drag has moved, and nothing of what is back in its place', () => {
    const moved = after(after(hidden, null, 30), 'w', 40);
    expect(moved.start).toEqual({ at: [robot.at[0] + 30, robot.at[1]], heading: robot.heading });
    expect(moved.edits).toHaveLength(1);
    expect(sceneOf(moved).objects.find(({ id }) => id === 'w')).toMatchObject({ from: [540, 300] });
    const back = after(after(moved, null, -30), 'w', -40);
    expect([back.start, back.edits]).toEqual([null, []]);
  });

  it('is not changed where only another thing was: the start stays that of the course', () =>
    expect(after(hidden, 't', 10).start).toBeNull());

  it('has a tag where the block is to which it is stuck, and both or none of them', () => {
    const block = { type: 'block', id: 'b', at: [300, 300], size: [60, 60], angle: 0 } as const;
    const tag = { type: 'tag', id: 'tag', at: [270, 300], number: 7, side: 60, angle: 180 } as const;
    const course = sceneWith([block, tag, targetAt(700, 450)]);
    const own = taskWith(course);
    const shown = (world: WorldVariant): Scene => sceneOfWorld(own, world);
    const by = (world: WorldVariant, edit: SceneEdit): WorldVariant => ({
      ...world,
      ...withEdit(own, world, shown(world), edit),
    });
    const moved = by(hidden, movedThing(course, 'b', { x: 40, y: 0 })!);
    expect(shown(moved).objects.slice(0, 2)).toMatchObject([{ at: [340, 300] }, { at: [310, 300] }]);
    const turned = by(hidden, turnedThing(course, 'b', 90)!);
    expect(shown(turned).objects[1]).toEqual({ ...tag, at: [300, 270], angle: 270 });
    expect(by(moved, movedThing(shown(moved), 'b', { x: -40, y: 0 })!).edits).toEqual([]);
  });

  describe('in its list of differences', () => {
    const block = { type: 'block', id: 'b', at: [300, 300], size: [60, 60], angle: 0 } as const;
    const tag = { type: 'tag', id: 'tag', at: [270, 300], number: 7, side: 60, angle: 180 } as const;
    const far = { ...block, at: [500, 300] } as const;
    const course = sceneWith([block, tag, targetAt(700, 450)]);
    const own = taskWith(course);
    const shown = (world: WorldVariant): readonly SceneObject[] => sceneOfWorld(own, world).objects.slice(0, -1);
    /** The world with the row of an object at a place; `undefined`: the row is binned. */
    const put = (world: WorldVariant, place: number, made: SceneObject | null | undefined): WorldVariant => {
      const rows = made === undefined ? [] : [objectEdit('b', made)];
      return {
        ...world,
        edits: withRow(
          own,
          world,
          world.edits.toSpliced(place, 1, ...rows),
          'b',
          made ?? (made === null ? null : block),
        ),
      };
    };

    it('leaves a block out with its tag, and has both again, where the block is put', () => {
      const gone = put(hidden, 0, null);
      expect(shown(gone)).toEqual([]);
      expect(shown(put(gone, 0, far))).toEqual([far, { ...tag, at: [470, 300] }]);
      const back = put(gone, 0, block);
      expect([shown(back), back.edits]).toEqual([[block, tag], [objectEdit('b', block)]]);
      expect(put(gone, 0, undefined).edits).toEqual([]);
    });

    it('leaves a tag alone that is left out, whatever becomes of its block', () => {
      const world = { ...hidden, edits: [objectEdit('tag', null)] };
      const moved = put(world, 1, far);
      expect(shown(moved)).toEqual([far]);
      expect(put(moved, 1, undefined).edits).toEqual(world.edits);
    });

    it('leaves a tag where it stands elsewhere, and moves it where it is on its block', () => {
      const apart = { ...tag, at: [600, 500] } as const;
      const world = { ...hidden, edits: [objectEdit('tag', apart)] };
      const moved = put(world, 1, far);
      expect(shown(moved)).toEqual([far, apart]);
      expect(shown(put(moved, 1, null))).toEqual([apart]);
      expect(shown(put(put(moved, 1, null), 1, undefined))).toEqual([block, apart]);
      const other = { ...tag, at: [330, 300], angle: 0 } as const;
      const turned = put({ ...hidden, edits: [objectEdit('tag', other)] }, 1, far);
      expect(shown(turned)).toEqual([far, { ...other, at: [530, 300] }]);
      expect(shown(put(turned, 1, undefined))).toEqual([block, other]);
    });
  });
});
