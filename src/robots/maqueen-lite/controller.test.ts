import { describe, expect, it } from 'vitest';
import { createController, VERSION, type MotorBytes } from './controller';

/** A controller with a log of what it told its motors and servos, and a short form to send bytes. */
function controller() {
  const motors: { left: MotorBytes; right: MotorBytes }[] = [];
  const servos: [string, number][] = [];
  const target = createController({
    motors: (left, right) => motors.push({ left, right }),
    servo: (port, angleDeg) => servos.push([port, angleDeg]),
  });
  const write = (...bytes: number[]): void => target.write(Uint8Array.from(bytes));
  const read = (count: number): number[] => [...target.read(count)];
  /** Left direction, left speed, right direction, right speed as last reported. */
  const state = (): number[] | null => {
    const last = motors.at(-1);
    return last ? [last.left.direction, last.left.speed, last.right.direction, last.right.speed] : null;
  };
  return { write, read, state, motors, servos };
}

describe('Maqueen Lite controller: motors', () => {
  it('takes [0x00, 0, 100] as left motor forward at 100 (DFRobot pxt-maqueen, motorRun)', () => {
    const { write, state } = controller();
    write(0x00, 0, 100);
    expect(state()).toEqual([0, 100, 0, 0]);
  });

  it('takes [0x02, 1, 80] as right motor backward at 80 (DFRobot pxt-maqueen, motorRun)', () => {
    const { write, state } = controller();
    write(0x02, 1, 80);
    expect(state()).toEqual([0, 0, 1, 80]);
  });

  it('takes [0x00, 0, 39, 1, 40] for both motors at once (Tiger-Jython mbrobot.py)', () => {
    const { write, state, motors } = controller();
    write(0x00, 0, 39, 1, 40);
    expect(state()).toEqual([0, 39, 1, 40]);
    expect(motors).toHaveLength(1);
  });

  it('keeps the left motor when only the right one is written', () => {
    const { write, state } = controller();
    write(0x00, 0, 39, 0, 39);
    write(0x02, 1, 20);
    expect(state()).toEqual([0, 39, 1, 20]);
  });

  it('stays where it is for [0x00, 1]: a direction without a speed moves nothing (kichinosukey, activate_motor_driver)', () => {
    const { write, state } = controller();
    write(0x00, 1);
    expect(state()).toEqual([1, 0, 0, 0]);
  });

  it('turns a running left motor around for [0x00, 1]', () => {
    const { write, state } = controller();
    write(0x00, 0, 50);
    write(0x00, 1);
    expect(state()).toEqual([1, 50, 0, 0]);
  });

  it('takes a speed alone, [0x01, 77]', () => {
    const { write, state } = controller();
    write(0x01, 77);
    expect(state()).toEqual([0, 77, 0, 0]);
  });

  it('takes four bytes from register 1: speed, direction, speed', () => {
    const { write, state } = controller();
    write(0x01, 60, 1, 70);
    expect(state()).toEqual([0, 60, 1, 70]);
  });

  it('gives the motor registers back when read from 0x00', () => {
    const { write, read } = controller();
    write(0x00, 0, 39, 1, 40);
    write(0x00);
    expect(read(4)).toEqual([0, 39, 1, 40]);
  });

  it('does not touch the motors when a register is only selected or the address probed', () => {
    const { write, motors } = controller();
    write(0x00);
    write();
    expect(motors).toEqual([]);
  });
});

describe('Maqueen Lite controller: servos', () => {
  it('turns S1 to 90° for [0x14, 90] and S2 to 180° for [0x15, 180] (DFRobot pxt-maqueen, servoRun)', () => {
    const { write, servos } = controller();
    write(0x14, 90);
    write(0x15, 180);
    expect(servos).toEqual([
      ['S1', 90],
      ['S2', 180],
    ]);
  });

  it('turns both for [0x14, 10, 20]', () => {
    const { write, servos } = controller();
    write(0x14, 10, 20);
    expect(servos).toEqual([
      ['S1', 10],
      ['S2', 20],
    ]);
  });
});

describe('Maqueen Lite controller: version', () => {
  it('gives its length at 0x32 and its text from 0x33 (DFRobot pxt-maqueen, IR_read_version)', () => {
    const { write, read } = controller();
    write(0x32);
    const [length = 0] = read(1);
    write(0x33);
    expect(String.fromCharCode(...read(length))).toBe(VERSION);
  });

  it('gives length and text in one read that starts at 0x32', () => {
    const { write, read } = controller();
    write(0x32);
    expect(read(3)).toEqual([VERSION.length, 'R'.charCodeAt(0), 'O'.charCodeAt(0)]);
  });

  it('cannot be overwritten', () => {
    const { write, read } = controller();
    write(0x32, 1, 65, 65);
    write(0x32);
    expect(read(2)).toEqual([VERSION.length, 'R'.charCodeAt(0)]);
  });
});

describe('Maqueen Lite controller: everything else', () => {
  it('ignores writes to registers it does not have and reads them as 0', () => {
    const { write, read, motors, servos } = controller();
    write(0x49, 1); // start-up write of DFRobot's library for newer robots
    write(0x0b, 1, 1); // LEDs of the Plus
    write(0x49);
    expect(read(1)).toEqual([0]);
    write(0x0b);
    expect(read(2)).toEqual([0, 0]);
    expect([motors, servos]).toEqual([[], []]);
  });

  it('wraps from register 255 to 0 like an 8-bit counter', () => {
    const { write, state } = controller();
    write(0xff, 9, 1, 30);
    expect(state()).toEqual([1, 30, 0, 0]);
  });
});
