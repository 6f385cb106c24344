import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import type { World } from '#world/world';
import { putOnFloor, type Floor } from '../testing/floor';
import { callibotBuild } from './robot';

let firmware: WebAssembly.Module;
beforeAll(async () => {
  firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));
});

/** Runs a program on a Calliope mini 3 with the robot at (1000, 1000), heading along +x. */
function run(program: string, prepare?: (world: World) => void, forMs = 3000): Floor & { lines: readonly string[] } {
  const floor = putOnFloor(callibotBuild, prepare ? { prepare } : {});
  const { lines, exception } = floor.run(firmware, `from calliopemini import *\n${program}`, forMs);
  expect(exception).toBeNull();
  return { ...floor, lines };
}

/** Across the path, its near face this many mm ahead of the ultrasonic sensor. */
const wallAhead =
  (distanceMm: number) =>
  (world: World): void => {
    const x = 1000 + 65 + distanceMm + 5;
    world.addWall({ fromMm: { x, y: 400 }, toMm: { x, y: 1600 }, thicknessMm: 10 });
  };

describe('Calli:bot, the ways in which drivers of strangers talk to it', () => {
  it('drives both motors with one buffer of five bytes, single ones with three (microsoft/microbit-robot)', () => {
    const { chassis } = run(
      'i2c.write(0x20, bytes([0, 1, 90, 1, 90]))\nsleep(500)\ni2c.write(0x20, bytes([2, 0, 90]))',
    );
    expect(chassis.pose().xMm).toBeLessThan(950);
    expect(chassis.turnedRad()).toBeGreaterThan(2);
  });

  it('takes negative powers that wrap in a bytearray: [0, 1, -90] is power 166 backward (OpenRoberta)', () => {
    const { robot } = run('i2c.write(0x20, bytearray([0, 1, -90]))\ni2c.write(0x20, bytearray([2, 1, -90]))');
    expect(robot.state().duty).toEqual({ left: -166 / 255, right: -166 / 255 });
  });

  it('steers by six bytes to 0x22 and asks the type first (calliope-net/fernsteuerung)', () => {
    const program = [
      'i2c.write(0x22, bytes([0x82]))',
      'print(i2c.read(0x22, 10)[1])',
      'i2c.write(0x22, bytes([2, 3, 0, 130, 0, 78]))',
    ].join('\n');
    const { lines, chassis } = run(program, undefined, 1500);
    expect(lines).toEqual(['3']);
    expect(chassis.turnedRad()).toBeLessThan(-1);
    expect(chassis.wheelTurnRad(1)).toBeGreaterThan(3);
  });

  it('drives 20 cm by its encoders, each wheel stopped by itself (calliope-net/callibot2)', () => {
    const program = `import struct
def encoders():
    i2c.write(0x22, b'\\x91', True)
    return struct.unpack('<ii', i2c.read(0x22, 9)[1:])
i2c.write(0x22, bytes([5, 3]))
i2c.write(0x22, bytes([2, 3, 0, 102, 0, 102]))
running = [1, 2]
while running:
    counts = encoders()
    for motor in running:
        if abs(counts[motor - 1]) >= 20 * 31.481197:
            i2c.write(0x22, bytes([2, motor, 0, 0]))
            running.remove(motor)
`;
    const wayMm = run(program).chassis.pose().xMm - 1000;
    expect(wayMm).toBeGreaterThan(198);
    expect(wayMm).toBeLessThan(215); // it rolls out
  });

  it('reads the line after choosing a register of 0x21: always the first byte (microsoft/microbit-robot)', () => {
    expect(run('i2c.write(0x21, b"\\x01")\nprint(i2c.read(0x21, 1)[0])').lines).toEqual(['131']);
  });

  it('measures by three bytes, with the high one first at 0x21 and the low one first at 0x22', () => {
    const program = [
      'import ustruct',
      'print(ustruct.unpack(">xH", i2c.read(0x21, 3))[0])',
      'i2c.write(0x22, b"\\x81")',
      'print(ustruct.unpack("<xH", i2c.read(0x22, 3))[0])',
    ].join('\n');
    expect(run(program, wallAhead(300)).lines).toEqual(['300', '300']);
  });

  it('backs off from a wall that it feels, led by its bumper’s bits (knotechgmbh/Callibot2)', () => {
    const program = `
i2c.write(0x20, bytes([0, 0, 80, 0, 80]))
while not i2c.read(0x21, 1)[0] & 0x0c:
    pass
i2c.write(0x20, bytes([0, 1, 80, 1, 80]))
sleep(400)
i2c.write(0x20, bytes(5))
print(i2c.read(0x21, 1)[0] & 0x0c)`;
    const { lines, chassis } = run(program, wallAhead(150));
    expect(lines).toEqual(['0']);
    expect(chassis.pose().xMm).toBeLessThan(1100);
  });

  it('shows all colour lights by five bytes to 0x21 (thkais/Callibot), one by five bytes to 0x22', () => {
    const { robot } = run('i2c.write(0x21, bytes([1] + 4 * [0xf2]))\ni2c.write(0x22, bytearray([3, 3, 0, 16, 8]))');
    expect(robot.state().rgb.map(String)).toEqual(['255,0,0', '255,0,0', '0,255,128', '255,0,0']);
  });

  it('turns its servos by single registers and by both at once', () => {
    const { robot } = run('i2c.write(0x20, bytes([0x15, 20]))\ni2c.write(0x20, bytes([0x14, 45, 135]))');
    expect(robot.state().servos).toEqual({ S1: 45, S2: 135 });
  });

  it('raises the device’s error for a MotionKit, which is not there: ENODEV (chbijou/mpyCalliope, mklib)', () => {
    const program = 'try:\n    i2c.write(0x10, bytes([0, 0, 50]))\nexcept OSError as error:\n    print(error)';
    expect(run(program).lines).toEqual(['[Errno 19] ENODEV']);
  });
});
