/** Robots whose faults the fit does not know are measured with the errors of a ruler, fitted, and driven elsewhere. */
import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import { degOf } from '#core/angle';
import { createRng } from '#core/rng';
import { findRobot } from '#robots/index';
import type { RobotType } from '#robots/robot';
import { idealTraits, traitLimits, type Traits } from '#robots/traits';
import { defaultScene } from '#scene/scene';
import { soloRun } from '#simulation/run-setup';
import { Simulation } from '#simulation/simulation';
import { fitTraits } from './fit';
import { missMm } from './miss';
import { DRIVES, nothingMeasured, type Drive, type Measured } from './my-robot';
import { predictMotion, type Driving } from './predict';

let firmware: WebAssembly.Module;
beforeAll(() => {
  firmware = new WebAssembly.Module(readFileSync('.cache/vm/vm.wasm'));
});

const RULER_MM = 5;
const PROTRACTOR_DEG = 5; // what 5 mm are at the robot's nose

const typeOf = (id: string): RobotType => {
  const type = findRobot(id);
  if (type === null) throw new Error(`There is no robot "${id}".`);
  return type;
};

/** A pupil's measurements of a robot, each number up to 5 mm or 5° wrong. */
async function measure(driving: Driving & { readonly seed: number }): Promise<Measured> {
  const chance = createRng(driving.seed).fork('ruler');
  const wrong = (by: number): number => by * (2 * chance.unit() - 1);
  const { drives, turnDeg } = await predictMotion(driving);
  const ruled = ({ aheadMm, leftMm }: Drive): Drive => ({
    aheadMm: aheadMm + wrong(RULER_MM),
    leftMm: leftMm + wrong(RULER_MM),
  });
  const measured = DRIVES.map((name) => [name, ruled(drives[name])]);
  return {
    ...nothingMeasured,
    drives: Object.fromEntries(measured) as Measured['drives'],
    turnDeg: turnDeg + wrong(PROTRACTOR_DEG),
  };
}

/** Programs other than the measuring ones. */
const OTHERS = {
  'straight at 30': 'setSpeed(30)\nforward()\ndelay(3000)\nstop()',
  'straight at 80': 'setSpeed(80)\nforward()\ndelay(1500)\nstop()',
  'back at 60': 'setSpeed(60)\nbackward()\ndelay(2000)\nstop()',
  'a turn to the right at 35': 'setSpeed(35)\nright()\ndelay(1500)\nstop()',
  'a circle of 20 cm': 'setSpeed(50)\nleftArc(0.2)\ndelay(3000)\nstop()',
  'a corner': 'setSpeed(70)\nforward()\ndelay(800)\nleft()\ndelay(400)\nforward()\ndelay(800)\nstop()',
} as const;

/** Length of the path in mm and turn in degrees of a robot after one of the programs. */
async function driven(program: string, { type, traits, reality = 0, seed = 1 }: Omit<Driving, 'firmware'>) {
  const bare = defaultScene();
  const scene = {
    ...bare,
    size: [6000, 6000] as const,
    robot: { ...bare.robot, type: type.id, at: [3000, 3000] as const },
  };
  const files = { 'main.py': `from ${type.modules[0] ?? ''} import *\n${program}\n` };
  const setup = { scene, files, robot: type.id, board: type.board, seed, reality };
  const simulation = await Simulation.create(soloRun(traits === undefined ? setup : { ...setup, traits }), firmware);
  simulation.advanceTo(5_000_000);
  expect(simulation.ended?.exception ?? null).toBeNull();
  const { pathMm = 0, turnedRad = 0 } = simulation.snapshot().robot ?? {};
  return { wayMm: pathMm, turnDeg: degOf(turnedRad) };
}

/** By how much the fitted robot misses what the real one does. */
async function compared(program: string, type: RobotType, used: Used, traits: Traits) {
  const real = await driven(program, { type, ...used });
  const here = await driven(program, { type, traits });
  return {
    way: Math.abs(here.wayMm - real.wayMm) / Math.max(real.wayMm, 100), // a turn on the spot has a path of some mm
    turn: Math.abs(here.turnDeg - real.turnDeg) / Math.max(Math.abs(real.turnDeg), 90),
    turnDeg: here.turnDeg - real.turnDeg,
  };
}

interface Used {
  readonly reality: number;
  readonly seed: number;
}
const TEN: readonly Used[] = [0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1, 0.65, 0.95].map((reality, index) => ({
  reality,
  seed: index + 1,
}));

const fits = new Map<string, Promise<Traits>>();

/** The traits of a used robot, fitted once to its measurements for all tests. */
function fitted(type: RobotType, used: Used): Promise<Traits> {
  const key = `${type.id} ${String(used.seed)} ${String(used.reality)}`;
  const made = fits.get(key) ?? measure({ type, firmware, ...used }).then((all) => fitTraits(all, type, firmware));
  fits.set(key, made);
  return made;
}

describe.each([
  { id: 'maqueen-lite', robots: TEN },
  { id: 'maqueen-plus-v2', robots: TEN.slice(6, 8) },
  { id: 'callibot', robots: TEN.slice(6, 8) },
])('a measured $id', { timeout: 60_000 }, ({ id, robots }) => {
  it.each(robots)(
    'drives six other programs like the real one (number $seed, reality $reality): way and turn to 5 %',
    async (used) => {
      const type = typeOf(id);
      const traits = await fitted(type, used);
      for (const [name, program] of Object.entries(OTHERS)) {
        const { way, turn } = await compared(program, type, used, traits);
        expect(way, `way of ${name}`).toBeLessThan(0.05);
        expect(turn, `turn of ${name}`).toBeLessThan(0.05);
      }
    },
  );
});

describe('a measured robot', { timeout: 60_000 }, () => {
  const type = typeOf('maqueen-lite');
  const used = { reality: 1, seed: 8 };

  it('drives some millimetres beside the measured places, before the fit centimetres', async () => {
    const measured = await measure({ type, firmware, ...used });
    const traits = await fitted(type, used);
    expect(missMm(measured, await predictMotion({ type, firmware }))).toBeGreaterThan(40);
    expect(missMm(measured, await predictMotion({ type, firmware, traits }))).toBeLessThan(6);
  });

  it.each([-4, 3, 6])('is straightened by calibrate(0, %i) as far as the real one', async (differential) => {
    const traits = await fitted(type, used);
    const program = `calibrate(0, ${String(differential)})\nforward()\ndelay(2000)\nstop()`;
    expect(Math.abs((await compared(program, type, used, traits)).turnDeg)).toBeLessThan(3);
  });

  it('is as built where nothing was measured', async () => {
    expect(await fitTraits(nothingMeasured, type, firmware)).toEqual(idealTraits);
  });

  it('needs no more than one drive; what that cannot tell stays as usual', async () => {
    const whole = await measure({ type, firmware, ...used });
    const measured = { ...nothingMeasured, drives: { ...nothingMeasured.drives, usual: whole.drives.usual } };
    const { motors } = await fitTraits(measured, type, firmware);
    expect(missMm(measured, await predictMotion({ type, firmware, traits: { ...idealTraits, motors } }))).toBeLessThan(
      6,
    );
    expect(Math.abs(motors.friction)).toBeLessThan(0.004);
    expect(motors.charge).toBeGreaterThan(0.8);
  });

  it('hears 6 mm too far, nearly, when its sensor shows 106 mm at 100 and 406 at 400', async () => {
    const { ultrasonic } = await fitTraits({ ...nothingMeasured, echoesMm: [106, 406] }, type, firmware);
    for (const trueMm of [100, 400])
      expect(ultrasonic.offsetMm + ultrasonic.scale * trueMm - trueMm).toBeCloseTo(5.5, 0);
  });

  it('stays within what a robot can be, whatever was typed', async () => {
    const drives = { slow: { aheadMm: 3000, leftMm: -1500 }, usual: { aheadMm: 0, leftMm: 1500 }, fast: null };
    const { motors } = await fitTraits({ ...nothingMeasured, drives, turnDeg: 3600 }, type, firmware);
    for (const [key, value] of Object.entries(motors)) {
      const { min, max } = traitLimits[key as keyof typeof motors];
      expect(value).toBeGreaterThanOrEqual(min);
      expect(value).toBeLessThanOrEqual(max);
    }
  });
});
