/** Shared mounting of all robots: two motors and the servos of their ports. */
import { attachServoPorts, type ServoPorts } from '#attachments/servo-ports';
import type { Chassis } from '#world/chassis';
import type { RobotContext, RobotState, RobotType } from './robot';

/** Both motors of a robot. */
export interface Motors {
  /** Duties −1 … 1. */
  readonly drive: (left: number, right: number) => void;
  /** As they were last set. */
  readonly duty: () => RobotState['duty'];
  readonly stop: () => void;
}

/** Puts the motors on a chassis, which keeps their settings. */
export function mountMotors(chassis: Chassis): Motors {
  const drive = (left: number, right: number): void => {
    chassis.setDuty(0, left);
    chassis.setDuty(1, right);
  };
  return {
    drive,
    duty: () => ({ left: chassis.duty(0), right: chassis.duty(1) }),
    stop: () => drive(0, 0),
  };
}

/** Puts servos on a robot's ports, and on the servos what the robot's options say. */
export function mountServos(
  { chassis, options, scale }: RobotContext,
  { mountMm }: RobotType,
  ports: readonly string[],
): ServoPorts {
  return attachServoPorts(ports, options, mountMm && { chassis, mountMm, scale });
}
