/** Motors and wheel pulses of the Maqueen Plus V1. */
import type { Stop } from '#core/stop';
import type { Chassis } from '#world/chassis';
import type { Side } from './controller';
import { createSpeedControl } from './speed-control';

/** informatiquecsud/mbrobot `maqueen-plus/microbit_V2/src/motors.py` divides by 79; bosluc/DFRobot-MaqueenLite-Python by 80. */
export const PULSES_PER_TURN = 80;

const RAD_PER_PULSE = (2 * Math.PI) / PULSES_PER_TURN;
const SIDES = [0, 1] as const;

/** Both motors with their pulse counters. */
export interface Drive {
  /** Duties −1 … 1 as the program set them. */
  motors(left: number, right: number): void;
  /** Whether the wheels' speed is kept constant, see speed-control.ts. */
  speedControl(isOn: boolean): void;
  /** Turns of a wheel, forward or backward, since its counter was reset; 16 bits, then from 0 again. */
  pulses(side: Side): number;
  clearPulses(side: Side): void;
  /** The present duty of the motors, −1 … 1. */
  duty(): { readonly left: number; readonly right: number };
  /** Call it after each step of the world. */
  step(passedS: number): void;
  readonly stop: Stop;
}

/** Puts the motors on a chassis of any scale. */
export function createDrive(chassis: Chassis, scale: number): Drive {
  const controls = [createSpeedControl(), createSpeedControl()] as const;
  const wanted: [number, number] = [0, 0];
  const turnRad: [number, number] = [0, 0];
  const lastRad: [number, number] = [chassis.wheelTurnRad(0), chassis.wheelTurnRad(1)];
  let isControlled = false;

  const setBoth = (left: number, right: number): void => {
    wanted[0] = left;
    wanted[1] = right;
    for (const side of SIDES) if (!isControlled || wanted[side] === 0) chassis.setDuty(side, wanted[side]);
  };
  return {
    motors: setBoth,
    speedControl: (isOn) => {
      if (isOn === isControlled) return;
      isControlled = isOn;
      for (const control of controls) control.reset();
      setBoth(wanted[0], wanted[1]);
    },
    pulses: (side) => Math.floor(turnRad[side] / RAD_PER_PULSE) & 0xffff,
    clearPulses: (side) => {
      turnRad[side] = 0;
    },
    duty: () => ({ left: chassis.duty(0), right: chassis.duty(1) }),
    step: (passedS) => {
      for (const side of SIDES) {
        const now = chassis.wheelTurnRad(side);
        turnRad[side] += Math.abs(now - lastRad[side]);
        lastRad[side] = now;
        if (isControlled)
          chassis.setDuty(side, controls[side].next(wanted[side], chassis.wheelSpeedMmPerS(side) / scale, passedS));
      }
    },
    stop: () => {
      isControlled = false;
      setBoth(0, 0);
    },
  };
}
