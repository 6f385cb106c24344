import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import { parseSceneValue } from '#scene/parse';
import { soloRun } from '#simulation/run-setup';
import { Simulation } from '#simulation/simulation';

let firmware: WebAssembly.Module;
beforeAll(() => {
  firmware = new WebAssembly.Module(readFileSync('.cache/vm/vm.wasm'));
});

interface Setting {
  readonly robot?: string;
  /** Size of the arena. */
  readonly size?: readonly [number, number];
  /** Walls, blocks and lines; the robot starts at (600, 450), heading along +x. */
  readonly objects?: readonly object[];
  readonly press?: 'a' | 'b';
  readonly options?: Readonly<Record<string, string>>;
}

/** Runs a program that begins with `from simrobot import *` for some seconds. */
async function run(program: string, seconds: number, setting: Setting = {}) {
  const { robot = 'maqueen-lite', size = [1200, 900], objects = [], press, options = {} } = setting;
  const named = objects.map((object, i) => ({ id: `o${i}`, ...object }));
  const parsed = parseSceneValue({
    format: 'parcours-scene',
    version: 1,
    size,
    robot: { at: [600, 450] },
    objects: named,
  });
  if (!('scene' in parsed)) throw new Error(parsed.problem);
  const files = { 'main.py': `from simrobot import *\n${program}` };
  const setup = { scene: parsed.scene, files, robot, board: 'auto', seed: 1, reality: 0, robotOptions: options };
  const simulation = await Simulation.create(soloRun(setup), firmware);
  if (press) {
    simulation.advanceTo(seconds * 500_000);
    simulation.input({ type: 'button', button: press, down: true });
    simulation.advanceTo(seconds * 500_000 + 100_000);
    simulation.input({ type: 'button', button: press, down: false });
  }
  simulation.advanceTo(seconds * 1_000_000);
  const { robot: seen } = simulation.snapshot();
  return { simulation, seen, lines: simulation.takeConsole().split('\n').filter(Boolean), ended: simulation.ended };
}

const robots = ['maqueen-lite', 'maqueen-plus-v2', 'callibot', 'maqueen-plus-v1', 'motionkit-2'];

describe('simrobot', { timeout: 60_000 }, () => {
  it.each(robots)('drives the %s with a Gear: forward for 600 ms, then it stands', async (robot) => {
    const program =
      'robot = LegoRobot()\ngear = Gear()\nrobot.addPart(gear)\ngear.setSpeed(50)\ngear.forward(600)\nprint(gear.isMoving())';
    const { seen, lines, ended } = await run(program, 3, { robot });
    expect([ended?.exception ?? null, lines]).toEqual([null, ['False']]);
    expect(seen?.pose.xMm).toBeGreaterThan(650);
    expect(seen?.state.duty).toEqual({ left: 0, right: 0 });
  });

  it.each(robots)('turns the left motor of the %s with Motor(MotorPort.A): it drives to the right', async (robot) => {
    const { seen, ended } = await run(
      'm = Motor(MotorPort.A)\nm.setSpeed(60)\nm.forward()\nTools.delay(500)\nm.stop()',
      2,
      { robot },
    );
    expect(ended?.exception ?? null).toBeNull();
    expect(seen?.pose.headingRad).toBeLessThan(-0.2);
  });

  it.each(robots)('reads light sensors of the %s: high on the bare floor, low on a black one', async (robot) => {
    const program = 'print([LightSensor(p).getValue() > 500 for p in (SensorPort.S1, SensorPort.S2, SensorPort.S3)])';
    expect((await run(program, 2, { robot })).lines).toEqual(['[True, True, True]']);
    const black = { type: 'stroke', points: [[500, 450], [800, 450]], width: 200 }; // prettier-ignore
    expect((await run(program, 2, { robot, objects: [black] })).lines).toEqual(['[False, False, False]']);
  });

  it('measures the distance to a wall, and -1 where there is none', async () => {
    const wall = { type: 'wall', from: [905, 300], to: [905, 600], thickness: 10 };
    const [near] = (await run('print(UltrasonicSensor(SensorPort.S1).getDistance())', 2, { objects: [wall] })).lines;
    expect(Math.abs(Number(near) - 24)).toBeLessThanOrEqual(2);
    expect((await run('print(getDistance())', 2, { size: [9000, 900] })).lines).toEqual(['-1']);
  });

  it('feels with the bumper of a Calli:bot; a Maqueen has none', async () => {
    const program =
      'gear = Gear()\nts = TouchSensor(SensorPort.S3)\ngear.forward()\nwhile not ts.isPressed():\n  delay(10)\ngear.stop()\nprint("ouch")';
    const wall = { type: 'wall', from: [800, 300], to: [800, 600], thickness: 10 };
    expect(
      (await run(program, 6, { robot: 'callibot', objects: [wall], options: { bumper: 'always' } })).lines,
    ).toEqual(['ouch']);
    expect((await run(program, 2)).ended?.exception?.message).toBe('This robot has no touch sensor.');
  });

  it('ends a loop that waits for ESCAPE when button B is pressed', async () => {
    const program = 'robot = LegoRobot()\nwhile not robot.isEscapeHit():\n  delay(20)\nrobot.exit()\nprint("end")';
    expect((await run(program, 2)).lines).toEqual([]);
    expect((await run(program, 2, { press: 'b' })).lines).toEqual(['end']);
  });

  it('says what RobotContext was asked for, and nothing else happens', async () => {
    const program =
      'RobotContext.setStartPosition(250, 490)\nRobotContext.useObstacle("sprites/bg.gif", 250, 250)\nRobotContext.enableTrace(True)';
    const { lines, seen } = await run(program, 2);
    expect(lines).toEqual([
      'RobotContext.setStartPosition(250,490)',
      'RobotContext.useObstacle(sprites/bg.gif,250,250)',
      'RobotContext.enableTrace(True)',
    ]);
    expect(seen?.pose).toMatchObject({ xMm: 600, yMm: 450 });
  });

  it('asks for a robot where there is none', async () => {
    const { ended } = await run('forward()', 1, { robot: 'none' });
    expect(ended?.exception?.message).toBe('Please connect to a robot and switch it on.');
  });
});
