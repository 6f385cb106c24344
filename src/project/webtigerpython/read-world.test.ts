import { describe, expect, it } from 'vitest';

import { fuzzRuns } from '#core/testing/fuzz-runs';
import { parseScene } from '#scene/parse';
import { sceneLimits, type Scene, type SceneObject } from '#scene/scene';
import { serializeScene } from '#scene/serialize';
import { forManySeeds, inPercent, wholeFrom } from '#scene/testing/fuzz';

import { readWorld, withStartInside, type World } from './read-world';
import { noteText } from './say';
import { BLOCK_MM, UNIT_MM, WALL_MM } from './world';
import { writeWorld } from './write-world';

const arena = { playgroundSize: [2000, 1000], StartBox: [500, 600, 0] };
/** A world in an arena of 2000 × 1000 with a start in it. */
function world(value: object): World {
  const read = readWorld({ ...arena, ...value });
  if (read === null) throw new Error('This is a world.');
  return read;
}
const objects = (value: object): readonly SceneObject[] => world(value).scene.objects;
const said = (value: object): readonly string[] => world(value).notes.map((one) => noteText(one, 'en'));
const isValid = (scene: Scene): boolean => 'scene' in parseScene(serializeScene(scene));

describe('a world of WebTigerPython', () => {
  it('has units of a millimetre, and y downwards from the upper left corner', () => {
    expect(UNIT_MM).toBe(1);
    expect(world({}).scene).toMatchObject({ size: [2000, 1000], robot: { type: null, at: [500, 400], heading: 90 } });
    expect(world({}).notes).toEqual([]);
  });

  it.each([
    [0, 90],
    [1, 45],
    [2, 0],
    [3, 315],
    [4, 270],
    [5, 225],
    [6, 180],
    [7, 135],
  ])('starts in direction %i, eighths clockwise from up: our heading %i', (k, heading) =>
    expect(world({ StartBox: [500, 600, k] }).scene.robot.heading).toBe(heading),
  );

  it.each([
    [0, [550, 400], [650, 400]],
    [4, [650, 400], [550, 400]],
    [2, [600, 450], [600, 350]],
    [6, [600, 350], [600, 450]],
    [1, [565, 435], [635, 365]],
    [3, [635, 435], [565, 365]],
  ])('has walls about their middle, in direction %i', (k, from, to) =>
    expect(objects({ Wallobjects: [[600, 600, 100, k]] })).toEqual([
      { type: 'wall', id: 'wall-1', from, to, thickness: WALL_MM },
    ]),
  );

  it('has blocks: those with true can be pushed', () => {
    const size = [BLOCK_MM, BLOCK_MM];
    expect(objects({ Blockobjects: [[100.4, 200.6, true, 1], [300, 400, false, 0]] })).toEqual([
      { type: 'block', id: 'block-1', at: [100, 799], size, angle: 315 },
      { type: 'fixed-block', id: 'fixed-block-1', at: [300, 600], size, angle: 0 },
    ]); // prettier-ignore
  });

  it('is known by its keys alone, one of which is enough', () => {
    expect(readWorld({ Wallobjects: [[1, 2, 3, 0]] })?.notes.map(({ code }) => code)).toEqual(['sizeMissing', 'startMissing']); // prettier-ignore
    for (const value of [null, 7, 'x', [], {}, [{ StartBox: [] }], { startbox: [1, 2, 0] }])
      expect(readWorld(value)).toBeNull();
    expect(readWorld(JSON.parse('{"__proto__":{"StartBox":[1,2,0]}}'))).toBeNull();
  });
});

describe('what of a world cannot be read', () => {
  it.each<[string, object, string]>([
    ['unknown keys', { Lines: [], RobotSize: 2 }, 'The world says more, which Parcours does not know and leaves out (perhaps pen lines or the robot’s size): Lines, RobotSize.'],
    ['keys that are names of the language', JSON.parse('{"__proto__":1,"constructor":2}') as object, '(perhaps pen lines or the robot’s size): __proto__, constructor.'],
    ['more values than known', { Wallobjects: [[600, 600, 100, 0, 20], [600, 700, 100, 0, 30]] }, 'Wallobjects: values that Parcours does not know are left out (2×; first [20] in Wallobjects[0]).'],
    ['a list that is none', { Wallobjects: 7 }, 'Wallobjects in the world is no list and is left out: 7.'],
    ['a direction that is none of 0 to 7', { StartBox: [500, 600, 90] }, 'The direction of the start is none of 0 to 7: 90. The robot heads upwards.'],
    ['a direction between', { StartBox: [500, 600, 0.5] }, 'none of 0 to 7: 0.5.'],
    ['a missing direction', { StartBox: [500, 600] }, 'none of 0 to 7: –.'],
    ['a start that is no place', { StartBox: [NaN, 600, 0] }, 'Where the robot starts cannot be read: [NaN, 600, 0]. It stands in the middle.'],
    ['walls that are no walls', { Wallobjects: [[1, 2, 3, 0], 'x', [1, 2], [1, 2, 3, 1.5]] }, 'Walls that cannot be read are left out (3; the first is Wallobjects[1]: "x").'],
    ['a wall of no length', { Wallobjects: [[600, 600, 0, 2]] }, 'Walls without length are left out (1; the first is Wallobjects[0]: [600, 600, 0, 2]).'],
    ['a wall of a negative length', { Wallobjects: [[600, 600, -5, 2]] }, 'Walls that cannot be read are left out'],
    ['a block that is none', { Blockobjects: [{}] }, 'Blocks that cannot be read are left out (1; the first is Blockobjects[0]: {  }).'],
    ['a block of which is not said whether it moves', { Blockobjects: [[1, 2, 1, 0]] }, 'Blocks stand fast where it is not clear whether they can be pushed (1; the first is Blockobjects[0]: [1, 2, 1, 0]).'],
    ['a block that is turned somehow', { Blockobjects: [[1, 2, true, 9]] }, 'Blocks whose direction is none of 0 to 7 stand straight'],
    ['what is miles away', { Wallobjects: [[600, 600, 50_000, 0]] }, 'Wallobjects: nothing can stand farther away than 20000 mm. That is left out (1; first Wallobjects[0]: [600, 600, 50000, 0]).'],
    ['a field that is too large', { playgroundSize: [50_000, 1000] }, 'No field can be as large or as small as this: [50000, 1000]. It has 10000 × 1000 mm.'],
    ['a field without a size', { playgroundSize: ['x'] }, 'The size of the field cannot be read: ["x"]. It has 2000 × 2000 mm.'],
  ])('%s: told in a sentence', (_, value, sentence) => {
    const told = said(value);
    expect(told).toHaveLength(1);
    expect(told[0]).toContain(sentence);
    expect(isValid(world(value).scene)).toBe(true);
  }); // prettier-ignore

  it('more walls than a course may hold: the first 2000 are read', () => {
    const Wallobjects = Array.from({ length: 3000 }, (_, place) => [600, 600, 10 + (place % 100), 0]);
    expect(objects({ Wallobjects: Wallobjects.slice(0, 1000) })).toHaveLength(1000);
    expect(objects({ Wallobjects, Blockobjects: [[1, 2, true, 0]] })).toHaveLength(sceneLimits.objects);
    expect(said({ Wallobjects, Blockobjects: [[1, 2, true, 0]] })).toEqual(['The world has 3001 walls and blocks. The first 2000 are there.']); // prettier-ignore
  });

  it('a thousand strange names: a few are told', () => {
    const names = Array.from({ length: 1000 }, (_, place) => [`${'x'.repeat(50)}${String(place)}`, 1]);
    const [told = '', ...more] = said(Object.fromEntries(names) as object);
    expect(more).toEqual([]);
    expect(told.length).toBeLessThan(400);
    expect(told).toMatch(/, ….$/);
  });

  it('a start over the edge: moved in by as little as can be', () => {
    const body = [[{ x: -30, y: -40 }, { x: 70, y: -40 }, { x: 70, y: 40 }, { x: -30, y: 40 }]]; // prettier-ignore
    const moved = withStartInside(world({ StartBox: [-5, 20, 0] }).scene, body);
    expect(moved.scene.robot).toMatchObject({ at: [40, 930], heading: 90 });
    expect(moved.notes.map((one) => noteText(one, 'en'))).toEqual(['At (-5, 980) the robot lay over the edge: it now starts at (40, 930).']); // prettier-ignore
    const { scene } = world({ StartBox: [40, 70, 0] });
    expect(withStartInside(scene, body)).toEqual({ scene, notes: [] });
  });
});

describe('a course that a world can hold', () => {
  it(`is the same after it was written and read (${String(fuzzRuns)} courses)`, () => {
    forManySeeds(fuzzRuns, (rng) => {
      const size = [wholeFrom(rng, 200, 10_000), wholeFrom(rng, 200, 10_000)] as const;
      const at = () => [wholeFrom(rng, -500, 10_500), wholeFrom(rng, -500, 10_500)] as const;
      const walls = Array.from({ length: wholeFrom(rng, 0, 5) }, (_, place): SceneObject => {
        const [from, length] = [at(), wholeFrom(rng, 1, 3000)];
        const [dx, dy] = inPercent(rng, 50) ? [length, inPercent(rng, 50) ? length : -length] : [0, length];
        const to = [from[0] + dx, from[1] + dy] as const;
        const ends = inPercent(rng, 50) ? { from, to } : { from: to, to: from };
        return { type: 'wall', id: `wall-${String(place + 1)}`, ...ends, thickness: WALL_MM };
      });
      const block = (type: 'block' | 'fixed-block') => (_: unknown, place: number): SceneObject => ({
        ...{ type, id: `${type}-${String(place + 1)}`, at: at(), size: [BLOCK_MM, BLOCK_MM] },
        angle: 45 * wholeFrom(rng, 0, 7),
      }); // prettier-ignore
      const some = (type: 'block' | 'fixed-block') => Array.from({ length: wholeFrom(rng, 0, 4) }, block(type));
      const { scene } = world({});
      const robot = { ...scene.robot, at: at(), heading: 45 * wholeFrom(rng, 0, 7) };
      const course: Scene = { ...scene, size, robot, objects: [...walls, ...some('block'), ...some('fixed-block')] };
      const written = writeWorld(course);
      expect(written.notes).toEqual([]);
      expect(readWorld(JSON.parse(JSON.stringify(written.world)))).toEqual({ scene: course, notes: [] });
    });
  });
});
