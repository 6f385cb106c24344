/**
 * Effects of the school libraries' functions in the world that maqueen-effects.ts and the robots' tests do not cover.
 */
import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import type { World } from '#world/world';
import { callibotBuild } from './callibot/robot';
import { maqueenLiteBuild } from './maqueen-lite/robot';
import { maqueenPlusV1Build } from './maqueen-plus-v1/robot';
import { maqueenPlusV2Build } from './maqueen-plus-v2/robot';
import type { RobotBuild } from './robot';
import { putOnFloor, type Floor, type FloorSetup } from './testing/floor';

let firmware: WebAssembly.Module;
beforeAll(async () => {
  firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));
});

interface Setup extends FloorSetup {
  /** Duration of the program; 300 ms by default. */
  readonly forMs?: number;
}

/** Runs a program that imports everything from a library; the robot stands at (1000, 1000) and looks along +x. */
function run(build: RobotBuild, module: string, program: string, setup: Setup = {}) {
  const floor = putOnFloor(build, setup);
  const { lines, exception } = floor.run(firmware, `from ${module} import *\n${program}`, setup.forMs ?? 300);
  expect(exception).toBeNull();
  return { ...floor, lines };
}

/** A black line along the robot's path, its middle this many mm to its left. */
const lineAt =
  (leftMm: number, widthMm: number) =>
  (world: World): void => {
    const pointsMm = [800, 1200].map((x) => ({ x, y: 1000 + leftMm }));
    world.addStroke({ pointsMm, widthMm, reflectance: 0 });
  };

/** The pitch at the buzzer now, in Hz; 0 = silence. */
function pitchHz({ board }: Floor): number {
  const { pwm } = board.wire('P0');
  return pwm ? Math.round(1_000_000 / pwm.periodUs) : 0;
}

/** A library's line sensors from left to right: how to read one, and its distance to the left of the middle. */
interface LineSensors {
  readonly build: RobotBuild;
  readonly module: string;
  readonly read: (name: string) => string;
  readonly sideMm: Readonly<Record<string, number>>;
  /** Wide enough for one sensor, too narrow for two. */
  readonly lineMm: number;
}

const digital = (name: string): string => `${name}.read_digital()`;
const lineSensors: readonly LineSensors[] = [
  { build: maqueenLiteBuild, module: 'mbrobot', read: digital, sideMm: { irLeft: 7, irRight: -7 }, lineMm: 9 },
  { build: maqueenLiteBuild, module: 'mbrobotmot', read: digital, sideMm: { irLeft: 7, irRight: -7 }, lineMm: 9 },
  {
    build: maqueenPlusV2Build,
    module: 'mbrobot_plusV2',
    read: digital,
    sideMm: { irL2: 36, irL1: 12, irM: 0, irR1: -12, irR2: -36 },
    lineMm: 14,
  },
  {
    build: maqueenPlusV2Build,
    module: 'mbrobot_plusV2',
    read: digital,
    sideMm: { irLeft: 12, irRight: -12 },
    lineMm: 14,
  },
  {
    build: maqueenPlusV1Build,
    module: 'mbrobot_plus',
    read: digital,
    sideMm: { irL3: 45, irL2: 15, irL1: 5, irR1: -5, irR2: -15, irR3: -45 },
    lineMm: 8,
  },
  {
    build: callibotBuild,
    module: 'callibot',
    read: (name) => `${name}Value()`,
    sideMm: { irLeft: 6, irRight: -6 },
    lineMm: 8,
  },
  { build: callibotBuild, module: 'callibot', read: digital, sideMm: { irLeft: 6, irRight: -6 }, lineMm: 8 },
];

describe.each(lineSensors)('$module: line sensors $sideMm over a black line', (sensors) => {
  const { build, module, read, sideMm, lineMm } = sensors;
  const names = Object.keys(sideMm);
  const values = (prepare?: (world: World) => void): readonly string[] =>
    run(build, module, `print(${names.map(read).join(', ')})`, prepare ? { prepare } : {}).lines;

  it('give 1 on the bare floor', () => {
    expect(values()).toEqual([names.map(() => 1).join(' ')]);
  });

  it.each(Object.entries(sideMm))('give 0 at %s alone with a line %i mm to the left of the middle', (name, leftMm) => {
    expect(values(lineAt(leftMm, lineMm))).toEqual([names.map((other) => (other === name ? 0 : 1)).join(' ')]);
  });
});

describe('mbrobot_plusV2: what else it measures and moves', () => {
  const runV2 = (program: string, setup?: Setup) => run(maqueenPlusV2Build, 'mbrobot_plusV2', program, setup);

  it('read_analog() gives 230 on the floor and 100 over the line', () => {
    const program = 'print(*[sensor.read_analog() for sensor in (irL2, irL1, irM, irR1, irR2, irLeft, irRight)])';
    expect(runV2(program, { prepare: lineAt(12, 14) }).lines).toEqual(['230 100 230 230 230 100 230']);
  });

  it.each([
    ['setMinServoDuty(51)\nsetServo("P1", 0)', 45], // 51 of 1024 of 20 ms: 1.0 ms instead of 0.5 ms
    ['setMaxServoDuty(102)\nsetServo("P1", 180)', 133], // 2.0 ms instead of 2.5 ms
    ['setMinAngleVal(51)\nsetServo("P1", 0)', 45],
    ['setMaxAngleVal(102)\nsetServo("P1", 180)', 133],
  ])('%j turns the servo to %i degrees, within 2', (program, angleDeg) => {
    const angle = runV2(program).robot.state().servos['P1'] ?? NaN;
    expect(Math.abs(angle - angleDeg)).toBeLessThanOrEqual(2);
  });
});

/**
 * Libraries whose driving has no test in the world elsewhere, some with both wheels (`turns`), all with single ones at a
 * usual speed (`rotate`).
 */
const drivers = [
  { build: maqueenPlusV1Build, module: 'mbrobot_plus', turns: true, rotate: 50 },
  { build: maqueenLiteBuild, module: 'mbrobotmot', turns: false, rotate: 50 },
  { build: callibotBuild, module: 'callibot', turns: true, rotate: 40 },
  { build: callibotBuild, module: 'callibotmot', turns: false, rotate: 40 },
];

describe.each(drivers)('$module: each wheel by itself', ({ build, module, rotate }) => {
  const drive = (program: string) => run(build, module, program, { forMs: 1500 }).chassis;

  it.each([
    ['motL', 1, 0],
    ['motL', -1, 0],
    ['motR', 1, 1],
    ['motR', -1, 1],
  ] as const)('%s.rotate() turns that wheel alone, direction %i', (motor, direction, wheel) => {
    const chassis = drive(`${motor}.rotate(${direction * rotate})`);
    expect(chassis.wheelTurnRad(wheel) * direction).toBeGreaterThan(3);
    expect(Math.abs(chassis.wheelTurnRad(wheel === 0 ? 1 : 0))).toBeLessThan(0.3);
  });

  it('rotate(0) stops them again', () => {
    const both = (speed: number): string => `motL.rotate(${speed})\nmotR.rotate(${speed})\n`;
    const chassis = drive(`${both(rotate)}delay(500)\n${both(0)}`);
    expect(chassis.pathMm()).toBeGreaterThan(30);
    expect([chassis.wheelSpeedMmPerS(0), chassis.wheelSpeedMmPerS(1)]).toEqual([0, 0]);
  });
});

describe.each(drivers.filter(({ turns }) => turns))('$module: driving with both wheels', ({ build, module }) => {
  const drive = (program: string) => run(build, module, program, { forMs: 1500 }).chassis;

  it('forward() and backward() drive straight on, left() and right() turn on the spot', () => {
    expect(drive('forward()').pose().xMm - 1000).toBeGreaterThan(100);
    expect(drive('backward()').pose().xMm - 1000).toBeLessThan(-100);
    for (const [program, direction] of [
      ['left()', 1],
      ['right()', -1],
    ] as const) {
      const chassis = drive(program);
      expect(chassis.turnedRad() * direction).toBeGreaterThan(1);
      expect(Math.abs(chassis.pose().xMm - 1000) + Math.abs(chassis.pose().yMm - 1000)).toBeLessThan(1);
    }
  });

  it('leftArc() and rightArc() drive circles to their side, setSpeed() says how fast, stop() ends it', () => {
    expect(drive('leftArc(0.2)').turnedRad()).toBeGreaterThan(0.5);
    expect(drive('rightArc(0.2)').turnedRad()).toBeLessThan(-0.5);
    expect(drive('setSpeed(90)\nforward()').pathMm()).toBeGreaterThan(drive('setSpeed(40)\nforward()').pathMm() * 1.2);
    const stopped = drive('forward()\ndelay(500)\nstop()');
    expect([stopped.pathMm() > 30, stopped.wheelSpeedMmPerS(0)]).toEqual([true, 0]);
  });
});

describe('mbrobot_plus: senses, lights, servos', () => {
  const runV1 = (program: string, setup?: Setup) => run(maqueenPlusV1Build, 'mbrobot_plus', program, setup);

  it.each(['S1', 'S2', 'S3'])('setServo("%s", 120) turns that servo alone', (port) => {
    expect(runV1(`setServo("${port}", 120)`).robot.state().servos).toEqual({ [port]: 120 });
  });

  it.each([
    ['setLED(1)', 1, 1],
    ['setLED(1)\nsetLED(0)', 0, 0],
    ['setLED(2, 4)', 1, 1],
    ['setLEDLeft(3)', 1, 0],
    ['setLEDRight(3)', 0, 1],
  ])('%j shines: left %i, right %i', (program, left, right) => {
    const lights = runV1(program)
      .robot.state()
      .rgb.map((color) => Number(color.some((part) => part > 0)));
    expect(lights).toEqual([left, right]);
  });
});

const C6_HZ = 1047;

describe.each([
  { build: maqueenPlusV1Build, module: 'mbrobot_plus' },
  { build: callibotBuild, module: 'callibot' },
  { build: callibotBuild, module: 'cbalarm' },
  { build: maqueenLiteBuild, module: 'mbalarm' },
])('$module: setAlarm()', ({ build, module }) => {
  const board = build.type.board === 'calliope-mini-3' ? 'calliope_mini' : 'microbit';
  const sounding = (program: string, forMs: number) =>
    pitchHz(run(build, module, `from ${board} import sleep\n${program}`, { forMs }));

  it(`sounds at ${C6_HZ} Hz once it is on, and no more once it is off`, () => {
    expect(Math.abs(sounding('setAlarm(1)\nsleep(5000)', 60) - C6_HZ)).toBeLessThan(3);
    expect(sounding('setAlarm(1)\nsleep(300)\nsetAlarm(0)\nsleep(100)', 450)).toBe(0);
  });
});

describe('mbrobotmot: distance and lights', () => {
  it('getDistance() gives 30 for a wall 30 cm ahead of the sensor', () => {
    const wall = { fromMm: { x: 1360, y: 500 }, toMm: { x: 1360, y: 1500 }, thicknessMm: 10 };
    const setup: Setup = { prepare: (world) => world.addWall(wall) };
    expect(run(maqueenLiteBuild, 'mbrobotmot', 'print(getDistance())', setup).lines).toEqual(['30']);
  });

  it('setLED(1) lights both, setLED(0) none', () => {
    const leds = (program: string) => run(maqueenLiteBuild, 'mbrobotmot', program).robot.state().leds;
    expect(leds('setLED(1)')).toEqual({ left: 1, right: 1 });
    expect(leds('setLED(1)\nsetLED(0)')).toEqual({ left: 0, right: 0 });
  });
});
