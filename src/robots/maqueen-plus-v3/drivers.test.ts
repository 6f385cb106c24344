import { readFileSync } from 'node:fs';
import { beforeAll, describe, expect, it } from 'vitest';
import { putOnFloor, type FloorSetup } from '../testing/floor';
import { maqueenPlusV3Build } from './robot';

let firmware: WebAssembly.Module;
beforeAll(async () => {
  firmware = await WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));
});

/** Runs a program that brings its own driver. */
function drive(program: string, setup: FloorSetup = {}, forMs = 15_000) {
  const floor = putOnFloor(maqueenPlusV3Build, setup);
  const { lines, exception, hasEnded } = floor.run(firmware, `from microbit import *\n${program}`, forMs);
  expect(exception).toBeNull();
  expect(hasEnded).toBe(true);
  return { ...floor, lines };
}

/** A wall across the way, this many mm ahead of the lidar's lens. */
const wallAhead = (mm: number): FloorSetup => ({
  prepare: (world) => {
    const x = 1077 + mm + 5;
    world.addWall({ fromMm: { x, y: 0 }, toMm: { x, y: 3000 }, thicknessMm: 10, heightMm: 250 });
  },
});

const VITTASCIENCE = `
class Robot:
    def __init__(self, address=0x10):
        self.address = address
        self.put(0x49, 1)
        sleep(100)
        while self.get(0x32, 1)[0] == 0:
            sleep(100)
    def put(self, register, *values):
        i2c.write(self.address, bytearray([register] + list(values)))
    def get(self, register, count):
        i2c.write(self.address, bytearray([register]))
        return i2c.read(self.address, count)
    def version(self):
        return str(self.get(0x33, self.get(0x32, 1)[0]), 'utf-8')
    def run(self, direction, cm):
        self.put(0x40, direction)
        self.put(0x55, 2)
        self.put(0x41, cm >> 8)
        self.put(0x42, cm & 0xff)
        self.put(0x3c, 0x04 | 0x02)
        while self.get(0x57, 1)[0] != 0:
            sleep(10)
    def turn(self, direction, angle):
        self.put(0x43, direction)
        self.put(0x56, 2)
        self.put(0x44, angle)
        self.put(0x3c, 0x04 | 0x02)
        while self.get(0x57, 1)[0] != 0:
            sleep(10)
robot = Robot()
`;

describe('Maqueen Plus V3, the ways in which drivers of strangers talk to it', () => {
  it('starts anew, tells its version, drives 20 cm and turns by 90° to the left (Vittascience)', () => {
    const { lines, chassis } = drive(`${VITTASCIENCE}\nprint(robot.version())\nrobot.run(1, 20)\nrobot.turn(2, 90)`);
    expect(lines).toEqual(['MBT0050-EN-3.0']);
    expect(chassis.pose().xMm).toBeCloseTo(1200, 0);
    expect(chassis.turnedRad()).toBeCloseTo(Math.PI / 2, 2);
  });

  it('is found by a scan, gets a pause of 5 ms before each read, and waits for 87 the other way round: its moves end by themselves (jhautbois)', () => {
    const { lines, chassis } = drive(`
assert 0x10 in i2c.scan()
def read(register, count):
    i2c.write(0x10, bytes([register]))
    sleep(5)
    return i2c.read(0x10, count)
for register, value in ((0x40, 1), (0x41, 0), (0x42, 12), (0x55, 2), (0x3c, 6)):
    i2c.write(0x10, bytes([register, value]))
before = running_time()
while read(0x57, 1)[0] != 1 and running_time() - before < 10000:
    sleep(20)
while max(read(0x4c, 2)) > 0 or running_time() - before < 300:
    sleep(20)
print([b for b in read(4, 4)], running_time() - before < 3000)`);
    expect(lines).toEqual(['[0, 0, 0, 0] True']);
    expect(chassis.pose().xMm).toBeCloseTo(1120, 0);
  });

  it('measures points with a length that counts the arguments alone, and the whole row of zeros stays silent (jhautbois)', () => {
    const program = `
sleep(3000)
def point(x, y):
    i2c.write(0x33, bytes([0x55, 0, 2, 3, x, y]))
    sleep(10)
    reply = i2c.read(0x33, 6)
    return reply[4] | reply[5] << 8 if reply[0] == 0x53 else -1
print([point(x, 3) for x in range(8)])
i2c.write(0x33, bytes([0x55, 0, 0, 2]))
sleep(30)
print(list(i2c.read(0x33, 4)))`;
    const { lines } = drive(program, wallAhead(400));
    expect(lines).toEqual(['[400, 400, 400, 400, 400, 400, 400, 400]', '[255, 255, 255, 255]']);
  });

  it('starts as the maker’s blocks do, lights, drives, and reads byte by byte (DFRobot)', () => {
    const program = `
i2c.write(0x10, bytes([72, 3]))
i2c.write(0x10, bytes([73, 1]))
sleep(100)
i2c.write(0x10, bytes([50]))
while i2c.read(0x10, 1)[0] == 0:
    sleep(500)
i2c.write(0x10, bytes([11, 1, 4]))
sleep(3000)
def packet(command, *arguments):
    n = len(arguments) + 1
    i2c.write(0x33, bytes([0x55, n >> 8, n & 255, command]) + bytes(arguments))
    sleep(10)
    start = running_time()
    while running_time() - start < 8000:
        status = i2c.read(0x33, 1)[0]
        if status in (0x53, 0x63):
            if i2c.read(0x33, 1)[0] != command:
                return None
            low, high = i2c.read(0x33, 2)
            return i2c.read(0x33, low | high << 8) if low or high else b''
print(packet(1, 0, 0, 0, 4))
print(packet(7, 1, 0x2c))
data = packet(6)
print(data[0], data[1], [data[i] | data[i + 1] << 8 for i in (2, 4, 6)])`;
    const { lines, robot } = drive(program, wallAhead(150));
    expect(lines).toEqual(["b''", "b''", '1 0 [150, 150, 150]']);
    expect(robot.state().lamps.map(String)).toEqual(['255,0,0', '0,0,255']);
  });

  it('breaks off a turn when the lidar sees room, as a teacher’s programs do (sjh5637)', () => {
    const program = `
sleep(3500)
def put(*values):
    i2c.write(0x10, bytes(values))
def cell(x, y):
    i2c.write(0x33, bytes([0x55, 0, 3, 3, x, y]))
    sleep(12)
    reply = i2c.read(0x33, 6)
    return reply[4] | reply[5] << 8
put(67, 1); put(86, 2); put(68, 170); put(60, 6)
while cell(3, 3) < 600:
    pass
put(60, 16)
sleep(500)
i2c.write(0x10, bytes([76]))
print(list(i2c.read(0x10, 2)), cell(3, 3) >= 600)`;
    const { lines, chassis } = drive(program, wallAhead(300));
    expect(lines).toEqual(['[0, 0] True']);
    const turned = (-chassis.turnedRad() * 180) / Math.PI;
    expect(turned).toBeGreaterThan(40);
    expect(turned).toBeLessThan(100);
  });

  it('stands 30 cm before a wall that it has asked all cells for, in pieces of 32 bytes (franc0r)', () => {
    const program = `
sleep(3000)
def cells():
    i2c.write(0x33, b'\\x55\\x00\\x01\\x02')
    while True:
        head = i2c.read(0x33, 4)
        if head[0] == 0x53:
            break
        sleep(5)
    data = b''
    while len(data) < (head[2] | head[3] << 8):
        data += i2c.read(0x33, 32)
    return data
i2c.write(0x10, bytes([0, 0, 60, 0, 60]))
while True:
    data = cells()
    if data[2 * 27] | data[2 * 27 + 1] << 8 < 300:
        break
i2c.write(0x10, bytes(5))
sleep(300)`;
    const { robot } = drive(program, wallAhead(500));
    const ahead = robot.state().lidar?.depthMm[27] ?? 0;
    expect(ahead).toBeGreaterThan(270);
    expect(ahead).toBeLessThan(300);
  });
});

describe('mbrobot_plusV3 and the lidar, which answers 3 s after the robot is switched on', () => {
  it('waits for it when a program asks sooner', () => {
    const { lines } = drive(
      'from mbrobot_plusV3 import *\nprint(getDistanceAt(3, 3), running_time() // 1000)',
      wallAhead(300),
    );
    expect(lines).toEqual(['30 3']);
  });
});
