/**
 * Turns the two numbers of a motor driver, a direction and a speed byte, into a signed duty. Source of the coding:
 * DFRobot pxt-maqueen `maqueen.ts` (direction 0 forward, 1 backward; PWM 0 … 255, 0 stops).
 */

import type { Touched } from './i2c-registers';

/** Speed byte of a motor that is driven all the time. */
export const FULL_SPEED = 255;

/**
 * The share of time a motor is driven, −1 (full backward) … 1 (full forward); 0 when the speed byte is 0.
 *
 * @param direction 0 forward; any other byte backward (only 0 and 1 are documented; the rest is chosen)
 * @param speed PWM byte, 0 … 255
 */
export function signedDuty(direction: number, speed: number): number {
  if (speed === 0) return 0; // also keeps −0 out of snapshots
  return (direction === 0 ? speed : -speed) / FULL_SPEED;
}

/** A side of a robot with two of something. */
export type Side = 'left' | 'right';

/**
 * The motors that a transfer has set, where each has two registers side by side, those of the left one first.
 *
 * @param touched offsets of the registers that it has written
 */
export function motorsTouched({ first, last }: Touched): readonly Side[] {
  if (last < 2) return ['left'];
  return first < 2 ? BOTH_SIDES : ['right'];
}

export const BOTH_SIDES: readonly Side[] = ['left', 'right'];
