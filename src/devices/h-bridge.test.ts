import { describe, expect, it } from 'vitest';
import { Wire } from '#board/wires/wire';
import { attachHBridge } from './h-bridge';

/** A motor, the board's ends of its inputs, and its duties so far. */
function motor() {
  const inputs = { forward: new Wire('P16'), backward: new Wire('P8') };
  const duties: number[] = [];
  const stop = attachHBridge(inputs, (duty) => duties.push(duty));
  const [forward, backward] = [inputs.forward.connect('board'), inputs.backward.connect('board')];
  return { forward, backward, duties, stop };
}

const pwm = (dutyFraction: number) => ({ periodUs: 20_000, dutyFraction });

describe('a motor at an H-bridge', () => {
  it('stands while nothing is connected to its inputs', () => expect(motor().duties).toEqual([0]));

  it('turns forward with the share of time in which the forward input is high: 0.25', () => {
    const { forward, duties } = motor();
    forward.drivePwm(pwm(0.25));
    expect(duties.at(-1)).toBe(0.25);
  });

  it('turns backward with the backward input, and follows a PWM signal that changes', () => {
    const { backward, duties } = motor();
    backward.drivePwm(pwm(0.5));
    backward.drivePwm(pwm(0.6));
    expect(duties.at(-1)).toBe(-0.6);
  });

  it('takes levels as full power: 1 and 0 forward, 0 and 1 backward, 1 and 1 stop', () => {
    const { forward, backward, duties } = motor();
    forward.drive(1);
    expect(duties.at(-1)).toBe(1);
    backward.drive(1);
    expect(duties.at(-1)).toBe(0);
    forward.drive(0);
    expect(duties.at(-1)).toBe(-1);
  });

  it('slows down against PWM on a high input: 1 forward, 0.75 backward is 0.25 forward', () => {
    const { forward, backward, duties } = motor();
    forward.drive(1);
    backward.drivePwm(pwm(0.75));
    expect(duties.at(-1)).toBe(0.25);
  });

  it('no longer listens once it is detached', () => {
    const { forward, duties, stop } = motor();
    stop();
    forward.drive(1);
    expect(duties).toEqual([0]);
  });
});
