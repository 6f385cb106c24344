/** The places of the micro:bit's parts in our drawing of 260 × 214 units. */

/** Side of the square around each key that takes the finger: 44 px on a board 180 px wide. */
export const HIT = 64;

/** The two buttons, by the middle of their caps, and the upper left corner of the square that takes the finger. */
export const BUTTONS = [
  { key: 'a', letter: 'A', x: 36, y: 107, hitX: 4, hitY: 88 },
  { key: 'b', letter: 'B', x: 224, y: 107, hitX: 192, hitY: 88 },
] as const;

/** The touch logo, and the upper left corner of the square that takes the finger. */
export const LOGO = { key: 'pinLogo', x: 130, y: 31, hitX: 98, hitY: -6 } as const;

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

/**
 * The pads that feel a finger, and the upper left corner of the square that takes it: that of pin 0 begins beyond the
 * edge, and those of 1 and 2 are shifted to the right, so that none covers another.
 */
export const PINS = [
  { key: 'pin0', x: 26, y: 185, hitX: -14, hitY: 158 },
  { key: 'pin1', x: 78, y: 185, hitX: 50, hitY: 158 },
  { key: 'pin2', x: 130, y: 185, hitX: 114, hitY: 158 },
] as const;
