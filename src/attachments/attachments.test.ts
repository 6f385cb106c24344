import { describe, expect, it } from 'vitest';
import type { OptionValues } from '#core/option';
import { callibotBuild } from '#robots/callibot/robot';
import { maqueenLiteBuild } from '#robots/maqueen-lite/robot';
import { maqueenPlusV2Build } from '#robots/maqueen-plus-v2/robot';
import type { RobotBuild } from '#robots/robot';
import { putOnFloor, type Floor } from '#robots/testing/floor';
import { scaledBody } from '#simulation/scaled-body';
import type { BlockHandle, WallShape } from '#world/shapes';

/** Program lines that drive and turn a servo on one kind of robot. */
interface Controls {
  readonly build: RobotBuild;
  /** Two servo ports. */
  readonly ports: readonly [string, string];
  /** Forward positive; the byte of both motors. */
  readonly drive: (floor: Floor, byte: number) => void;
  readonly servo: (floor: Floor, port: string, angleDeg: number) => void;
}

const motorBytes = (byte: number): readonly number[] => {
  const one = [byte < 0 ? 1 : 0, Math.abs(byte)];
  return [0x00, ...one, ...one];
};
const register = (port: string): number => (port === 'S1' ? 0x14 : 0x15);

const robots: readonly Controls[] = [
  {
    build: maqueenLiteBuild,
    ports: ['S1', 'S2'],
    drive: (floor, byte) => floor.send(0x10, ...motorBytes(byte)),
    servo: (floor, port, angleDeg) => floor.send(0x10, register(port), angleDeg),
  },
  {
    build: maqueenPlusV2Build,
    ports: ['P1', 'P2'],
    drive: (floor, byte) => floor.send(0x10, ...motorBytes(byte)),
    // As mbrobot_plusV2.py does: 25 … 131 of 1023 at 20 ms.
    servo: (floor, port, angleDeg) =>
      floor.board.pin(`pin${port.slice(1)}`).writeAnalog(Math.round(25 + (106 * angleDeg) / 180)),
  },
  {
    build: callibotBuild,
    ports: ['S1', 'S2'],
    drive: (floor, byte) => floor.send(0x20, ...motorBytes(byte)),
    servo: (floor, port, angleDeg) => floor.send(0x20, register(port), angleDeg),
  },
];

/** Power byte at which all robots drive at 5 … 15 cm/s. */
const SLOW = 60;

/** Distance from the axle to where attachments are fixed. */
const mountOf = ({ build }: Controls): number => build.type.mountMm?.x ?? NaN;

/** A robot at (1000, 1000) looking along +x, a block `gapMm` ahead of its mount, and perhaps a wall. */
function withBlock(controls: Controls, options: OptionValues, gapMm: number, wall?: WallShape, sizeMm = 50, scale = 1) {
  let block: BlockHandle | undefined;
  const floor = putOnFloor(controls.build, {
    options,
    scale,
    prepare: (world) => {
      const atMm = { x: 1000 + mountOf(controls) * scale + gapMm + sizeMm / 2, y: 1000 };
      block = world.addBlock({ atMm, sizeMm: { x: sizeMm, y: sizeMm }, angleRad: 0, fixed: false });
      if (wall) world.addWall(wall);
    },
  });
  const at = () => {
    const pose = block?.pose() ?? { xMm: NaN, yMm: NaN, headingRad: NaN };
    const robot = floor.chassis.pose();
    return { xMm: pose.xMm, yMm: pose.yMm, aheadMm: pose.xMm - robot.xMm, headingRad: pose.headingRad };
  };
  const drive = (byte: number, ms: number): void => {
    controls.drive(floor, byte);
    floor.passMs(ms);
    controls.drive(floor, 0);
    floor.passMs(200);
  };
  const turn = (angleDeg: number, port = controls.ports[0], ms = 500): void => {
    controls.servo(floor, port, angleDeg);
    floor.passMs(ms);
  };
  const attachment = (place = 0) => {
    const state = floor.robot.state().attachments[place];
    if (!state) throw new Error('Nothing hangs there.');
    return state;
  };
  return { ...floor, at, drive, turn, attachment };
}

const named = robots.map((controls) => [controls.build.type.name, controls] as const);

describe.each(named)('Claw on a %s', (_name, controls) => {
  const [port] = controls.ports;
  const facing = (gapMm: number, wall?: WallShape) => withBlock(controls, { [port]: 'claw' }, gapMm, wall);

  it('stands open at the start and closes in 112 ms from 30° to 86°', () => {
    const { turn, attachment } = facing(500);
    const openRad = (50 / 180) * Math.PI;
    expect(attachment()).toMatchObject({ type: 'claw', port, angleDeg: 30, isHolding: false, heightMm: 0 });
    expect(attachment().turnRad['jaw-left']).toBeCloseTo(openRad, 9);
    expect(attachment().turnRad['jaw-right']).toBeCloseTo(-openRad, 9);
    turn(86, port, 56);
    expect(attachment().angleDeg).toBeCloseTo(58, 9);
    expect(attachment().turnRad['jaw-left']).toBeGreaterThan(0.4 * openRad);
    turn(86, port, 60);
    expect(attachment().turnRad['jaw-left']).toBeCloseTo(0, 9);
  });

  it('grips a block of 5 cm that it was driven against, carries it back and lets it go', () => {
    const { at, drive, turn, attachment } = facing(60);
    drive(SLOW, 1500);
    const pushed = at();
    expect(attachment().isHolding).toBe(false);
    turn(90);
    expect(attachment().isHolding).toBe(true);
    expect(attachment().turnRad['jaw-left']).toBeGreaterThan(0.4); // held back by the block
    const gripped = at();
    drive(-SLOW, 1500);
    const carried = at();
    expect(carried.xMm).toBeLessThan(pushed.xMm - 50);
    expect(Math.abs(carried.aheadMm - gripped.aheadMm)).toBeLessThan(1);
    turn(30);
    expect(attachment().isHolding).toBe(false);
    drive(-SLOW, 1000);
    expect(Math.abs(at().xMm - carried.xMm)).toBeLessThan(2);
  });

  it('takes the block along when it turns on the spot', () => {
    const { at, chassis, turn, passMs } = facing(5);
    turn(100);
    const before = at();
    chassis.setDuty(0, -0.4);
    chassis.setDuty(1, 0.4);
    passMs(1500);
    const turnedRad = chassis.turnedRad();
    expect(turnedRad).toBeGreaterThan(1);
    const { xMm, yMm } = chassis.pose();
    const distanceMm = Math.hypot(at().xMm - xMm, at().yMm - yMm);
    expect(Math.abs(distanceMm - before.aheadMm)).toBeLessThan(1);
    expect(Math.abs(at().headingRad - before.headingRad - turnedRad)).toBeLessThan(0.01);
  });

  it.each([20, 30, 40, 60])('grips a block of %i mm', (sizeMm) => {
    const { at, drive, turn, attachment } = withBlock(controls, { [port]: 'claw' }, 30, undefined, sizeMm);
    drive(SLOW, 1000);
    turn(100);
    const gripped = at();
    drive(-SLOW, 1000);
    expect(at().aheadMm - gripped.aheadMm).toBeLessThan(40); // the block moves with the robot, held or between the jaws
    expect(attachment().isHolding).toBe(sizeMm >= 30);
  });

  it('cannot push a block that it holds through a wall', () => {
    const x = 1000 + mountOf(controls) + 200;
    const { at, drive, turn, attachment } = facing(5, {
      fromMm: { x: x + 5, y: 800 },
      toMm: { x: x + 5, y: 1200 },
      thicknessMm: 10,
    });
    turn(90);
    expect(attachment().isHolding).toBe(true);
    drive(255, 3000);
    expect(at().xMm + 25).toBeLessThan(x + 2);
    expect(at().xMm + 25).toBeGreaterThan(x - 5);
  });
});

describe.each(['forklift', 'loader'])('The %s', (kind) => {
  describe.each(named)('on a %s', (_name, controls) => {
    const [port] = controls.ports;
    const facing = (gapMm: number, wall?: WallShape) => withBlock(controls, { [port]: kind }, gapMm, wall);

    it('lies on the floor at the start and is 45 mm up 220 ms after the servo was sent from 110° to 0°', () => {
      const { turn, attachment } = facing(500);
      expect(attachment()).toMatchObject({ type: kind, port, angleDeg: 110, heightMm: 0, isHolding: false });
      turn(0, port, 112);
      expect(attachment().heightMm).toBeGreaterThan(20);
      expect(attachment().heightMm).toBeLessThan(25);
      turn(0, port, 112);
      expect(attachment().heightMm).toBeCloseTo(45, 9);
    });

    it('takes up a block that it was driven under, carries it clear of the floor and sets it down', () => {
      const { at, drive, turn, attachment } = facing(60);
      drive(SLOW, 1800);
      expect(attachment().isHolding).toBe(false);
      turn(0);
      expect(attachment()).toMatchObject({ isHolding: true, angleDeg: 0 });
      const lifted = at();
      drive(-SLOW, 1500);
      const carried = at();
      expect(carried.xMm).toBeLessThan(lifted.xMm - 50);
      expect(Math.abs(carried.aheadMm - lifted.aheadMm)).toBeLessThan(0.1);
      turn(110);
      expect(attachment()).toMatchObject({ isHolding: false, heightMm: 0 });
      drive(-SLOW, 1000);
      expect(Math.abs(at().xMm - carried.xMm)).toBeLessThan(2);
    });

    it('pulls nothing back with its fork on the floor', () => {
      const { at, drive } = facing(20);
      drive(SLOW, 1500);
      const pushed = at();
      drive(-SLOW, 1500);
      expect(Math.abs(at().xMm - pushed.xMm)).toBeLessThan(3);
    });

    it('cannot carry a block through a wall', () => {
      const x = 1000 + mountOf(controls) + 250;
      const { at, drive, turn, attachment } = facing(12, {
        fromMm: { x: x + 5, y: 800 },
        toMm: { x: x + 5, y: 1200 },
        thicknessMm: 10,
      });
      drive(SLOW, 300);
      turn(0);
      expect(attachment().isHolding).toBe(true);
      drive(255, 3000);
      expect(at().xMm + 25).toBeLessThan(x + 2);
    });
  });
});

describe.each(named)('Pusher on a %s', (_name, controls) => {
  const [port] = controls.ports;

  /** Distance in mm that the robot's sensor faces. */
  const seen = ({ robot }: Floor): number => Math.round(robot.state().ultrasonic?.distanceMm ?? NaN);

  it('turns the sensor: a wall 30 cm to the left is seen at 180°, one 40 cm to the right at 0°', () => {
    const wall = (y: number): WallShape => ({ fromMm: { x: 0, y }, toMm: { x: 2500, y }, thicknessMm: 10 });
    const floor = putOnFloor(controls.build, {
      options: { [port]: 'push' },
      prepare: (world) => {
        world.addWall(wall(1305));
        world.addWall(wall(595));
      },
    });
    expect(seen(floor)).toBeGreaterThan(900);
    controls.servo(floor, port, 180);
    floor.passMs(88);
    expect(floor.robot.state().attachments[0]?.angleDeg).toBeLessThan(140);
    floor.passMs(100);
    expect(Math.abs(seen(floor) - 295)).toBeLessThan(20);
    expect(floor.robot.state().attachments[0]?.turnRad['sonar']).toBeCloseTo(Math.PI / 2, 1);
    controls.servo(floor, port, 0);
    floor.passMs(400);
    expect(Math.abs(seen(floor) - 395)).toBeLessThan(20);
    controls.servo(floor, port, 90);
    floor.passMs(400);
    expect(seen(floor)).toBeGreaterThan(900);
  });

  it('pushes a block ahead of its plate', () => {
    const { at, drive } = withBlock(controls, { [port]: 'push' }, 40);
    const before = at();
    drive(SLOW, 2000);
    expect(at().xMm).toBeGreaterThan(before.xMm + 30);
    expect(at().aheadMm - 25 - mountOf(controls)).toBeGreaterThan(6);
    expect(Math.abs(at().yMm - 1000)).toBeLessThan(1);
  });
});

describe.each([0.5, 2, 3])('Attachments of a Maqueen Lite at scale %f', (scale) => {
  const type = maqueenLiteBuild.type;
  const build = { ...maqueenLiteBuild, type: { ...type, body: scaledBody(type.body, scale) } };
  const lite = robots.find((controls) => controls.build === maqueenLiteBuild);
  const facing = (kind: string) =>
    withBlock({ ...(lite as Controls), build }, { S1: kind }, 25 * scale, undefined, 50 * scale, scale);

  it.each([
    ['claw', 90],
    ['forklift', 0],
    ['loader', 0],
  ])('the %s takes a block of its own size along at %i°', (kind, angleDeg) => {
    const { at, drive, turn, attachment } = facing(kind);
    drive(SLOW, 1000);
    turn(angleDeg);
    expect(attachment().isHolding).toBe(true);
    expect(attachment().heightMm).toBeCloseTo(kind === 'claw' ? 0 : 45, 9); // that of the real robot
    const taken = at();
    drive(-SLOW, 1000);
    expect(at().xMm).toBeLessThan(taken.xMm - 40 * scale);
    expect(Math.abs(at().aheadMm - taken.aheadMm)).toBeLessThan(0.5 * scale);
  });
});

describe('Servo ports', () => {
  const [controls] = robots;
  if (!controls) throw new Error('No robot.');

  it('keep the angle that a program set, and say nothing of servos that it never set', () => {
    const { robot, turn } = withBlock(controls, { S1: 'claw', S2: 'none' }, 500);
    expect(robot.state().servos).toEqual({});
    turn(200, 'S1');
    expect(robot.state().servos).toEqual({ S1: 180 });
    expect(robot.state().attachments).toHaveLength(1);
    expect(robot.state().attachments[0]?.angleDeg).toBe(180);
  });

  it('carry a lift and a claw together: what the claw holds is lifted with it and set down again', () => {
    const { at, drive, turn, attachment } = withBlock(controls, { S1: 'forklift', S2: 'claw' }, 20);
    drive(SLOW, 700);
    turn(90, 'S2');
    expect(attachment(1)).toMatchObject({ type: 'claw', isHolding: true });
    turn(0, 'S1');
    const lifted = at();
    drive(-SLOW, 1000);
    expect(Math.abs(at().aheadMm - lifted.aheadMm)).toBeLessThan(0.5);
    turn(110, 'S1');
    turn(30, 'S2');
    const down = at();
    drive(-SLOW, 1000);
    expect(Math.abs(at().xMm - down.xMm)).toBeLessThan(3);
  });

  it('let an attachment go when the robot is detached: a block is held no more', () => {
    const { at, chassis, robot, turn, passMs } = withBlock(controls, { S1: 'claw' }, 5);
    turn(90);
    robot.detach();
    const before = at();
    chassis.setDuty(0, -0.3);
    chassis.setDuty(1, -0.3);
    passMs(1000);
    expect(Math.abs(at().xMm - before.xMm)).toBeLessThan(3);
  });
});
