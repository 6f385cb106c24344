import type { StrokeColor } from './scene';

/**
 * The reflectance of each colour for an infrared line sensor: 0 nothing (black), 1 as much as from bare light floor.
 *
 * Line sensors of school robots shine infrared (about 940 nm). Black tape and ink hold soot and swallow it; the dyes of
 * red and yellow ink let it pass to the paper, so that such lines are nearly invisible to the sensor; blue and green
 * ones are seen, less reliably than black. Gray is a light floor to it: what a printer calls gray is mostly paper. Chosen
 * to express just that, each well on one side of a sensor's thresholds: dyes differ from pen to pen.
 */
export const reflectanceOf: Readonly<Record<StrokeColor, number>> = {
  black: 0,
  blue: 0.15,
  green: 0.3,
  gray: 0.7,
  red: 0.8,
  yellow: 0.95,
  white: 1,
};
