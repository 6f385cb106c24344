import type { PaintColor, Painted } from './paint';
import type { SceneObject } from '../scene';

/**
 * How much infrared painted lines return to a line sensor: 0 nothing (black), 1 as much as bare light floor.
 *
 * Line sensors of school robots shine infrared (about 940 nm). Black tape and ink hold soot and swallow it; the dyes of
 * red and yellow ink let it pass to the paper, so that such lines are nearly invisible to the sensor; blue and green
 * ones are seen, less reliably than black. Gray is a light floor to it: what a printer calls gray is mostly paper. Chosen
 * to express just that, each well on one side of a sensor's thresholds: dyes differ from pen to pen. The first seven are
 * those of all runs there were.
 */
export const strokeInfrared: Readonly<Record<PaintColor, number>> = {
  black: 0,
  blue: 0.15,
  green: 0.3,
  gray: 0.7,
  red: 0.8,
  brown: 0.84,
  purple: 0.85,
  orange: 0.92,
  yellow: 0.95,
  white: 1,
  silver: 1.4,
};

/**
 * The same of painted fields, walls and blocks, as they come out of a printer: cyan and magenta do not stop infrared,
 * only soot does (application notes of makers of light barriers). Silver, glossy, returns more than white paper.
 */
export const paintInfrared: Readonly<Record<PaintColor, number>> = {
  ...strokeInfrared,
  black: 0.05,
  blue: 0.8,
  green: 0.8,
  gray: 0.5,
  red: 0.9,
  yellow: 0.97,
};

/** How much infrared the paint of an object returns; `null`: it is not painted. */
export function infraredOf(object: Painted & Pick<SceneObject, 'type'>): number | null {
  const { type, color, infrared } = object;
  if (color === undefined) return null;
  return infrared ?? (type === 'stroke' ? strokeInfrared : paintInfrared)[color];
}

/** The share of red, green and blue light that paint returns. */
export type Rgb = readonly [red: number, green: number, blue: number];

/**
 * The shares of light that each colour returns to a colour sensor: prints and tapes of school material (chosen after
 * public measurements: see docs/hardware/colour-sensor.md).
 */
export const paintRgb: Readonly<Record<PaintColor, Rgb>> = {
  white: [0.85, 0.85, 0.82],
  gray: [0.4, 0.4, 0.39],
  black: [0.05, 0.05, 0.05],
  red: [0.62, 0.08, 0.08],
  orange: [0.75, 0.3, 0.08],
  yellow: [0.8, 0.68, 0.1],
  green: [0.14, 0.5, 0.14],
  blue: [0.05, 0.2, 0.55],
  brown: [0.25, 0.14, 0.08],
  purple: [0.35, 0.2, 0.45],
  silver: [1.2, 1.2, 1.15],
};

/** Bare floor: as white paper. */
export const floorRgb: Rgb = paintRgb.white;
