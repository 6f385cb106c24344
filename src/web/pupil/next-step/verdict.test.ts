import { describe, expect, it } from 'vitest';
import { hasTask } from '#simulation/task/task-brief';
import { defaultScene, type Scene, type SceneObject, type Zone } from '#scene/scene';
import { verdictAtStart } from '#simulation/task/verdict-at-start';
import { goalsOf, placeToShow, secondsLeft } from './verdict-view';

const zone = (part: Partial<Zone>): Zone => ({
  type: 'target',
  id: 'z',
  at: [100, 200],
  size: [100, 100],
  angle: 0,
  round: false,
  number: 0,
  blocks: 0,
  ...part,
});
const course = (objects: readonly SceneObject[], task: Partial<Scene['task']> = {}): Scene => {
  const scene = defaultScene();
  return { ...scene, objects, task: { ...scene.task, ...task } };
};
const wall: SceneObject = { type: 'wall', id: 'w', from: [0, 100], to: [200, 100], thickness: 10 };

describe('the task of a course', () => {
  it('is there with a zone, spikes, a time limit or the wish to touch nothing; walls and lines ask for nothing', () => {
    expect(hasTask(course([wall]))).toBe(false);
    expect(hasTask(course([wall, zone({})]))).toBe(true);
    expect(hasTask(course([wall], { noTouch: true }))).toBe(true);
    expect(hasTask(course([], { seconds: 20 }))).toBe(true);
    const mover = { type: 'mover', id: 'm', at: [0, 0], to: [9, 9], size: [50, 50], angle: 0, speed: 100 } as const;
    expect(hasTask(course([{ ...mover, spiked: false }]))).toBe(false);
    expect(hasTask(course([{ ...mover, spiked: true }]))).toBe(true);
  });

  it('counts checkpoints, targets for the robot and blocks that targets want before the start', () => {
    const scene = course([
      zone({ id: 'a', type: 'checkpoint', number: 1 }),
      zone({ id: 'b', type: 'checkpoint', number: 2 }),
      zone({ id: 'c' }),
      zone({ id: 'd', blocks: 3 }),
    ]);
    expect(goalsOf(verdictAtStart(scene))).toEqual([
      { id: 'checkpoints', done: 0, of: 2 },
      { id: 'targets', done: 0, of: 1 },
      { id: 'blocks', done: 0, of: 3 },
    ]);
  });
});

describe('the time that is left', () => {
  it('begins with all of it, shows the last second until it is over, and stays 0', () => {
    expect(secondsLeft(20, 0)).toBe(20);
    expect(secondsLeft(20, 19_000_001)).toBe(1);
    expect(secondsLeft(20, 20_000_000)).toBe(0);
    expect(secondsLeft(20, 25_000_000)).toBe(0);
    expect(secondsLeft(null, 5)).toBeNull();
  });
});

describe('what was touched', () => {
  const scene = course([wall, zone({ id: 'z' })]);
  const failed = { ...verdictAtStart(scene), state: 'failed', reason: 'touched' } as const;
  const at = (xMm: number, yMm: number) => ({ place: { xMm, yMm } });

  it('is shown in its middle, a wall where the robot was; what has been removed is nowhere', () => {
    expect(placeToShow(scene, { ...failed, by: 'z', ...at(5, 5) })).toEqual({ x: 100, y: 200 });
    expect(placeToShow(scene, { ...failed, by: 'w', ...at(150, 130) })).toEqual({ x: 150, y: 100 });
    expect(placeToShow(scene, { ...failed, by: 'w', ...at(900, 130) })).toEqual({ x: 200, y: 100 });
    expect(placeToShow(scene, { ...failed, by: 'gone', ...at(5, 5) })).toBeNull();
  });

  it('is the nearest point of the edge where it was the edge', () => {
    expect(placeToShow(scene, { ...failed, by: null, ...at(1150, 300) })).toEqual({ x: 1200, y: 300 });
    expect(placeToShow(scene, { ...failed, by: null, ...at(600, 40) })).toEqual({ x: 600, y: 0 });
  });

  it('is what came too early where the task is not done or the time is over, else nothing', () => {
    const early = { id: 'z', number: 2, before: 1 };
    expect(placeToShow(scene, { ...verdictAtStart(scene), early })).toEqual({ x: 100, y: 200 });
    expect(placeToShow(scene, { ...failed, reason: 'time', early, ...at(5, 5) })).toEqual({ x: 100, y: 200 });
    expect(placeToShow(scene, { ...failed, reason: 'time', ...at(5, 5) })).toBeNull();
    expect(placeToShow(scene, { ...failed, state: 'passed', reason: null, ...at(5, 5) })).toBeNull();
  });
});
