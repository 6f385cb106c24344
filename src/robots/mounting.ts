/** Shared mounting of all robots: two motors and the servos of their ports. */
import { attachServoPorts, type ServoPorts } from '#attachments/servo-ports';
import type { Rgb } from '#core/rgb';
import type { Side } from '#devices/dc-motor';
import type { Stop } from '#core/stop';
import { attachPwmServo } from '#devices/servo';
import type { RobotContext, RobotState, RobotType } from './robot';

/** Both motors of a robot. */
export interface Motors {
  /** Duties −1 … 1. */
  readonly drive: (left: number, right: number) => void;
  /** The same for what the program sets. @param sides the motors that it has named */
  readonly set: (left: number, right: number, sides: readonly Side[]) => void;
  /** The duties last set. */
  readonly duty: () => RobotState['duty'];
  readonly stop: () => void;
}

/** Puts the motors on a chassis, which keeps their settings. */
export function mountMotors({ chassis, onSet }: Pick<RobotContext, 'chassis' | 'onSet'>): Motors {
  const drive = (left: number, right: number): void => {
    chassis.setDuty(0, left);
    chassis.setDuty(1, right);
  };
  return {
    drive,
    set: (left, right, sides) => {
      drive(left, right);
      for (const side of sides) onSet?.(`wheel-${side}`, side === 'left' ? left : right);
    },
    duty: () => ({ left: chassis.duty(0), right: chassis.duty(1) }),
    stop: () => drive(0, 0),
  };
}

/** Puts servos on a robot's ports, and on the servos the attachments that the robot's options name. */
export function mountServos(
  { chassis, options, scale, onSet }: RobotContext,
  { mountMm }: RobotType,
  ports: readonly string[],
): ServoPorts {
  const servos = attachServoPorts(ports, options, mountMm && { chassis, mountMm, scale });
  return {
    ...servos,
    set: (port, angleDeg) => {
      servos.set(port, angleDeg);
      onSet?.(`servo-${port}`, angleDeg);
    },
  };
}

/**
 * Shortest PWM period that turns a servo on a pin, in µs. Chosen: the buzzer is on P0, too, and its notes down to 100 Hz
 * must not turn a claw.
 */
const LEAST_SERVO_PERIOD_US = 10_000;

/** Listens to servos on the pins of these names; tones are left out. Whole degrees, because the steps of `write_analog` are 2°. */
export function listenToServos(
  { board, clock }: RobotContext,
  pins: readonly string[],
  set: (pin: string, angleDeg: number) => void,
): readonly Stop[] {
  return pins.map((pin) => {
    const wire = board.wire(pin);
    const hear = (angleDeg: number): void => {
      if (wire.pwm === null || wire.pwm.periodUs >= LEAST_SERVO_PERIOD_US) set(pin, Math.round(angleDeg));
    };
    return attachPwmServo(wire, hear, { clock });
  });
}

/** Makes a function that reports a colour light that the program sets, by its place. */
export const tellColors =
  ({ onSet }: Pick<RobotContext, 'onSet'>) =>
  (led: number, color: Rgb): void =>
    onSet?.(`color-${led}`, color.join());
