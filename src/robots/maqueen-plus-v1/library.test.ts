import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import { putOnFloor } from '../testing/floor';
import { CONTROLLER_ADDRESS } from './controller';
import { maqueenPlusV1Build } from './robot';

let firmware: WebAssembly.Module;
beforeAll(async () => {
  firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));
});

/** Runs a program that has imported everything, with another robot on the bus that only records what it receives. */
function bytesOf(program: string): number[][] {
  const { board, robot, run } = putOnFloor(maqueenPlusV1Build);
  robot.detach();
  const messages: number[][] = [];
  board.i2c.attach(CONTROLLER_ADDRESS, {
    write: (bytes) => void messages.push([...bytes]),
    read: (count) => new Uint8Array(count),
  });
  expect(run(firmware, `from mbrobot_plus import *\n${program}`, 1000).exception).toBeNull();
  return messages;
}

/** Runs a program on the robot. */
function onRobot(program: string, forMs = 1000) {
  const floor = putOnFloor(maqueenPlusV1Build);
  return { ...floor, ...floor.run(firmware, `from mbrobot_plus import *\n${program}`, forMs) };
}

describe('mbrobot_plus: driving, byte by byte (Tiger-Jython Robotics-Libraries mbrobot_plus.py)', () => {
  it.each([
    ['forward()', [[0, 1, 50, 1, 50]]],
    ['backward()', [[0, 2, 50, 2, 50]]],
    ['left()', [[0, 2, 47, 1, 47]]],
    ['right()', [[0, 1, 47, 2, 47]]],
    [
      'stop()',
      [
        [0x0a, 0],
        [0, 0, 0, 0, 0],
      ],
    ],
    [
      'setSpeed(100); forward()',
      [
        [0x0a, 0],
        [0, 1, 100, 1, 100],
      ],
    ],
    [
      'setSpeed(20); forward()',
      [
        [0x0a, 1],
        [0, 1, 50, 1, 50],
      ],
    ],
    [
      'setSpeed(30); forward()',
      [
        [0x0a, 0],
        [0, 1, 32, 1, 32],
      ],
    ],
    [
      'setSpeed(80); resetSpeed(); forward()',
      [
        [0x0a, 0],
        [0x0a, 0],
        [0, 1, 50, 1, 50],
      ],
    ],
    ['leftArc(0.2)', [[0, 1, 20, 1, 50]]],
    ['rightArc(0.3)', [[0, 1, 50, 1, 28]]],
    ['leftArc(0.05)', [[0, 1, 0, 1, 50]]],
    ['motL.rotate(50)', [[0, 1, 50]]],
    ['motR.rotate(-70)', [[2, 2, 70]]],
    ['motR.rotate(0)', [[2, 0, 0]]],
    [
      'setServo("S1", 90); setServo("S3", 10)',
      [
        [0x14, 90],
        [0x16, 10],
      ],
    ],
    ['setLED(LEDState.RED)', [[0x0b, 1, 1]]],
    ['setLED(2, 4)', [[0x0b, 2, 4]]],
    ['setLED(1, 0)', [[0x0b, 1, 1]]],
    [
      'setLEDLeft(3); setLEDRight(LEDState.WHITE)',
      [
        [0x0b, 3],
        [0x0c, 7],
      ],
    ],
  ])('%s sends %j', (program, messages) => {
    expect(bytesOf(program)).toEqual(messages);
  });

  it('refuses a servo that is not there', () => {
    expect(onRobot('setServo("P0", 90)').exception).toBe("ValueError: Unknown Servo. Please use 'S1', 'S2' or 'S3'.");
  });

  it('prints a line and goes on when the robot is off; a single motor waits for ever', () => {
    const { robot, run } = putOnFloor(maqueenPlusV1Build);
    robot.detach();
    const program = 'from mbrobot_plus import *\nforward()\nprint("on")\nmotL.rotate(20)\nprint("never")';
    const { lines, hasEnded } = run(firmware, program, 500);
    expect(lines).toEqual(['Please switch on mbRobot!', 'on', 'Please switch on mbRobot!']);
    expect(hasEnded).toBe(false);
  });
});

describe('mbrobot_plus and the lines of TigerJython’s worksheets', () => {
  it.each([
    ['RobotContext.setStartPosition(250, 490)', 'RobotContext.setStartPosition(250,490)'],
    ['RobotContext.useObstacle("sprites/bg.gif", 250, 250)', 'RobotContext.useObstacle(sprites/bg.gif,250,250)'],
    ['RobotContext.useObstacle("sprites/bg.gif")', 'RobotContext.useObstacle(sprites/bg.gif)'],
    ['RobotContext.enableTrace(True)', 'RobotContext.enableTrace(True)'],
    ['eraseBeamArea()', 'eraseBeamArea()'],
  ])('%s prints what it was asked for, as the original does', (program, line) => {
    expect(onRobot(program).lines).toEqual([line]);
  });
});

describe('mbrobot_plus in the world', () => {
  it('drives slower at speed 20, which the robot keeps by itself, than at speed 40', () => {
    const way = (speed: number): number => onRobot(`setSpeed(${speed})\nforward()`, 2000).chassis.pathMm();
    expect(way(20)).toBeGreaterThan(100);
    expect(way(20)).toBeLessThan(0.9 * way(40));
  });

  it('sees 1 on the bare floor with all six line sensors', () => {
    const { lines } = onRobot('print([s.read_digital() for s in (irL3, irL2, irL1, irR1, irR2, irR3)])');
    expect(lines).toEqual(['[1, 1, 1, 1, 1, 1]']);
  });

  it('measures the wall around the arena, 192.6 cm ahead: 192', () => {
    expect(onRobot('print(getDistance())').lines).toEqual(['192']);
  });

  it('lights yellow on the left and blue on the right', () => {
    expect(onRobot('setLED(LEDState.YELLOW, LEDState.BLUE)').robot.state().rgb).toEqual([
      [255, 255, 0],
      [0, 0, 255],
    ]);
  });
});
