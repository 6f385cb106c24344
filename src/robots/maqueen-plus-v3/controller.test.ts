import { describe, expect, it } from 'vitest';
import { putOnFloor, type FloorSetup } from '../testing/floor';
import { maqueenPlusV3Build } from './robot';

/** A Maqueen Plus V3 at (1000, 1000) heading along +x, its controller asked by the test. */
function controller(setup: FloorSetup = {}) {
  const floor = putOnFloor(maqueenPlusV3Build, setup);
  const write = (...bytes: number[]): boolean => floor.send(0x10, ...bytes);
  const read = (count: number): number[] => [...floor.board.i2c.read(0x10, count).bytes];
  const readFrom = (register: number, count: number) => floor.readFrom(0x10, register, count);
  return { ...floor, write, read, readFrom };
}

describe('Maqueen Plus V3, its controller at 0x10', () => {
  it('tells its version in 51 after the length in 50, though its end lies on other registers', () => {
    const { write, readFrom } = controller();
    write(63, 5);
    const [length = 0] = readFrom(50, 1);
    expect(String.fromCharCode(...readFrom(51, length))).toBe('MBT0050-EN-3.0');
    write(64, 2, 1, 44);
    expect(String.fromCharCode(...readFrom(51, length))).toBe('MBT0050-EN-3.0');
    expect(readFrom(51, 16).slice(14)).toEqual([1, 44]); // then come 65 and 66
    expect([readFrom(63, 1), readFrom(64, 3)]).toEqual([[5], [2, 1, 44]]);
  });

  it('reads from the register that was named, whatever was written after it: [76, 1] (mbrobot_plusV3)', () => {
    const { write, read, passMs } = controller();
    write(0, 0, 100, 0, 0);
    passMs(2000);
    write(76, 1);
    const [left = 0, right] = read(2);
    expect(Math.abs(left - 65)).toBeLessThanOrEqual(1); // 13 cm/s
    expect(right).toBe(0);
    expect(read(1)).toEqual([left]);
  });

  it('gives speeds in fifths of a cm/s without a sign, 255 at most', () => {
    const { write, readFrom, passMs } = controller({ options: { motors: '266' } });
    write(0, 1, 100, 0, 255);
    passMs(1500);
    const [left = 0, right] = readFrom(76, 2);
    expect(Math.abs(left - 130)).toBeLessThanOrEqual(1);
    expect(right).toBe(255);
  });

  it('measures the light on the left and on the right, high byte first, 0 to 1023', () => {
    const { board, readFrom } = controller();
    expect(readFrom(78, 4)).toEqual([1, 252, 1, 252]); // 508: a room
    board.sensors.set('lightLevel', 255);
    expect(readFrom(78, 4)).toEqual([3, 252, 3, 252]);
    board.sensors.set('lightLevel', 0);
    expect(readFrom(78, 4)).toEqual([0, 0, 0, 0]);
  });

  it('has its usual choices before a program writes any: patrol 2, ways 3 1 3 3, moves 2', () => {
    const { readFrom } = controller();
    expect([readFrom(63, 1), readFrom(69, 4), readFrom(85, 2)]).toEqual([[2], [3, 1, 3, 3], [2, 2]]);
  });

  it('gives 0 for encoders (jhautbois) and where nothing is known, and takes any writing there', () => {
    const { write, readFrom, robot, passMs } = controller();
    for (const register of [4, 5, 6, 7, 8, 10, 20, 21, 62, 88, 92, 200]) expect(write(register, 255)).toBe(true);
    write(0, 0, 100, 0, 100);
    passMs(1000);
    for (const register of [4, 5, 6, 7, 8, 61, 89, 92, 200]) expect(readFrom(register, 1)).toEqual([0]);
    expect(robot.state().servos).toEqual({});
  });

  it('stands with a direction that it does not know, as owners of a V2 saw it', () => {
    const { write, passMs, chassis } = controller();
    write(0, 2, 100, 2, 100);
    passMs(1000);
    expect(chassis.pathMm()).toBe(0);
  });

  it('starts anew for [73, 1]: silent for a moment, then as after switching on; other values do nothing', () => {
    const { write, readFrom, passMs, robot, chassis } = controller();
    write(0, 0, 100, 0, 100);
    write(11, 1, 2);
    write(63, 5);
    write(73, 0);
    expect(readFrom(63, 1)).toEqual([5]);
    write(73, 1);
    expect(write(50)).toBe(false);
    expect(robot.state().lamps.map(String)).toEqual(['0,0,0', '0,0,0']);
    passMs(100);
    expect([readFrom(0, 4), readFrom(63, 1), readFrom(50, 1)]).toEqual([[0, 0, 0, 0], [2], [14]]);
    passMs(500);
    expect(chassis.wheelSpeedMmPerS(0)).toBe(0);
  });
});

describe('Maqueen Plus V3, what it tells of the outputs that a program sets', () => {
  it('names lamps, motors, moves and patrol', () => {
    const told: string[] = [];
    const { write } = controller({ onSet: (output, value) => told.push(`${output} ${String(value)}`) });
    const after = (...bytes: number[]): string[] => {
      told.length = 0;
      write(...bytes);
      return [...told];
    };
    expect(after(12, 1)).toEqual(['light-right 255,0,0']);
    expect(after(2, 0, 51)).toEqual(['wheel-right 0.2']);
    expect(after(64, 2, 0, 30)).toEqual([]);
    expect(after(60, 6)).toEqual(['wheel-left −30 cm', 'wheel-right −30 cm']);
    expect(after(60, 16)).toEqual(['wheel-left 0', 'wheel-right 0']);
    after(67, 2, 90);
    expect(after(60, 6)).toEqual(['wheel-left 90°', 'wheel-right 90°']);
    expect(after(60, 5)).toEqual(['wheel-left line 2', 'wheel-right line 2']);
    expect(after(60, 8)).toEqual(['wheel-left 0', 'wheel-right 0']);
    expect(after(60, 8 | 16)).toEqual([]); // nothing runs
  });
});
