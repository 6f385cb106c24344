/**
 * The wheels of the Maqueen Plus V3 as its controller drives them: by duties that the program sets, or by speeds that it
 * keeps itself, with the encoders of its motors. How it keeps them is not published. Chosen: the duty that the motor law
 * needs for the speed, and more or less of it in proportion to what is missing.
 */
import type { Chassis, WheelSide } from '#world/chassis';
import type { DriveLaw } from '#world/drive-law';

/** Duty per mm/s of missing speed: chosen, a step of 4 ms makes good a sixth of it. */
const GAIN = 0.03;

const SIDES = [0, 1] as const;

/** Both wheels; lengths and speeds of a robot of real size. */
export interface Wheels {
  /** Lets them turn with these speeds of their rims in mm/s, forward positive, until the next call; 0 brakes. */
  turn(left: number, right: number): void;
  /** Leaves the motors alone, for duties that others set. */
  letGo(): void;
  /** How far a rim has turned since the start, in mm, forward positive. */
  travelMm(side: WheelSide): number;
  /** Present speed of a rim in mm/s, forward positive. */
  speedMmPerS(side: WheelSide): number;
  /** How far the wheels have driven since the last `clearDriven`, in mm, forward and backward alike; the mean of both. */
  drivenMm(): number;
  clearDriven(): void;
  /** Call it after each step of the world. */
  step(): void;
}

/** The robot that they are on, of any scale. */
export interface WheelsContext {
  readonly chassis: Chassis;
  readonly scale: number;
  readonly drive: DriveLaw;
  /** Radius on the real robot. */
  readonly radiusMm: number;
}

/** Mounts the encoders; the motors are left alone. */
export function createWheels({ chassis, scale, drive, radiusMm }: WheelsContext): Wheels {
  let wanted: readonly [number, number] | null = null;
  let driven = 0;
  const before: [number, number] = [0, 0];
  const travelMm = (side: WheelSide): number => chassis.wheelTurnRad(side) * radiusMm;
  const speedMmPerS = (side: WheelSide): number => chassis.wheelSpeedMmPerS(side) / scale;
  const control = (): void => {
    if (wanted === null) return;
    for (const side of SIDES) {
      const speed = wanted[side];
      const duty = speed === 0 ? 0 : dutyFor(drive, speed) + GAIN * (speed - speedMmPerS(side));
      chassis.setDuty(side, Math.min(Math.max(duty, -1), 1));
    }
  };
  for (const side of SIDES) before[side] = travelMm(side);
  return {
    turn: (left, right) => {
      wanted = [left, right];
      control();
    },
    letGo: () => {
      wanted = null;
    },
    travelMm,
    speedMmPerS,
    drivenMm: () => driven,
    clearDriven: () => {
      driven = 0;
    },
    step: () => {
      for (const side of SIDES) {
        const now = travelMm(side);
        driven += Math.abs(now - before[side]) / 2;
        before[side] = now;
      }
      control();
    },
  };
}

/** The duty with which a wheel keeps a speed straight ahead: the motor law of #world/drive-law, solved for it. */
function dutyFor({ v0MmPerS, coulomb, breakaway, viscous }: DriveLaw, mmPerS: number): number {
  const share = Math.abs(mmPerS) / v0MmPerS;
  if (share >= 1) return Math.sign(mmPerS);
  const sticking = breakaway === undefined ? 0 : breakaway.share * Math.max(1 - share / breakaway.until, 0);
  return (Math.sign(mmPerS) * (coulomb + sticking + viscous * share)) / (1 - share);
}
