/** Motors and wheel pulses of the Maqueen Plus V1. */
import type { Clock } from '#core/clock';
import type { Stop } from '#core/stop';
import type { Chassis } from '#world/chassis';
import type { Side } from './controller';
import { createSpeedControl } from './speed-control';

/** informatiquecsud/mbrobot `maqueen-plus/microbit_V2/src/motors.py` divides by 79; bosluc/DFRobot-MaqueenLite-Python by 80. */
export const PULSES_PER_TURN = 80;

const RAD_PER_PULSE = (2 * Math.PI) / PULSES_PER_TURN;
const SIDES = [0, 1] as const;
const US_PER_S = 1_000_000;

/** Both motors with their pulse counters. */
export interface Drive {
  /** Duties −1 … 1 as the program set them. */
  motors(left: number, right: number): void;
  /** Switches the speed control on or off, see speed-control.ts. */
  speedControl(isOn: boolean): void;
  /** Pulses of a wheel, forward and backward alike, since its counter was reset; 16 bits, then from 0 again. */
  pulses(side: Side): number;
  clearPulses(side: Side): void;
  /** The present duty of the motors, −1 … 1. */
  duty(): { readonly left: number; readonly right: number };
  /** Call it after each step of the world. */
  step(): void;
  readonly stop: Stop;
}

/** The chassis they are mounted on, of any scale. */
export interface DriveContext {
  readonly chassis: Chassis;
  readonly clock: Clock;
  readonly scale: number;
}

/** Puts the motors on a chassis. */
export function createDrive({ chassis, clock, scale }: DriveContext): Drive {
  const controls = [createSpeedControl(), createSpeedControl()] as const;
  const wanted: [number, number] = [0, 0];
  const turnRad: [number, number] = [0, 0];
  const lastRad: [number, number] = [chassis.wheelTurnRad(0), chassis.wheelTurnRad(1)];
  let isControlled = false;
  let controlledUs = 0;

  /** Controls by what was wanted up to now. */
  const control = (): void => {
    const passedS = (clock.nowUs - controlledUs) / US_PER_S;
    controlledUs = clock.nowUs;
    for (const side of SIDES) {
      const speed = chassis.wheelSpeedMmPerS(side) / scale;
      chassis.setDuty(side, controls[side].next(wanted[side], speed, passedS));
    }
  };
  const setBoth = (left: number, right: number): void => {
    if (isControlled) control();
    wanted[0] = left;
    wanted[1] = right;
    if (isControlled) control();
    else for (const side of SIDES) chassis.setDuty(side, wanted[side]);
  };
  return {
    motors: setBoth,
    speedControl: (isOn) => {
      if (isOn === isControlled) return;
      isControlled = isOn;
      controlledUs = clock.nowUs;
      for (const one of controls) one.reset();
      setBoth(wanted[0], wanted[1]);
    },
    pulses: (side) => Math.floor(turnRad[side] / RAD_PER_PULSE) & 0xffff,
    clearPulses: (side) => {
      turnRad[side] = 0;
    },
    duty: () => ({ left: chassis.duty(0), right: chassis.duty(1) }),
    step: () => {
      for (const side of SIDES) {
        const now = chassis.wheelTurnRad(side);
        turnRad[side] += Math.abs(now - lastRad[side]);
        lastRad[side] = now;
      }
      if (isControlled) control();
    },
    stop: () => {
      isControlled = false;
      setBoth(0, 0);
    },
  };
}
