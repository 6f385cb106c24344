/** The names that the library `colour.py` gives to what it reads, with its limits: the page shows the same. */

/** The names of colours, as the library has them. */
export type ColourName =
  'red' | 'orange' | 'yellow' | 'green' | 'blue' | 'purple' | 'brown' | 'white' | 'gray' | 'black';

/** Readings clear, red, green, blue at gain 4 and 24 ms. */
export type RawColour = readonly [clear: number, red: number, green: number, blue: number];

/** White paper at these settings (docs/hardware/colour-sensor.md). */
export const WHITE_READING: RawColour = [7000, 2018, 2623, 2359];

/** Hue in whole degrees and name of a reading, white-balanced. Limits: halfway between the papers of the fit. */
export function colourNamed(raw: RawColour): { readonly hue: number; readonly name: ColourName } {
  const [red = 0, green = 0, blue = 0] = [1, 2, 3].map((i) => (raw[i] ?? 0) / (WHITE_READING[i] ?? 1));
  const level = raw[0] / WHITE_READING[0];
  const [most, least] = [Math.max(red, green, blue), Math.min(red, green, blue)];
  const range = most - least;
  const hue = range === 0 ? 0 : hueOf([red, green, blue], most, range);
  const saturation = most === 0 ? 0 : range / most;
  return { hue, name: nameOf(hue, saturation, level) };
}

function hueOf([red, green, blue]: readonly [number, number, number], most: number, range: number): number {
  const sixths =
    most === red ? (green - blue) / range : most === green ? 2 + (blue - red) / range : 4 + (red - green) / range;
  return (Math.round(60 * sixths) + 360) % 360;
}

function nameOf(hue: number, saturation: number, level: number): ColourName {
  if (saturation < 0.2) return level > 0.75 ? 'white' : level > 0.24 ? 'gray' : 'black';
  if (hue < 45 && saturation < 0.55 && level < 0.32) return 'brown';
  if (hue < 10 || hue >= 330) return 'red';
  if (hue < 35) return 'orange';
  if (hue < 85) return 'yellow';
  if (hue < 170) return 'green';
  return hue < 250 ? 'blue' : 'purple';
}
