import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import { defaultScene, type Mover, type Point, type Scene, type SceneObject, type Zone } from '#scene/scene';
import { hashOf } from '#world/testing/rig';
import { soloRun } from './run-setup';
import { Simulation } from './simulation';

let firmware: WebAssembly.Module;
beforeAll(() => {
  firmware = new WebAssembly.Module(readFileSync('.cache/vm/vm.wasm'));
});

const foe = (at: Point, change: Partial<Mover>): Mover => ({
  ...{ type: 'mover', id: 'foe', at, to: at, size: [60, 60], angle: 0, speed: 100, spiked: false },
  ...change,
});
const zone: Zone = {
  ...{ type: 'checkpoint', id: 'z', at: [700, 450], size: [200, 200], angle: 0 },
  ...{ round: true, number: 1, blocks: 0 },
};
/** The robot at (300 | 450), looking along x. */
const sceneOf = (...objects: readonly SceneObject[]): Scene => {
  const scene = defaultScene();
  return { ...scene, robot: { ...scene.robot, at: [300, 450] }, objects };
};

const STAND = 'from mbrobot import *\n';
const DRIVE = 'from mbrobot import *\nsetSpeed(60)\nforward()\n';

const start = (scene: Scene, program: string, others: readonly string[] = []): Promise<Simulation> => {
  const setup = soloRun({ scene, files: { 'main.py': program }, robot: 'auto', board: 'auto', seed: 1, reality: 0 });
  const [first] = setup.devices;
  if (first === undefined) throw new Error('A run without devices.');
  const more = others.map((text, place) => ({ ...first, name: `other${String(place)}`, files: { 'main.py': text } }));
  return Simulation.create({ ...setup, devices: [first, ...more] }, firmware);
};

const placeOf = (simulation: Simulation): readonly number[] => {
  const pose = simulation.snapshot().movers['foe'];
  return [pose?.xMm ?? NaN, pose?.yMm ?? NaN];
};

describe('foes of a course', { timeout: 30_000 }, () => {
  it('go from stop to stop, wait there, and start with their phase', async () => {
    const way = { to: [500, 100], stops: [[500, 300]], waits: [0, 2], loops: true, phase: 1, spin: 90 } as const;
    const simulation = await start(sceneOf(foe([400, 100], way)), STAND);
    expect(placeOf(simulation)).toEqual([500, 100]);
    simulation.advanceTo(3_000_000);
    expect(placeOf(simulation)).toEqual([500, 200]);
    expect(simulation.snapshot().movers['foe']?.headingRad).toBeCloseTo(1.5 * Math.PI, 9);
    simulation.advanceTo(4_000_000);
    expect(placeOf(simulation)).toEqual([500, 300]);
  });

  it('chase a robot and fail it when they have spikes', async () => {
    const simulation = await start(sceneOf(foe([300, 800], { chases: {}, spiked: true })), STAND);
    simulation.advanceTo(5_000_000);
    expect(simulation.verdict).toMatchObject({ state: 'failed', reason: 'spikes', by: 'foe' });
  });

  it('guard a zone: they come when the robot touches it with its nose, and go back once it has passed', async () => {
    const guard = foe([700, 800], { chases: { zone: 'z' }, speed: 200 });
    const simulation = await start(sceneOf(zone, guard), DRIVE);
    let cameAtMm = NaN;
    for (let ms = 0; ms < 9_000; ms += 20) {
      simulation.advanceTo(ms * 1000);
      const x = simulation.snapshot().robot?.pose.xMm ?? NaN;
      if (Number.isNaN(cameAtMm) && placeOf(simulation)[1] !== 800) cameAtMm = x;
    }
    expect(cameAtMm).toBeGreaterThan(510); // the zone begins at 600; a Maqueen Lite is 6 to 9 cm before its axle
    expect(cameAtMm).toBeLessThan(560);
    simulation.input({ type: 'place', pose: { xMm: 100, yMm: 100, headingDeg: 0 } });
    simulation.advanceTo(14_000_000);
    const [x = NaN, y = NaN] = placeOf(simulation);
    expect(x).toBeCloseTo(700, 6);
    expect(y).toBeCloseTo(800, 6);
  });

  it('guard a zone also against a claw that reaches in: they feel all that forbidden fields feel', async () => {
    const guard = foe([700, 800], { chases: { zone: 'z' }, speed: 200 });
    const field: Zone = { ...zone, type: 'forbidden', at: [500, 450], round: false, number: 0 };
    const comes = async (x: number, options: Readonly<Record<string, string>>): Promise<readonly unknown[]> => {
      const scene = sceneOf(field, guard);
      const simulation = await start({ ...scene, robot: { ...scene.robot, at: [x, 450], options } }, STAND);
      simulation.advanceTo(500_000);
      return [placeOf(simulation)[1] !== 800, simulation.verdict?.state];
    };
    // The field begins at 400; a Maqueen Lite is 6 to 9 cm before its axle, its claw reaches further.
    expect(await comes(300, {})).toEqual([false, 'open']);
    expect(await comes(300, { S1: 'claw' })).toEqual([true, 'failed']);
  });

  it('go home when their zone is taken away during the run', async () => {
    const guard = foe([700, 800], { chases: { zone: 'z' } });
    const scene = { ...sceneOf({ ...zone, at: [300, 450] }, guard) };
    const simulation = await start(scene, STAND);
    simulation.advanceTo(2_000_000);
    expect(placeOf(simulation)[0]).toBeLessThan(600);
    simulation.input({ type: 'edit', edit: { type: 'remove', ids: ['z'] } });
    simulation.advanceTo(6_000_000);
    expect(placeOf(simulation)[0]).toBeCloseTo(700, 6);
  });

  it('make the same run however time is sliced, among several robots', async () => {
    const scene = sceneOf(
      zone,
      foe([900, 700], { chases: {}, speed: 150, spin: 45 }),
      { ...foe([700, 200], { chases: { zone: 'z' } }), id: 'guard' },
      { ...foe([500, 600], { to: [600, 600], stops: [[600, 700]], waits: [0.5], spin: -90 }), id: 'patrol' },
    );
    const moved = async (sliceUs: number): Promise<string> => {
      const simulation = await start(scene, DRIVE, [DRIVE, STAND]);
      for (let us = 0; us < 6_000_000; us += sliceUs) simulation.advanceTo(us);
      simulation.advanceTo(6_000_000);
      const { movers } = simulation.snapshot();
      return `${simulation.traceHash} ${hashOf(Object.values(movers).flatMap(({ xMm, yMm, headingRad }) => [xMm, yMm, headingRad]))}`;
    };
    expect(await moved(6_000_000)).toBe(await moved(1_700));
  });
});
