import { describe, expect, it } from 'vitest';
import { Board } from '#board/board';
import { microbitV2 } from '#board/boards/microbit-v2';
import { Wire } from '#board/wires/wire';
import { Clock } from '#core/clock';
import { attachPwmServo, createServo } from './servo';

/** How long an arm takes from one angle to another, in ms, looked at every ms. */
function travelMs(fromDeg: number, toDeg: number): number {
  const servo = createServo(fromDeg);
  servo.set(toDeg);
  let ms = 0;
  for (; servo.angleDeg !== toDeg && ms < 10_000; ms++) servo.pass(1000);
  return ms;
}

describe('Servo', () => {
  it.each([
    [30, 90, 120],
    [90, 30, 120],
    [0, 180, 360],
    [0, 110, 220],
    [90, 90, 0],
  ])('turns from %i° to %i° in %i ms', (from, to, ms) => {
    expect(travelMs(from, to)).toBe(ms);
  });

  it('is half-way after half of the time: 60° after 60 ms on the way from 30° to 90°', () => {
    const servo = createServo(30);
    servo.set(90);
    servo.pass(60_000);
    expect(servo.angleDeg).toBe(60);
  });

  it('turns back at once when told so on its way', () => {
    const servo = createServo(30);
    servo.set(90);
    servo.pass(60_000);
    servo.set(30);
    servo.pass(40_000);
    expect(servo.angleDeg).toBe(40);
  });

  it('goes no farther than 0° and 180°', () => {
    const servo = createServo(90);
    servo.set(255);
    servo.pass(1_000_000);
    expect(servo.angleDeg).toBe(180);
    servo.set(-20);
    servo.pass(1_000_000);
    expect(servo.angleDeg).toBe(0);
  });

  it('stays where it is while nobody tells it anything', () => {
    const servo = createServo(110);
    servo.pass(5_000_000);
    expect(servo.angleDeg).toBe(110);
  });
});

/** A servo on P0 of a micro:bit, and the angles it was told. */
function servoOnP0() {
  const clock = new Clock();
  const board = new Board(microbitV2, clock);
  const angles: number[] = [];
  const stop = attachPwmServo(board.wire('P0'), (angleDeg) => angles.push(angleDeg), { clock });
  const pin = board.pin('pin0');
  const pulse = (highUs: number): void => {
    pin.writeDigital(1);
    clock.advanceTo(clock.nowUs + highUs);
    pin.writeDigital(0);
  };
  const last = (): number => Math.round(angles[angles.length - 1] ?? NaN);
  return { clock, board, pin, angles, last, pulse, stop };
}

describe('Servo on a PWM wire', () => {
  it.each([
    [500, 0],
    [1000, 45],
    [1500, 90],
    [2000, 135],
    [2500, 180],
    [400, 0],
    [2600, 180],
  ])('takes a pulse of %i µs every 20 ms for %i°', (pulseUs, angleDeg) => {
    const wire = new Wire('P1');
    const angles: number[] = [];
    attachPwmServo(wire, (angle) => angles.push(angle));
    wire.connect('test').drivePwm({ periodUs: 20_000, dutyFraction: pulseUs / 20_000 });
    expect(angles).toHaveLength(1);
    expect(angles[0]).toBeCloseTo(angleDeg, 9);
  });

  it.each([
    [25, 0],
    [78, 92],
    [131, 180],
    [90, 113],
  ])('takes write_analog(%i) at the period of a start for about %i°', (value, angleDeg) => {
    const { pin, last } = servoOnP0();
    pin.writeAnalog(value);
    expect(last()).toBe(angleDeg);
  });

  it('looks at the pulse, not at the duty: half as long a period halves the angle of the same value', () => {
    const { pin, last } = servoOnP0();
    pin.writeAnalog(102);
    expect(last()).toBe(134);
    pin.setAnalogPeriodUs(10_000);
    expect(last()).toBe(45);
  });

  it.each([2_400, 30_100, 1_000])('does nothing at a period of %i µs', (periodUs) => {
    const { pin, angles } = servoOnP0();
    pin.setAnalogPeriodUs(periodUs);
    pin.writeAnalog(600);
    expect(angles).toEqual([]);
  });

  it('stays where it is when the signal ends or becomes a steady level', () => {
    const { pin, angles } = servoOnP0();
    pin.writeAnalog(77);
    pin.writeAnalog(0);
    pin.readDigital();
    expect(angles).toHaveLength(1);
  });

  it('hears a signal that was there before it was plugged in', () => {
    const wire = new Wire('P2');
    wire.connect('test').drivePwm({ periodUs: 20_000, dutyFraction: 0.075 });
    const angles: number[] = [];
    attachPwmServo(wire, (angle) => angles.push(angle));
    expect(angles).toEqual([90]);
  });

  it.each([
    [500, 0],
    [1500, 90],
    [2500, 180],
  ])('follows a pulse of %i µs that a program makes with write_digital: %i°', (highUs, angleDeg) => {
    const { angles, pulse } = servoOnP0();
    pulse(highUs);
    expect(angles).toEqual([angleDeg]);
  });

  it('takes a light that blinks for no signal: high for 20 ms', () => {
    const { angles, pulse } = servoOnP0();
    pulse(20_000);
    expect(angles).toEqual([]);
  });

  it('hears nothing any more once unplugged', () => {
    const { pin, angles, stop, pulse } = servoOnP0();
    stop();
    pin.writeAnalog(77);
    pulse(1500);
    expect(angles).toEqual([]);
  });
});
