import { describe, expect, it } from 'vitest';
import type { Rgb } from '#core/rgb';
import { nothingAround, putOnFloor, type FloorSetup } from '../testing/floor';
import { CONTROLLER_ADDRESS } from './controller';
import { cutebotBuild } from './robot';

/** A Cutebot at (1000, 1000) heading along +x in an arena of 3 m × 3 m; frames go to its controller. */
function onTheFloor(setup: FloorSetup = {}) {
  const floor = putOnFloor(cutebotBuild, setup);
  const send = (...frame: number[]): boolean => floor.send(CONTROLLER_ADDRESS, ...frame);
  return { ...floor, send };
}

const OFF: Rgb = [0, 0, 0];

describe('Cutebot: frames of four bytes (elecfreaks/EF_Produce_MicroPython Cutebot.py, pxt-cutebot cutebot.ts)', () => {
  it.each([
    [[1, 2, 50, 0], { left: 0.5, right: 0 }],
    [[1, 1, 50, 0], { left: -0.5, right: 0 }],
    [[2, 2, 100, 0], { left: 0, right: 1 }],
    [[2, 1, 7, 0], { left: 0, right: -0.07 }],
  ])('%j drives one motor: 1 left, 2 right; 2 forward, 1 backward; speed 0 … 100', (frame, duty) => {
    const { send, robot } = onTheFloor();
    expect(send(...frame)).toBe(true);
    expect(robot.state().duty).toEqual(duty);
  });

  it.each([
    ['[1, 1, 0, 0], as Elecfreaks sends it', 1],
    ['[1, 2, 0, 0], as Vittascience sends it', 2],
  ])('%s stops the left motor and leaves the right one', (_, direction) => {
    const { send, robot } = onTheFloor();
    send(1, 2, 80, 0);
    send(2, 2, 80, 0);
    send(1, direction, 0, 0);
    expect(robot.state().duty).toEqual({ left: 0, right: 0.8 });
  });

  it.each([
    [[4, 255, 10, 0], 0],
    [[8, 1, 2, 3], 1],
  ])('%j is the full colour of one headlamp: 4 left, 8 right', (frame, place) => {
    const { send, robot } = onTheFloor();
    send(...frame);
    const expected = [OFF, OFF, OFF, OFF].map((dark, i) => (i === place ? frame.slice(1) : dark));
    expect(robot.state().rgb).toEqual(expected);
  });

  it('[5, 30, 0, 0] turns servo S1, [6, 120, 0, 0] servo S2', () => {
    const { send, robot } = onTheFloor();
    send(5, 30, 0, 0);
    expect(robot.state().servos).toEqual({ S1: 30 });
    send(6, 120, 0, 0);
    expect(robot.state().servos).toEqual({ S1: 30, S2: 120 });
  });

  it('[5, 90, 0, 0] closes the claw that hangs at S1, and not at once', () => {
    const { send, robot, passMs } = onTheFloor({ options: { S1: 'claw' } });
    send(5, 30, 0, 0);
    passMs(500);
    send(5, 90, 0, 0);
    passMs(40);
    expect(robot.state().attachments[0]?.angleDeg).toBeLessThan(60);
    passMs(500);
    expect(robot.state().attachments[0]?.angleDeg).toBe(90);
  });

  it('counts a speed beyond 100 as 100: a negative number in a bytearray, −50, is 206', () => {
    const { send, robot } = onTheFloor();
    send(1, 2, 206, 0);
    expect(robot.state().duty.left).toBe(1);
  });

  it.each([
    ['an address probe', []],
    ['three bytes, as a Maqueen takes them', [1, 2, 50]],
    ['five bytes, as a Maqueen takes them', [0, 0, 50, 0, 50]],
    ['seven bytes, as a Cutebot Pro takes them', [0x99, 1, 1, 1, 50, 0, 0x88]],
    ['the unknown part 3', [3, 2, 50, 0]],
    ['the unknown part 0', [0, 2, 50, 0]],
    ['both lamps at once, 12', [12, 9, 9, 9]],
    ['direction 0', [1, 0, 50, 0]],
    ['direction 3', [2, 3, 50, 0]],
  ])('acknowledges %s and does nothing', (_, frame) => {
    const { send, robot } = onTheFloor();
    const before = robot.state();
    expect(send(...frame)).toBe(true);
    expect(robot.state()).toEqual(before);
  });

  it('has nothing to read: the bus stays released, 0xFF', () => {
    const { board } = onTheFloor();
    expect([...board.i2c.read(CONTROLLER_ADDRESS, 2).bytes]).toEqual([0xff, 0xff]);
  });
});

describe('Cutebot: what it tells of a program’s doings', () => {
  it('names the one motor, headlamp or servo of a frame, and the lights below as 2 and 3', () => {
    const { board, clock, chassis, robot, send } = onTheFloor();
    robot.detach();
    const told: string[] = [];
    cutebotBuild.attach({
      ...{ ...nothingAround, board, clock, chassis },
      onSet: (output, value) => void told.push(`${output} ${value}`),
    });
    send(2, 1, 30, 0);
    send(4, 9, 8, 7);
    send(8, 1, 2, 3);
    send(6, 120, 0, 0);
    board.wire('P15').stream(Uint8Array.of(2, 1, 3, 5, 4, 6));
    expect(told).toEqual([
      'wheel-right -0.3',
      'color-0 9,8,7',
      'color-1 1,2,3',
      'servo-S2 120',
      'color-2 1,2,3',
      'color-3 4,5,6',
    ]);
  });
});

describe('Cutebot: what is on which pin (pxt-cutebot cutebot.ts; microsoft/microbit-robot elecfreakscutebot.ts)', () => {
  /** A black line along the robot's way, its middle this many mm to the left. */
  const lineAt = (leftMm: number, widthMm: number): FloorSetup => ({
    prepare: (world) =>
      world.addStroke({
        pointsMm: [
          { x: 900, y: 1000 + leftMm },
          { x: 2000, y: 1000 + leftMm },
        ],
        widthMm,
        reflectance: 0,
      }),
  });

  it.each([
    ['the bare floor', 0, 0, [1, 1]],
    ['a line below the left sensor', 8, 10, [0, 1]],
    ['a line below the right sensor', -8, 10, [1, 0]],
    ['a line of 20 mm below both', 0, 20, [0, 0]],
  ])('reads P13 (left) and P14 (right) on %s: 0 is black', (_, leftMm, widthMm, levels) => {
    const { board, robot } = onTheFloor(widthMm === 0 ? {} : lineAt(leftMm, widthMm));
    expect([board.wire('P13').level, board.wire('P14').level]).toEqual(levels);
    expect(robot.state().lineSensors.map(({ bright }) => Number(bright))).toEqual(levels);
  });

  it('keeps to the level of its line sensors, whatever pull the program sets', () => {
    const { board } = onTheFloor(lineAt(0, 20));
    const reader = board.wire('P13').connect('test');
    for (const pull of ['up', 'down'] as const) {
      reader.pull(pull);
      expect(board.wire('P13').level).toBe(0);
    }
  });

  it('has two colour lights below at P15 that take green, red, blue', () => {
    const { board, robot } = onTheFloor();
    board.wire('P15').stream(Uint8Array.of(2, 1, 3, 5, 4, 6));
    expect(robot.state().rgb).toEqual([OFF, OFF, [1, 2, 3], [4, 5, 6]]);
  });

  it('measures with P8 (trigger) and P12 (echo): 582 µs for a wall 10 cm ahead of its sensor', () => {
    const { board, clock, passMs } = onTheFloor({
      prepare: (world) => world.addWall({ fromMm: { x: 1162, y: 500 }, toMm: { x: 1162, y: 1500 }, thicknessMm: 10 }),
    });
    const edges: number[] = [];
    board.wire('P12').onLevel(() => void edges.push(clock.nowUs));
    const trigger = board.wire('P8').connect('test');
    trigger.drive(1);
    trigger.drive(0);
    passMs(10);
    expect(edges).toHaveLength(2);
    expect(edges[1]! - edges[0]!).toBe(582);
  });

  it('holds P16 up with its infrared receiver', () => {
    expect(onTheFloor().board.wire('P16').level).toBe(1);
  });
});

describe('Cutebot on the floor', () => {
  const wheels = (left: number, right: number, ms: number, setup?: FloorSetup) => {
    const floor = onTheFloor(setup);
    floor.send(1, left < 0 ? 1 : 2, Math.abs(left), 0);
    floor.send(2, right < 0 ? 1 : 2, Math.abs(right), 0);
    floor.passMs(ms);
    return floor;
  };

  it('drives straight on, and turns on the spot about the middle of its axle', () => {
    const ahead = wheels(50, 50, 1000).chassis.pose();
    expect(ahead.xMm).toBeGreaterThan(1250);
    expect(Math.abs(ahead.yMm - 1000)).toBeLessThan(0.1);
    const { chassis } = wheels(-50, 50, 1000);
    expect(chassis.turnedRad()).toBeGreaterThan(Math.PI);
    expect(Math.hypot(chassis.pose().xMm - 1000, chassis.pose().yMm - 1000)).toBeLessThan(0.5);
  });

  it('stands below 15 and goes from 18 on: the motors do not work well below 15 (RayMorganti/elecfreaks-cutebot)', () => {
    expect(wheels(14, 14, 1000).chassis.pathMm()).toBe(0);
    expect(wheels(18, 18, 1000).chassis.pathMm()).toBeGreaterThan(40);
  });

  it('drives 20 cm/s at 24, 35 cm/s at 50, 45 cm/s at 100: estimated, see SOURCES.md', () => {
    const speeds = [24, 50, 100].map((speed) => wheels(speed, speed, 2000).chassis.wheelSpeedMmPerS(0));
    expect(speeds.map((mmPerS) => Math.round(mmPerS / 10))).toEqual([20, 35, 45]);
  });

  it('lets go of everything when it is taken off the board', () => {
    const { robot, chassis, board } = wheels(50, 50, 500);
    robot.detach();
    expect([chassis.duty(0), chassis.duty(1)]).toEqual([0, 0]);
    expect(board.i2c.answers(CONTROLLER_ADDRESS)).toBe(false);
  });
});
