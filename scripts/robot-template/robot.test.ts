import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { putOnFloor } from '../testing/floor';
import { CONTROLLER_ADDRESS } from './controller';
import { newRobotBuild } from './robot';

const firmware = new WebAssembly.Module(readFileSync('.cache/vm/vm.wasm'));

describe('New Robot, its controller', () => {
  it('drives forward for [0x00, 0, 100, 0, 100] and gives the bytes back', () => {
    const { robot, chassis, send, readFrom, passMs } = putOnFloor(newRobotBuild);
    expect(send(CONTROLLER_ADDRESS, 0x00, 0, 100, 0, 100)).toBe(true);
    expect(robot.state().duty).toEqual({ left: 100 / 255, right: 100 / 255 });
    expect(readFrom(CONTROLLER_ADDRESS, 0x00, 4)).toEqual([0, 100, 0, 100]);
    passMs(1000);
    expect(chassis.pose().xMm).toBeGreaterThan(1100);
    expect(Math.abs(chassis.pose().yMm - 1000)).toBeLessThan(0.01);
  });

  it('turns to the left for [0x00, 1, 100, 0, 100]', () => {
    const { chassis, send, passMs } = putOnFloor(newRobotBuild);
    send(CONTROLLER_ADDRESS, 0x00, 1, 100, 0, 100);
    passMs(500);
    expect(chassis.turnedRad()).toBeGreaterThan(0.5);
  });
});

describe('New Robot, what is on which pin', () => {
  it('has its red light at P8', () => {
    const { board, robot } = putOnFloor(newRobotBuild);
    board.wire('P8').connect('test').drive(1);
    expect(robot.state().leds.left).toBe(1);
  });

  it('reads 1 at P13 on the bare floor and 0 on a black line', () => {
    expect(putOnFloor(newRobotBuild).board.wire('P13').level).toBe(1);
    const ends = [
      { x: 1040, y: 900 },
      { x: 1040, y: 1100 },
    ];
    const line = { pointsMm: ends, widthMm: 20, reflectance: 0 };
    const { board } = putOnFloor(newRobotBuild, { prepare: (world) => world.addStroke(line) });
    expect(board.wire('P13').level).toBe(0);
  });
});

describe('new_robot.py', () => {
  it.each([
    ['forward()', [0, 100, 0, 100]],
    ['left()', [1, 100, 0, 100]],
    ['right()', [0, 100, 1, 100]],
    ['motors(-300, 20)', [1, 255, 0, 20]],
    ['stop()', [0, 0, 0, 0]],
  ])('%s writes %j', (program, bytes) => {
    const { run, readFrom } = putOnFloor(newRobotBuild);
    expect(run(firmware, `from new_robot import *\n${program}`, 100).exception).toBeNull();
    expect(readFrom(CONTROLLER_ADDRESS, 0x00, 4)).toEqual(bytes);
  });

  it('sees the bare floor: isLight() is 1', () => {
    const { run } = putOnFloor(newRobotBuild);
    expect(run(firmware, 'from new_robot import *\nprint(isLight())', 100).lines).toEqual(['1']);
  });
});
