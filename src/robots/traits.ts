import type { ChassisType } from '#world/chassis';
import type { DriveLaw } from '#world/drive-law';

/**
 * The differences of one robot from others of its type: found by measuring it (`#my-robot`). Without them it is as its
 * type says.
 */
export interface Traits {
  readonly motors: MotorTraits;
  /** The distance that the ultrasonic sensor gives: `offsetMm + scale · true distance`. */
  readonly ultrasonic: { readonly offsetMm: number; readonly scale: number };
  /** The readings of line sensors, in the robot's own unit, by the sensor's name; missing ones are the type's. */
  readonly line: Readonly<Record<string, LineReadings>>;
}

/** The readings of a line sensor on black and on bare floor; linear in between. */
export interface LineReadings {
  readonly black: number;
  readonly floor: number;
}

/** How motors and battery differ. */
export interface MotorTraits {
  /** Share by which the left motor is stronger, and the right one weaker, than the type's; negative: the other way round. */
  readonly difference: number;
  /** Voltage of the battery while nothing turns, compared with a full one. */
  readonly charge: number;
  /** Share of the full voltage that the battery loses while both motors run at full duty. */
  readonly sag: number;
  /** Dry friction of motors and gears besides the type's, as a share of the stall force (`DriveLaw.coulomb`). */
  readonly friction: number;
}

/** The traits of a robot exactly as designed. */
export const idealTraits: Traits = {
  motors: { difference: 0, charge: 1, sag: 0, friction: 0 },
  ultrasonic: { offsetMm: 0, scale: 1 },
  line: {},
};

/** Bounds of each number. Chosen: beyond them a robot is broken, or was measured wrongly. */
export const traitLimits = {
  difference: { min: -0.3, max: 0.3 },
  charge: { min: 0.5, max: 1.5 },
  sag: { min: 0, max: 0.4 },
  friction: { min: -0.02, max: 0.06 },
  offsetMm: { min: -100, max: 100 },
  scale: { min: 0.5, max: 1.5 },
  reading: { min: 0, max: 65535 },
} as const;

/** A body with the motors of this robot. */
export function bodyWith(type: ChassisType, { difference, friction }: MotorTraits): ChassisType {
  const [left, right] = type.strength ?? [1, 1];
  const { drive } = type;
  return {
    ...type,
    strength: [left * (1 + difference), right * (1 - difference)],
    drive: { ...drive, coulomb: Math.max(drive.coulomb + friction, 0) },
  };
}

/** The battery's voltage compared with a full one while the motors run at these duties, −1 … 1; never below 0. */
export function supplyOf({ charge, sag }: MotorTraits, left: number, right: number): number {
  return Math.max(charge - (sag * (Math.abs(left) + Math.abs(right))) / 2, 0);
}

/** The least power byte, 1 … 255, at which both wheels begin to turn. */
export function leastPower({ coulomb, breakaway }: DriveLaw, { difference, charge, friction }: MotorTraits): number {
  const needed = Math.max(coulomb + friction, 0) + (breakaway?.share ?? 0);
  const weaker = charge * (1 - Math.abs(difference));
  return Math.min(Math.ceil((255 * needed) / weaker), 255);
}
