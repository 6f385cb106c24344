/** Where the parts of the micro:bit are in our drawing of 260 × 214 units. */

/** The two buttons, by the middle of their caps. */
export const BUTTONS = [
  { key: 'a', letter: 'A', x: 36 },
  { key: 'b', letter: 'B', x: 224 },
] as const;

/** The large pads of the edge connector. */
export const PADS = [
  { name: '0', x: 26 },
  { name: '1', x: 78 },
  { name: '2', x: 130 },
  { name: '3V', x: 182 },
  { name: 'GND', x: 234 },
] as const;

/** Narrow contacts of the edge connector between the large pads. */
export const CONTACTS = [42.5, 94.5, 146.5, 198.5].flatMap((start) => [0, 1, 2, 3, 4, 5].map((i) => start + i * 2.75));

/** The middle of each light of the display, row by row. */
export const LIGHTS = Array.from({ length: 25 }, (_, i) => ({ x: 88 + (i % 5) * 21, y: 66 + Math.floor(i / 5) * 20 }));
