import { describe, expect, it } from 'vitest';
import type { Outline } from './outline';
import { findProblems, MOST_OF_A_KIND, type RuleProblem } from './rules';
import {
  defaultScene,
  type Block,
  type Mover,
  type Scene,
  type SceneObject,
  type Stroke,
  type Wall,
  type Zone,
} from './scene';

/** A robot of 100 × 80 mm whose axle is 20 mm before its middle. */
const footprint: readonly Outline[] = [
  [
    { x: -30, y: -40 },
    { x: 70, y: -40 },
    { x: 70, y: 40 },
    { x: -30, y: 40 },
  ],
];

const wall = (id: string, x: number): Wall => ({ type: 'wall', id, from: [x, 100], to: [x, 700], thickness: 10 });
const block = (id: string, x: number, size = 50): Block => ({
  type: 'block',
  id,
  at: [x, 100],
  size: [size, size],
  angle: 0,
});
const zone = (id: string, change: Partial<Zone>): Zone => ({
  ...{ type: 'target', id, at: [200, 200], size: [200, 200], angle: 0, round: false, number: 0, blocks: 0 },
  ...change,
});
const checkpoint = (id: string, number: number): Zone =>
  zone(id, { type: 'checkpoint', number, at: [100 * number, 200] });
const mover: Mover = {
  ...{ type: 'mover', id: 'm', at: [900, 300], to: [900, 300], size: [50, 50], angle: 0, speed: 100, spiked: false },
};
const stroke = (id: string, x: number): Stroke => ({
  ...{ type: 'stroke', id, width: 20, color: 'black' },
  points: [
    [x, 800],
    [x + 300, 850],
  ],
});

const withObjects = (...objects: readonly SceneObject[]): Scene => ({ ...defaultScene(), objects });
const problemsOf = (scene: Scene): readonly RuleProblem[] => findProblems(scene, footprint);
const only = (scene: Scene): RuleProblem | undefined => {
  const problems = problemsOf(scene);
  expect(problems).toHaveLength(1);
  return problems[0];
};

describe('the rules of a course', () => {
  it('find nothing wrong with an empty one, nor with a good one', () => {
    expect(problemsOf(defaultScene())).toEqual([]);
    const good = withObjects(
      ...[wall('w', 1000), block('b', 300), stroke('s', 300), { ...mover, to: [900, 800] } as const],
      ...[
        checkpoint('c1', 1),
        checkpoint('c2', 2),
        zone('t', { at: [200, 700] }),
        zone('u', { at: [500, 700], blocks: 1 }),
      ],
    );
    expect(problemsOf(good)).toEqual([]);
  });

  it('tell of a robot outside, at its place', () => {
    const scene = { ...defaultScene(), robot: { ...defaultScene().robot, at: [1180, 450] as const } };
    expect(only(scene)).toEqual({
      code: 'robot-outside',
      params: { x: 1180, y: 450, width: 1200, height: 900 },
      message: 'At [1180, 450] the robot is not wholly inside the arena of 1200 × 900 mm. Move it inwards.',
      at: [1180, 450],
      ids: [],
    });
  });

  it.each<[string, SceneObject]>([
    ['wall', wall('x', 650)],
    ['block', { ...block('x', 650), at: [650, 450] }],
    ['spikes', { type: 'spikes', id: 'x', at: [650, 450], size: [50, 50], angle: 45 }],
    ['moving block', { ...mover, id: 'x', at: [650, 450] }],
  ])('tell of a robot inside: %s', (kind, object) => {
    expect(only(withObjects(object))).toMatchObject({
      code: 'robot-inside',
      params: { kind, id: 'x' },
      at: [600, 450],
      ids: ['x'],
    });
  });

  it('let the robot stand flush with a wall, and know its size', () => {
    const flush = withObjects(wall('w', 675));
    expect(problemsOf(flush)).toEqual([]);
    expect(only({ ...flush, robot: { ...flush.robot, scale: 1.1 } })).toMatchObject({ code: 'robot-inside' });
    expect(findProblems(withObjects(wall('w', 650)), [])).toEqual([]);
  });

  it('tell of a start on a forbidden zone, also if only a corner is on it', () => {
    const corner = zone('f', { type: 'forbidden', at: [720, 540], size: [120, 120] });
    expect(only(withObjects(corner))).toMatchObject({ code: 'start-on-forbidden', at: [600, 450], ids: ['f'] });
    expect(problemsOf(withObjects({ ...corner, round: true }))).toEqual([]);
  });

  it('tell of a task that is done at once, and of one that never ends', () => {
    const target = zone('t', { at: [650, 450] });
    expect(only(withObjects(target))).toMatchObject({ code: 'done-at-start', ids: ['t'] });
    expect(problemsOf(withObjects(target, checkpoint('c', 1)))).toEqual([]);
    const noTouch = { ...defaultScene(), task: { seconds: null, noTouch: true } };
    expect(only(noTouch)).toMatchObject({ code: 'task-without-end', at: [600, 450] });
    expect(problemsOf({ ...noTouch, task: { seconds: 30, noTouch: true } })).toEqual([]);
  });

  it('tell of a ring that is missing, and of robots that start outside of it; to start in the ring is right', () => {
    const inRing = (...objects: readonly SceneObject[]) => ({
      ...withObjects(...objects),
      task: { seconds: null, noTouch: false, robots: 'ring' as const },
    });
    const ring = zone('ring', { at: [600, 450], size: [500, 500], round: true });
    const further = { type: 'start', id: 's', heading: 0, robot: null, options: {}, name: '', color: null } as const;
    expect(only(inRing())).toMatchObject({ code: 'no-ring', at: [600, 450], ids: [] });
    expect(problemsOf(inRing(ring, { ...further, at: [500, 600] }))).toEqual([]);
    const outside = inRing(ring, { ...further, at: [1000, 450] });
    expect(only(outside)).toMatchObject({ code: 'start-outside-ring', at: [1000, 450], ids: ['s'] });
  });

  it('tell of what lies outside, with the middle of the place', () => {
    expect(only(withObjects(stroke('s', 2000)))).toMatchObject({ code: 'object-outside', at: [2150, 825], ids: ['s'] });
    expect(problemsOf(withObjects(stroke('s', 1199)))).toEqual([]);
  });

  it('tell of two checkpoints of one number', () => {
    const scene = withObjects(checkpoint('a', 1), checkpoint('b', 2), { ...checkpoint('c', 2), at: [900, 700] });
    expect(only(scene)).toMatchObject({
      code: 'checkpoint-number-twice',
      params: { number: 2, count: 2 },
      ids: ['b', 'c'],
    });
  });

  it('tell of the first number that is missing', () => {
    expect(only(withObjects(checkpoint('a', 4), checkpoint('b', 1), checkpoint('c', 2)))).toMatchObject({
      code: 'checkpoint-gap',
      params: { number: 4, missing: 3 },
      at: [400, 200],
      ids: ['a'],
    });
    expect(only(withObjects(checkpoint('a', 2)))).toMatchObject({ params: { missing: 1 } });
  });

  it('tell of targets that want more blocks than there are', () => {
    const targets = [zone('t', { blocks: 2 }), zone('u', { blocks: 1, at: [500, 500] })];
    expect(only(withObjects(...targets, block('a', 300), block('b', 400)))).toMatchObject({
      code: 'target-wants-too-many-blocks',
      params: { wanted: 3, there: 2 },
      ids: ['t', 'u'],
    });
  });

  it('tell of a target that no block can fit into', () => {
    const target = zone('t', { blocks: 1, size: [300, 40] });
    expect(only(withObjects(target, block('a', 300)))).toMatchObject({ code: 'target-too-small', ids: ['t'] });
    expect(problemsOf(withObjects(target, block('a', 300), block('b', 500, 40)))).toEqual([]);
  });

  it('tell of a moving block that stands still', () => {
    expect(only(withObjects(mover))).toMatchObject({ code: 'mover-still', at: [900, 300], ids: ['m'] });
  });

  it('tell of a block inside a wall or another block, but not of one that leans against it', () => {
    expect(only(withObjects(wall('w', 1000), block('b', 980)))).toMatchObject({
      code: 'block-inside',
      ids: ['b', 'w'],
    });
    expect(only(withObjects(block('a', 300), block('b', 340)))).toMatchObject({ code: 'block-inside' });
    expect(problemsOf(withObjects(wall('w', 1000), block('b', 970), block('c', 920)))).toEqual([]);
  });

  it('tell of the same thing twice at one place, and only if it is the same', () => {
    expect(only(withObjects(stroke('a', 100), stroke('b', 500), stroke('c', 100)))).toMatchObject({
      code: 'covered',
      params: { kind: 'stroke', count: 2 },
      ids: ['a', 'c'],
    });
    expect(problemsOf(withObjects(stroke('a', 100), { ...stroke('b', 100), width: 30 }))).toEqual([]);
    expect(problemsOf(withObjects(wall('a', 100), wall('b', 100), wall('c', 100)))).toHaveLength(1);
  });

  it('list at most 20 of a kind, also for 2000 blocks in one heap', () => {
    const heap = Array.from({ length: 2000 }, (_, index) => block(`b${index}`, 300 + (index % 3)));
    const problems = problemsOf(withObjects(...heap));
    expect(problems.filter(({ code }) => code === 'block-inside')).toHaveLength(MOST_OF_A_KIND);
    expect(problems.filter(({ code }) => code === 'covered')).toHaveLength(3);
  });
});
