import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import type { OptionValues } from '#core/option';
import type { WallShape } from '#world/shapes';
import type { World } from '#world/world';
import { putOnFloor, type Floor } from '../testing/floor';
import { callibotBuild } from './robot';

let firmware: WebAssembly.Module;
beforeAll(async () => {
  firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));
});

const onTheFloor = (prepare?: (world: World) => void, options: OptionValues = {}): Floor =>
  putOnFloor(callibotBuild, prepare ? { prepare, options } : { options });

/** Runs a program that has imported everything from callibot and returns its output. */
function run(program: string, floor: Floor, forMs: number): readonly string[] {
  const { lines, exception } = floor.run(firmware, `from callibot import *\n${program}`, forMs);
  expect(exception).toBeNull();
  return lines;
}

/** Across the robot's path, its near face `distanceMm` ahead of the axle; `slantDeg` turns its left end away. */
function wallAhead(distanceMm: number, slantDeg = 0): WallShape {
  const x = 1005 + distanceMm;
  const shift = 600 * Math.tan((slantDeg * Math.PI) / 180);
  return { fromMm: { x: x - shift, y: 400 }, toMm: { x: x + shift, y: 1600 }, thicknessMm: 10 };
}

describe('Calli:bot, bumper', () => {
  it('is not there before a program reads it: the nose meets a wall at 60 mm', () => {
    const { send, passMs, chassis, robot } = onTheFloor((world) => world.addWall(wallAhead(200)));
    send(0x20, 0, 0, 60, 0, 60);
    passMs(3000);
    expect(robot.state().bumper).toBeNull();
    expect(chassis.pose().xMm - 1000 + 60).toBeCloseTo(200, 0);
  });

  it.each([
    ['a byte from 0x21', ({ board }: Floor) => void board.i2c.read(0x21, 1)],
    ['register 0x80', ({ readFrom }: Floor) => void readFrom(0x22, 0x80, 1)],
    ['tsValue()', (floor: Floor) => void run('tsValue()', floor, 10)],
  ])('is there once a program reads %s: then it meets the wall at 81 mm', (_, read) => {
    const floor = onTheFloor((world) => world.addWall(wallAhead(200)));
    read(floor);
    expect(floor.robot.state().bumper).toEqual({ left: false, right: false });
    floor.send(0x20, 0, 0, 60, 0, 60);
    floor.passMs(3000);
    expect(floor.chassis.pose().xMm - 1000 + 81).toBeCloseTo(200, 0);
    expect(floor.robot.state().bumper).toEqual({ left: true, right: true });
  });

  it('is pressed at once when it comes onto a robot whose nose is at a wall, and lets it back off', () => {
    const floor = onTheFloor((world) => world.addWall(wallAhead(200)));
    floor.send(0x20, 0, 0, 60, 0, 60);
    floor.passMs(3000);
    expect(run('print(tsValue())\nbackward()\ndelay(1000)\nstop()\nprint(tsValue())', floor, 1500)).toEqual(['1', '0']);
    expect(floor.chassis.pose().xMm - 1000 + 60).toBeLessThan(100);
  });

  it.each([
    ['straight', 0, 0x8f, '1 0 0', { left: true, right: true }],
    ['with its left half', -25, 0x8b, '0 1 0', { left: true, right: false }],
    ['with its right half', 25, 0x87, '0 0 1', { left: false, right: true }],
  ])(
    'driven into a wall %s gives its bits and tsValue() tsLeftValue() tsRightValue()',
    (_, slant, byte, text, half) => {
      const floor = onTheFloor((world) => world.addWall(wallAhead(300, slant)));
      const program = [
        'setSpeed(20)',
        'forward()',
        'while tsValue() + tsLeftValue() + tsRightValue() == 0:',
        '    delay(1)',
        'print(tsValue(), tsLeftValue(), tsRightValue())',
        'print(i2c.read(0x21, 1)[0], ts.getValue(), tsLeft.getValue(), tsRight.getValue())',
      ].join('\n');
      const lines = run(program, floor, 2500);
      const both = half.left && half.right ? 1 : 0;
      expect(lines).toEqual([text, `${byte} ${both} ${Number(half.left)} ${Number(half.right)}`]);
      expect(floor.robot.state().bumper).toEqual(half);
    },
  );

  it('lets go when the robot backs off', () => {
    const floor = onTheFloor((world) => world.addWall(wallAhead(120)), { bumper: 'always' });
    floor.send(0x20, 0, 0, 60, 0, 60);
    floor.passMs(1000);
    expect(floor.board.i2c.read(0x21, 1).bytes[0]).toBe(0x8f);
    floor.send(0x20, 0, 1, 60, 1, 60);
    floor.passMs(500);
    expect(floor.board.i2c.read(0x21, 1).bytes[0]).toBe(0x83);
  });

  it('is there from the start with the option “always”, never on a Calli:bot 1', () => {
    expect(onTheFloor(undefined, { bumper: 'always' }).robot.state().bumper).toEqual({ left: false, right: false });
    const old = onTheFloor(undefined, { bumper: 'always', model: '1' });
    expect(old.board.i2c.read(0x21, 1).bytes[0]).toBe(0x03);
    expect(old.robot.state().bumper).toBeNull();
  });

  it('stays off with an attachment, unless it was asked for', () => {
    const withClaw = onTheFloor(undefined, { S1: 'claw' });
    expect(withClaw.board.i2c.read(0x21, 1).bytes[0]).toBe(0x83);
    expect(withClaw.robot.state().bumper).toBeNull();
    expect(onTheFloor(undefined, { S1: 'claw', bumper: 'always' }).robot.state().bumper).not.toBeNull();
  });

  it('is twice as far ahead on a robot of twice the size', () => {
    const prepare = (world: World): void => world.addWall(wallAhead(250));
    const { send, passMs, chassis } = putOnFloor(callibotBuild, { prepare, scale: 2, options: { bumper: 'always' } });
    send(0x20, 0, 0, 60, 0, 60);
    passMs(3000);
    expect(chassis.pose().xMm - 1000 + 162).toBeCloseTo(250, 0);
  });
});
