import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import { packLevels } from '#scene/background';
import { applyEdit, type SceneEdit } from '#scene/edit';
import { advanced, historyOf, redone, undone } from '#scene/history';
import { inverse } from '#scene/inverse';
import {
  defaultScene,
  type Background,
  type Block,
  type Mover,
  type Point,
  type Scene,
  type SceneObject,
} from '#scene/scene';
import { pendingChanges } from './at-once';
import { soloRun, type SoloSetup } from './run-setup';
import { Simulation } from './simulation';

let firmware: WebAssembly.Module;
beforeAll(() => {
  firmware = new WebAssembly.Module(readFileSync('.cache/vm/vm.wasm'));
});

const block = (id: string, at: Point, size: Point = [50, 50]): Block => ({ type: 'block', id, at, size, angle: 0 });
const wall = (id: string, x: number): SceneObject => ({
  type: 'wall',
  id,
  from: [x, 200],
  to: [x, 700],
  thickness: 10,
});
const line = (id: string, y: number, color: 'black' | 'white' = 'black'): SceneObject => ({
  ...{ type: 'stroke', id, width: 40, color },
  points: [
    [300, y],
    [1100, y],
  ],
});
/** The robot at (300 | 450), looking along x. */
const sceneOf = (...objects: readonly SceneObject[]): Scene => {
  const scene = defaultScene();
  return { ...scene, robot: { ...scene.robot, at: [300, 450] }, objects };
};
const add = (...objects: readonly SceneObject[]): SceneEdit => ({ type: 'add', objects });
const replace = (by: SceneObject): SceneEdit => ({ type: 'replace', changes: [{ id: by.id, by: [by] }] });
const remove = (...ids: readonly string[]): SceneEdit => ({ type: 'remove', ids });

const DRIVE = 'from mbrobot import *\nsetSpeed(60)\nforward()\n';
const LOOK = 'from mbrobot import *\nwhile True:\n  print(irLeft.read_digital(), end="")\n  delay(100)\n';

const start = (scene: Scene, program: string, change: Partial<SoloSetup> = {}): Promise<Simulation> => {
  const base = { scene, files: { 'main.py': program }, robot: 'auto', board: 'auto', seed: 1, reality: 0 };
  return Simulation.create(soloRun({ ...base, ...change }), firmware);
};

const edit = (simulation: Simulation, change: SceneEdit): void => {
  // as it arrives in the worker: no object of the page is the same object here
  simulation.input({ type: 'edit', edit: structuredClone(change) });
};

/** The robot drives meanwhile, for 2 s before the change and 2 s after it. */
async function drivenAround(scene: Scene, change: SceneEdit): Promise<Simulation> {
  const simulation = await start(scene, DRIVE);
  simulation.advanceTo(2_000_000);
  edit(simulation, change);
  simulation.advanceTo(4_000_000);
  return simulation;
}

const xOf = (simulation: Simulation): number => simulation.snapshot().robot?.pose.xMm ?? NaN;

describe('a course that is changed while it is driven', { timeout: 30_000 }, () => {
  it('does not stop the run: nothing else is different', async () => {
    const plain = await drivenAround(sceneOf(), { type: 'course', changes: { name: 'New' } });
    const edited = await drivenAround(sceneOf(), add(line('s', 800)));
    expect(edited.traceHash).toBe(plain.traceHash);
    expect(xOf(edited)).toBeGreaterThan(500);
  });

  it('shows a new stroke to the line sensors at once, and takes it away at once', async () => {
    const simulation = await start(sceneOf(), LOOK);
    simulation.advanceTo(1_000_000);
    edit(simulation, add(line('s', 450)));
    simulation.advanceTo(2_000_000);
    edit(simulation, remove('s'));
    simulation.advanceTo(3_000_000);
    expect(simulation.takeConsole()).toMatch(/^1{8,12}0{8,12}1{8,12}$/);
  });

  it('paints in the order of the course: what is put below a stroke stays covered', async () => {
    const simulation = await start(sceneOf(line('a', 450, 'white')), LOOK);
    const below: SceneEdit = { type: 'replace', changes: [{ id: 'a', by: [line('b', 450), line('a', 450, 'white')] }] };
    edit(simulation, below);
    simulation.advanceTo(1_000_000);
    edit(simulation, add(line('c', 450)));
    simulation.advanceTo(2_000_000);
    expect(simulation.takeConsole()).toMatch(/^1{8,12}0{8,12}$/);
  });

  it('lays a new picture on the floor at once', async () => {
    const dark: Background = {
      ...{ at: [0, 0], size: [1200, 900], cells: [12, 9], picture: '' },
      levels: packLevels(new Uint8Array(108)),
    };
    const simulation = await start(sceneOf(), LOOK);
    simulation.advanceTo(1_000_000);
    edit(simulation, { type: 'course', changes: { background: dark } });
    simulation.advanceTo(2_000_000);
    expect(simulation.takeConsole()).toMatch(/^1{8,12}0{8,12}$/);
    const damaged = { type: 'course', changes: { background: { ...dark, cells: [12, 8] } } } as const;
    expect(() => edit(simulation, damaged)).toThrow(/background\.levels: .*damaged/);
  });

  it('puts a new block into the way of the robot, which the hand can move then', async () => {
    const simulation = await drivenAround(sceneOf(), add(block('b', [780, 450])));
    const pushed = simulation.snapshot().blocks['b'];
    expect(pushed?.xMm).toBeGreaterThan(785);
    const pose = { xMm: 200, yMm: 800, headingDeg: 90 };
    simulation.input({ type: 'place-block', id: 'b', pose });
    simulation.advanceTo(4_100_000);
    expect(simulation.snapshot().blocks['b']).toMatchObject({ xMm: 200, yMm: 800 });
  });

  it('knows a new block before the step at which it appears', async () => {
    const simulation = await start(sceneOf(), DRIVE);
    edit(simulation, add(block('b', [700, 450])));
    simulation.input({ type: 'place-block', id: 'b', pose: { xMm: 200, yMm: 800, headingDeg: 0 } });
    simulation.advanceTo(100_000);
    expect(simulation.snapshot().blocks['b']).toMatchObject({ xMm: 200, yMm: 800 });
  });

  it('takes a block away, and one of another size comes in its place', async () => {
    const scene = sceneOf(block('a', [700, 450]), block('b', [200, 800]));
    const gone = await drivenAround(scene, {
      type: 'all',
      edits: [remove('a'), replace(block('b', [200, 800], [80, 80]))],
    });
    expect(Object.keys(gone.snapshot().blocks)).toEqual(['b']);
    expect(gone.snapshot().robot?.collisions).toBe(1); // it had reached the block before
    expect(() => gone.input({ type: 'place-block', id: 'a', pose: { xMm: 1, yMm: 1, headingDeg: 0 } })).toThrow(
      /no movable block "a"\. Known are b\./,
    );
  });

  it('moves a block that is moved in the course, and leaves one alone that was pushed', async () => {
    const scene = sceneOf(block('pushed', [500, 450]), block('moved', [200, 800]));
    const simulation = await start(scene, DRIVE);
    simulation.advanceTo(2_000_000);
    const before = simulation.snapshot().blocks['pushed'];
    expect(before?.xMm).toBeGreaterThan(510);
    edit(simulation, replace({ ...block('moved', [250, 700]), angle: 90 }));
    // undo may add everything again
    edit(simulation, {
      type: 'all',
      edits: [{ type: 'clear' }, add(block('pushed', [500, 450]), block('moved', [250, 700]))],
    });
    simulation.advanceTo(2_004_000);
    const { blocks } = simulation.snapshot();
    expect(Math.abs((blocks['pushed']?.xMm ?? 0) - (before?.xMm ?? 0))).toBeLessThan(2);
    expect(blocks['moved']).toEqual({ xMm: 250, yMm: 700, headingRad: 0 });
  });

  it.each<[string, SceneEdit]>([
    ['a new wall', add(wall('new', 600))],
    ['a wall that is taken away', remove('w')],
    ['a fixed block', add({ ...block('f', [700, 450]), type: 'fixed-block' })],
    ['spikes', add({ type: 'spikes', id: 'x', at: [700, 450], size: [50, 50], angle: 0 })],
    [
      'a moving obstacle',
      add({
        type: 'mover',
        id: 'x',
        at: [700, 450],
        to: [700, 800],
        size: [50, 50],
        angle: 0,
        speed: 100,
        spiked: false,
      }),
    ],
    ['the start of the robot', { type: 'robot', robot: { at: [700, 200], heading: 90, scale: 2 } }],
    ['a smaller arena', { type: 'course', changes: { size: [700, 600] } }],
    ['a block outside of the arena', add(block('out', [1500, 450]))],
    ['a movable block in the place of a wall', replace(block('w', [700, 450]))],
    ['a wall in the place of a movable block', replace(wall('b', 700))],
  ])('waits for the next start with %s', async (_what, change) => {
    const scene = sceneOf(wall('w', 900), block('b', [100, 800]));
    const plain = await drivenAround(scene, { type: 'course', changes: { name: 'New' } });
    const edited = await drivenAround(scene, change);
    expect(edited.traceHash).toBe(plain.traceHash);
    expect(edited.snapshot().blocks).toEqual(plain.snapshot().blocks);
    expect(edited.snapshot().movers).toEqual({});
    const anew = await start(applyEdit(scene, change), DRIVE);
    anew.advanceTo(4_000_000);
    expect(anew.snapshot()).not.toEqual(plain.snapshot());
    const pending = pendingChanges(scene, applyEdit(scene, change));
    expect(pending.coming.length + pending.going.length > 0 || pending.robot || pending.arena).toBe(true);
  });

  it('has nothing that waits after a change that shows at once', () => {
    const scene = sceneOf(wall('w', 900), block('b', [100, 800]));
    const change: SceneEdit = {
      type: 'all',
      edits: [remove('b'), add(line('s', 1), block('c', [9, 9])), replace(wall('w', 900))],
    };
    expect(pendingChanges(scene, structuredClone(applyEdit(scene, change)))).toEqual({
      ...{ coming: [], going: [], robot: false, arena: false },
    });
  });

  it('is judged by its new task', async () => {
    const simulation = await start(sceneOf(), DRIVE);
    simulation.advanceTo(1_000_000);
    expect(simulation.verdict).toBeNull();
    const target = {
      type: 'target',
      id: 't',
      at: [600, 450],
      size: [100, 100],
      angle: 0,
      round: false,
      number: 0,
      blocks: 0,
    } as const;
    edit(simulation, add(target));
    simulation.advanceTo(1_100_000);
    expect(simulation.snapshot().verdict?.state).toBe('open');
    simulation.advanceTo(6_000_000);
    // Done, but the course was changed for it.
    expect(simulation.snapshot().verdict).toMatchObject({ state: 'helped', help: ['edits'] });
  });
});

describe('an undo while the robot drives', { timeout: 30_000 }, () => {
  it('takes out of the world what was drawn, a redo brings it back, and the log repeats the run', async () => {
    const scene = sceneOf(block('a', [900, 800]));
    const simulation = await start(scene, LOOK);
    const drawn = advanced(historyOf(scene), add(line('s', 450), block('b', [700, 300]), wall('w', 800)));
    const [step] = drawn.past;
    if (step === undefined) throw new Error('nothing was drawn');
    const present = [drawn, undone(drawn), redone(undone(drawn))].map((history) => history.present);
    for (const [index, change] of [step.edit, step.inverse, step.edit].entries()) {
      simulation.advanceTo((index + 1) * 1_000_000);
      edit(simulation, change);
      simulation.advanceTo((index + 1) * 1_000_000 + 4_000);
      const isThere = change === step.edit;
      expect(Object.keys(simulation.snapshot().blocks)).toEqual(isThere ? ['a', 'b'] : ['a']);
      expect(pendingChanges(scene, present[index] ?? scene).coming).toHaveLength(isThere ? 1 : 0);
    }
    simulation.advanceTo(4_000_000);
    expect(simulation.takeConsole()).toMatch(/^1{8,12}0{8,12}1{8,12}0{8,12}$/);
    const again = await start(scene, LOOK, { inputs: structuredClone(simulation.inputLog) });
    again.advanceTo(4_000_000);
    expect(again.traceHash).toBe(simulation.traceHash);
    expect(again.snapshot()).toEqual(simulation.snapshot());
  });

  it('leaves the run as if nothing had been put in the robot’s way', async () => {
    const held = await start(sceneOf(), DRIVE);
    const wide = add(block('b', [600, 450], [40, 400]));
    edit(held, wide);
    held.advanceTo(4_000_000);
    const [free, anew] = [await start(sceneOf(), DRIVE), await start(sceneOf(), DRIVE)];
    for (const change of [wide, inverse(sceneOf(), wide)]) edit(free, change);
    for (const simulation of [free, anew]) simulation.advanceTo(4_000_000);
    expect(xOf(held)).not.toBe(xOf(anew));
    expect(free.traceHash).toBe(anew.traceHash);
  });
});

describe('the log of a run with edits', { timeout: 30_000 }, () => {
  it('repeats the run to the last bit', async () => {
    const scene = sceneOf(block('a', [600, 460]), line('s', 450));
    const first = await start(scene, DRIVE);
    first.advanceTo(700_000);
    edit(first, add(block('b', [700, 440])));
    first.advanceTo(1_501_000);
    edit(first, { type: 'all', edits: [remove('s', 'a'), add(wall('w', 800))] });
    first.advanceTo(2_003_000);
    edit(first, replace({ ...block('b', [650, 500]), angle: 45 }));
    first.input({ type: 'place-block', id: 'b', pose: { xMm: 620, yMm: 470, headingDeg: 10 } });
    first.advanceTo(6_000_000);
    const again = await start(scene, DRIVE, { inputs: structuredClone(first.inputLog) });
    again.advanceTo(6_000_000);
    expect(again.traceHash).toBe(first.traceHash);
    expect(again.snapshot()).toEqual(first.snapshot());
    expect(again.inputLog).toEqual(first.inputLog);
  });

  it('is held against the course as it is at each time, whatever the order of its entries', async () => {
    const pose = { xMm: 200, yMm: 800, headingDeg: 0 };
    const inputs = [
      { timeUs: 2_000_000, action: { type: 'place-block', id: 'b', pose } },
      { timeUs: 1_000_000, action: { type: 'edit', edit: add(block('b', [700, 300])) } },
    ] as const;
    const simulation = await start(sceneOf(), DRIVE, { inputs });
    simulation.advanceTo(2_100_000);
    expect(simulation.snapshot().blocks['b']).toMatchObject({ xMm: 200, yMm: 800 });
    const early = [{ ...inputs[0], timeUs: 500_000 }, inputs[1]];
    await expect(start(sceneOf(), DRIVE, { inputs: early })).rejects.toThrow(/^\[0\]: There is no movable block "b"/);
    const twice = [inputs[1], { ...inputs[1], timeUs: 3_000_000 }];
    await expect(start(sceneOf(), DRIVE, { inputs: twice })).rejects.toThrow(
      /^\[1\]: edit\.objects\[0\]\.id: "b" is already/,
    );
  });

  it('passes over an entry that an edit of the replay has made impossible', async () => {
    const inputs = [{ timeUs: 1_000_000, action: { type: 'edit', edit: remove('a') } }] as const;
    const simulation = await start(sceneOf(block('a', [600, 300])), DRIVE, { inputs });
    edit(simulation, remove('a'));
    simulation.advanceTo(2_000_000);
    expect(simulation.inputLog.map(({ timeUs }) => timeUs)).toEqual([0]);
  });
});

describe('the hand before a run', { timeout: 30_000 }, () => {
  it('puts blocks and robot elsewhere at time 0', async () => {
    const inputs = [
      { timeUs: 0, action: { type: 'place-block', id: 'a', pose: { xMm: 100, yMm: 100, headingDeg: 0 } } },
      { timeUs: 0, action: { type: 'place', pose: { xMm: 900, yMm: 200, headingDeg: 90 } } },
    ] as const;
    const simulation = await start(sceneOf(block('a', [600, 450])), '', { inputs });
    simulation.advanceTo(0);
    expect(simulation.snapshot().blocks['a']).toMatchObject({ xMm: 100, yMm: 100 });
    expect(simulation.snapshot().robot?.pose).toMatchObject({ xMm: 900, yMm: 200 });
  });
});

describe('a heap of blocks', () => {
  it('is no run: the physics would take minutes for a step', async () => {
    const heap = Array.from({ length: 2_000 }, (_, index) => block(`b${String(index)}`, [900, 450]));
    await expect(start(sceneOf(...heap), DRIVE)).rejects.toThrow('more than 2000 places');
  });
});

describe('a crowd of moving obstacles', () => {
  it('is no run above a hundred', async () => {
    const crowd = Array.from({ length: 101 }, (_, index): Mover => {
      const at: Point = [600 + (index % 10) * 50, 60 + Math.floor(index / 10) * 70];
      const size: Point = [20, 20];
      return { id: `m${index}`, type: 'mover', at, to: [at[0] + 30, at[1]], size, angle: 0, speed: 50, spiked: false };
    });
    await expect(start(sceneOf(...crowd), DRIVE)).rejects.toThrow('101 moving obstacles are too many');
  });
});
