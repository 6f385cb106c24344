/** Effects of a school library's functions in the world, the same for both Maqueens that have such a library. */
import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import type { RobotBuild } from '../robot';
import { putOnFloor, type Floor, type FloorSetup } from './floor';

/** One of the Maqueens with its school library. */
export interface SchoolRobot {
  readonly build: RobotBuild;
  /** Name of the library. */
  readonly module: string;
  /** Distance of its sensor ahead of the axle. */
  readonly sonarMm: number;
  /** Its servo ports, as programs call them. */
  readonly ports: readonly string[];
}

type RunProgram = (
  program: string,
  forMs?: number,
  setup?: FloorSetup,
) => Floor & { readonly lines: readonly string[] };

/** Tests each function of the library: the program runs, the robot stands at (1000, 1000) and looks along +x. */
export function describeEffects(robot: SchoolRobot): void {
  let firmware: WebAssembly.Module;
  beforeAll(async () => {
    firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));
  });
  const run: RunProgram = (program, forMs = 2000, setup = {}) => {
    const floor = putOnFloor(robot.build, setup);
    const { lines, exception } = floor.run(firmware, `from ${robot.module} import *\n${program}`, forMs);
    expect(exception).toBeNull();
    return { ...floor, lines };
  };
  describe(`${robot.build.type.name}, driven with ${robot.module}`, () => {
    straightAndSpin(run);
    arcs(run);
    calibration(run);
  });
  describe(`${robot.build.type.name}, its senses and lights with ${robot.module}`, () => {
    distance(run, robot);
    lights(run);
    sounds(run);
    servos(run, robot);
  });
}

function straightAndSpin(run: RunProgram): void {
  it.each([
    ['forward()', 1],
    ['backward()', -1],
  ])('%s drives straight on', (program, direction) => {
    const { chassis } = run(program);
    const { xMm, yMm, headingRad } = chassis.pose();
    expect((xMm - 1000) * direction).toBeGreaterThan(150);
    expect(Math.abs(yMm - 1000)).toBeLessThan(0.1);
    expect(Math.abs(headingRad)).toBeLessThan(0.001);
  });

  it.each([
    ['left()', 1],
    ['right()', -1],
  ])('%s turns on the spot', (program, direction) => {
    const { chassis } = run(program);
    expect(chassis.turnedRad() * direction).toBeGreaterThan(2);
    expect(Math.abs(chassis.pose().xMm - 1000) + Math.abs(chassis.pose().yMm - 1000)).toBeLessThan(0.2);
  });

  it('stop() makes both wheels stand', () => {
    const { chassis } = run('forward()\ndelay(1000)\nstop()');
    expect([chassis.wheelSpeedMmPerS(0), chassis.wheelSpeedMmPerS(1)]).toEqual([0, 0]);
    expect(chassis.pathMm()).toBeGreaterThan(50);
  });

  it('setSpeed() decides how far it gets: 30 less than 50, 50 less than 90, 0 nowhere', () => {
    const pathMm = (percent: number) => run(`setSpeed(${percent})\nforward()`).chassis.pathMm();
    const paths = [0, 30, 50, 90].map(pathMm);
    expect(paths[0]).toBe(0);
    expect([...paths].sort((a, b) => a - b)).toEqual(paths);
    expect(paths[3]! / paths[1]!).toBeGreaterThan(1.5);
  });

  it.each([
    ['motL.rotate(50)', 0, 1, -1],
    ['motL.rotate(-50)', 0, -1, 1],
    ['motR.rotate(50)', 1, 1, 1],
    ['motR.rotate(-50)', 1, -1, -1],
  ] as const)('%s turns that wheel alone and the robot about the other', (program, wheel, direction, turn) => {
    const { chassis } = run(program);
    expect(chassis.wheelTurnRad(wheel) * direction).toBeGreaterThan(3);
    expect(Math.abs(chassis.wheelTurnRad(wheel === 0 ? 1 : 0))).toBeLessThan(0.3);
    expect(chassis.turnedRad() * turn).toBeGreaterThan(1);
  });
}

function arcs(run: RunProgram): void {
  it.each([
    ['leftArc', 1],
    ['rightArc', -1],
  ])('%s(0.2) drives a circle of 20 cm, within a third, to its side', (name, direction) => {
    const { chassis, passMs } = run(`${name}(0.2)`);
    const [path, turned] = [chassis.pathMm(), chassis.turnedRad()];
    passMs(2000);
    const radiusMm = (chassis.pathMm() - path) / ((chassis.turnedRad() - turned) * direction);
    expect(Math.abs(radiusMm / 200 - 1)).toBeLessThan(0.33);
  });
}

function calibration(run: RunProgram): void {
  it('calibrate(20) makes it faster, calibrate(0, 20) steer to the left, calibrate(0, -20) to the right', () => {
    const after = (program: string) => run(`${program}\nforward()`).chassis;
    expect(after('calibrate(20)').pathMm()).toBeGreaterThan(after('calibrate(0)').pathMm() * 1.1);
    expect(after('calibrate(0, 20)').turnedRad()).toBeGreaterThan(0.1);
    expect(after('calibrate(0, -20)').turnedRad()).toBeLessThan(-0.1);
  });

  it('calibrate(0, d) straightens a robot whose right motor is weaker', () => {
    const drift = (program: string): number => {
      const { chassis } = run(`${program}\nforward()`, 2000, { strength: [1, 0.9] });
      return Math.abs(chassis.turnedRad());
    };
    expect(drift('calibrate(0)')).toBeGreaterThan(0.1);
    expect(drift('calibrate(0, 10)')).toBeLessThan(drift('calibrate(0)') / 2);
  });
}

function distance(run: RunProgram, { sonarMm }: SchoolRobot): void {
  it.each([3, 10, 42, 100])('getDistance() gives %i for a wall so many cm ahead', (cm) => {
    const x = 1000 + sonarMm + cm * 10 + 5;
    const wall = { fromMm: { x, y: 500 }, toMm: { x, y: 1500 }, thicknessMm: 10 };
    const { lines } = run('print(getDistance())', 500, { prepare: (world) => world.addWall(wall) });
    expect(lines).toEqual([String(cm)]);
  });

  it('getDistance() counts down while it drives towards a wall', () => {
    const wall = { fromMm: { x: 1700, y: 500 }, toMm: { x: 1700, y: 1500 }, thicknessMm: 10 };
    const program = 'forward()\nfor i in range(5):\n    print(getDistance())\n    delay(300)\nstop()';
    const { lines } = run(program, 2000, { prepare: (world) => world.addWall(wall) });
    const seen = lines.map(Number);
    expect(seen).toHaveLength(5);
    expect([...seen].sort((a, b) => b - a)).toEqual(seen);
    expect(seen[0]! - seen[4]!).toBeGreaterThan(10);
  });
}

function lights(run: RunProgram): void {
  it.each([
    ['setLED(1)', 1, 1],
    ['setLED(1)\nsetLED(0)', 0, 0],
    ['setLED(1, 0)', 1, 0],
    ['setLED(0, 1)', 0, 1],
    ['setLED(1, stateR=0)', 1, 0],
    ['setLEDLeft(1)', 1, 0],
    ['setLEDRight(1)', 0, 1],
    ['setLED(1)\nsetLEDLeft(0)', 0, 1],
  ])('%j shines: left %i, right %i', (program, left, right) => {
    expect(run(program, 200).robot.state().leds).toEqual({ left, right });
  });

  it.each([
    ['fillRGB(1, 2, 3)', ['1,2,3', '1,2,3', '1,2,3', '1,2,3']],
    ['setRGB(1, 2, 3)', ['1,2,3', '1,2,3', '1,2,3', '1,2,3']],
    ['setRGB(1, 4, 5, 6)', ['0,0,0', '4,5,6', '0,0,0', '0,0,0']],
    ['posRGB(3, 7, 8, 9)', ['0,0,0', '0,0,0', '0,0,0', '7,8,9']],
    ['fillRGB(9, 9, 9)\nclearRGB()', ['0,0,0', '0,0,0', '0,0,0', '0,0,0']],
  ])('%j colours the lights below: front left, back left, back right, front right', (program, colors) => {
    expect(run(program, 200).robot.state().rgb.map(String)).toEqual(colors);
  });
}

/** The pitch at the buzzer now, in Hz; 0 = silence. */
function pitchHz({ board }: Floor): number {
  const { pwm } = board.wire('P0');
  return pwm ? Math.round(1_000_000 / pwm.periodUs) : 0;
}

function sounds(run: RunProgram): void {
  it('beep() sounds 440 Hz at the buzzer for 200 ms', () => {
    const floor = run('beep()', 150);
    expect(pitchHz(floor)).toBe(440);
    expect(pitchHz(run('beep()\ndelay(500)', 600))).toBe(0);
  });

  it('setAlarm(1) sounds on while the robot drives, setAlarm(0) ends it', () => {
    expect(pitchHz(run('setAlarm(1)\nforward()\ndelay(5000)', 60))).toBe(523);
    expect(pitchHz(run('setAlarm(1)\ndelay(300)\nsetAlarm(0)\ndelay(100)', 450))).toBe(0);
  });
}

function servos(run: RunProgram, { ports }: SchoolRobot): void {
  it.each(ports)('setServo("%s", angle) turns the servo there: 0, 45, 90 and 180 degrees, within 2', (port) => {
    for (const angle of [0, 45, 90, 180]) {
      const { robot } = run(`setServo("${port}", ${angle})`, 300);
      const turned = Object.values(robot.state().servos);
      expect(turned).toHaveLength(1);
      expect(Math.abs(turned[0]! - angle)).toBeLessThanOrEqual(2);
    }
  });

  it.each(ports)('setServo("%s", angle) moves the claw that hangs there, and not at once', (port) => {
    const options = { [port]: 'claw' };
    const { robot, passMs } = run(`setServo("${port}", 30)\ndelay(500)\nsetServo("${port}", 90)`, 540, { options });
    const angle = () => robot.state().attachments[0]?.angleDeg ?? NaN;
    expect(angle()).toBeGreaterThan(30);
    expect(angle()).toBeLessThan(60);
    passMs(500);
    expect(Math.abs(angle() - 90)).toBeLessThanOrEqual(2);
  });
}
