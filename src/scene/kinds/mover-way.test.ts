import { describe, expect, it } from 'vitest';
import { boundsOf } from './index';
import { isIdle, stopsOf, wayOf, withStops } from './mover-way';
import { findProblems } from '../rules';
import { objectText, serializeScene } from '../serialize';
import type { Mover } from '../scene';
import { mover as plain, problemsOf, sceneOf, withObject, zone } from '../testing/full-scene';

const read = (change: object): Mover => sceneOf(withObject({ ...plain, ...change })).objects[4] as Mover;
const written = (change: object): string => objectText(read(change));
const firstProblem = (change: object): string => problemsOf(withObject({ ...plain, ...change }))[0]?.message ?? '';
const chasing = { to: undefined, chases: {} };

describe('a moving block in a course file', () => {
  it('is written as before if it goes to and fro between two places', () => {
    expect(written({})).toBe('{ "id": "m", "type": "mover", "at": [100, 100], "size": [50, 50], "to": [300, 100] }');
    expect(wayOf(read({}))).toBe('to-and-fro');
  });

  it('has any number of stops up to 20, with a wait at each', () => {
    const way = { stops: [[300, 300]], waits: [0, 1.5], loops: true, phase: 2, spin: -90 };
    expect(written(way)).toContain(
      '"to": [300, 100], "stops": [[300, 300]], "waits": [0, 1.5], "loops": true, "phase": 2, "spin": -90',
    );
    expect(stopsOf(read(way))).toEqual([
      { at: [100, 100], wait: 0 },
      { at: [300, 100], wait: 1.5 },
      { at: [300, 300], wait: 0 },
    ]);
    expect(wayOf(read(way))).toBe('round');
    expect(boundsOf(read(way))).toEqual({ minX: 75, minY: 75, maxX: 325, maxY: 325 });
    expect(read({ stops: Array(18).fill([300, 300]) }).stops).toHaveLength(18);
  });

  it('leaves out what changes nothing', () => {
    expect(read({ stops: [], waits: [0, 0], loops: false, phase: 0, spin: 0 })).toEqual(read({}));
    expect(read({ waits: [1, 0] }).waits).toEqual([1]);
  });

  it('needs no second place to turn on the spot or to chase', () => {
    expect(written({ to: undefined, spin: 45 })).not.toContain('"to"');
    expect(wayOf(read({ to: undefined, spin: 45 }))).toBe('stays');
    expect(written(chasing)).toContain('"chases": {}');
    expect(wayOf(read(chasing))).toBe('chases');
    const guard = { to: undefined, chases: { zone: 'z', reach: 500 } };
    expect(written(guard)).toContain('"chases": { "zone": "z", "reach": 500 }');
    expect(wayOf(read(guard))).toBe('guards');
    expect(stopsOf(read(guard))).toHaveLength(1);
  });

  it.each<[string, object, RegExp]>([
    ['too many stops', { stops: Array(19).fill([1, 1]) }, /objects\[4\]\.stops: 19 entries; there may be 0 … 18/],
    ['a stop outside the limits', { stops: [[1, 99999]] }, /stops\[0\]\[1\]: 99999 is not within -20000 … 20000/],
    ['more waits than stops', { waits: [1, 1, 1] }, /waits: 3 entries; there may be 0 … 2/],
    ['a wait that is too long', { waits: [61] }, /waits\[0\]: 61 is not within 0 … 60/],
    ['a phase before the start', { phase: -1 }, /phase: -1 is not within 0 … 3600/],
    ['a spin that is too fast', { spin: 361 }, /spin: 361 is not within -360 … 360/],
    ['a way of what chases', { ...chasing, loops: true }, /loops: what chases robots has no way\. Leave this out/],
    [
      'an unknown word of a chase',
      { chases: { zoom: 'z' } },
      /chases\.zoom: unknown property\. Known here: zone, reach/,
    ],
    ['no second place and no spin', { to: undefined }, /to: is missing/],
  ])('is refused with its place for %s', (_what, change, sentence) => expect(firstProblem(change)).toMatch(sentence));

  it('needs the newest version of the file if it is no longer the simplest', () => {
    const versionOf = (change: object) => /"version": (\d)/.exec(serializeScene(sceneOf(withObject({ ...plain, ...change }))))?.[1]; // prettier-ignore
    expect(versionOf({})).toBe('2');
    for (const change of [{ stops: [[1, 1]] }, { waits: [1] }, { loops: true }, { phase: 1 }, { spin: 5 }, chasing])
      expect(versionOf(change)).toBe('5');
  });
});

describe('the stops of a moving block', () => {
  it('are changed as one list; a single one is a place without a way', () => {
    const way = read({ stops: [[300, 300]], waits: [1, 2, 3] });
    expect(withStops(way, stopsOf(way))).toEqual(way);
    expect(withStops(way, stopsOf(way).slice(1))).toEqual({
      ...read({}),
      at: [300, 100],
      to: [300, 300],
      waits: [2, 3],
    });
    expect(isIdle(withStops(way, stopsOf(way).slice(0, 1)))).toBe(true);
  });
});

describe('the problems of a course', () => {
  const problemsWith = (change: object) => findProblems(sceneOf(withObject({ ...plain, ...change })), []);

  it('tell of a guard whose zone is not there, and of the way out', () => {
    const guard = { to: undefined, chases: { zone: 'z' } };
    expect(problemsWith(guard)).toMatchObject([{ code: 'guard-without-zone', ids: ['m'], at: [100, 100] }]);
    expect(problemsWith(guard)[0]?.message).toMatch(/zone "z", which is not there.*Choose another zone/);
    expect(problemsWith({ ...guard, chases: { zone: 'a1' } })).toHaveLength(1); // a wall
    const scene = sceneOf(withObject({ ...plain, ...guard }));
    expect(findProblems({ ...scene, objects: [...scene.objects, ...sceneOf(withObject(zone)).objects.slice(4)] }, [])).toEqual([]); // prettier-ignore
  });

  it('do not tell of one that chases or turns on its place', () => {
    expect(problemsWith(chasing)).toEqual([]);
    expect(problemsWith({ to: undefined, spin: 10 })).toEqual([]);
    expect(problemsWith({ to: [100, 100] })).toMatchObject([{ code: 'mover-still' }]);
  });
});
