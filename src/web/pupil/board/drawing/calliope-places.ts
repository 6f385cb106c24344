/**
 * The places of the Calliope mini 3's parts in our drawing, in units in which the rings at the star's tips are 100 from
 * its middle at 130, 122. The arrangement follows the device (calliope-edu/micropython-simulator,
 * src/CM_V3_Platine_plain.svg); places and sizes are ours, so that fingers find them.
 */

/** The outline: six tips of a soft star. */
export const STAR =
  'M233.2 100.4Q254 122 233.2 143.6L230.5 146.4Q209.7 168 201.4 196.8L200.3 200.6Q192 229.4 162.9 222.2L159.1 221.2Q130 214 100.9 221.2L97.1 222.2Q68 229.4 59.7 200.6L58.6 196.8Q50.3 168 29.5 146.4L26.8 143.6Q6 122 26.8 100.4L29.5 97.6Q50.3 76 58.6 47.2L59.7 43.4Q68 14.6 97.1 21.8L100.9 22.8Q130 30 159.1 22.8L162.9 21.8Q192 14.6 200.3 43.4L201.4 47.2Q209.7 76 230.5 97.6Z';

/** Side of the square around each key that takes the finger: 44 px on a board 180 px wide. */
export const HIT = 62;

/** The two buttons, by the middle of their caps, and the upper left corner of the square that takes the finger. */
export const BUTTONS = [
  { key: 'a', letter: 'A', x: 69, y: 122, hitX: 48, hitY: 91, color: '#1f6fd1', edge: '#0f3f7c' },
  { key: 'b', letter: 'B', x: 191, y: 122, hitX: 150, hitY: 91, color: '#d23c35', edge: '#7c1b17' },
] as const;

/** The pad in place of the touch logo, and the upper left corner of the square that takes the finger. */
export const LOGO = { key: 'pinLogo', x: 130, y: 58, hitX: 99, hitY: 15 } as const;

/** The rings at the tips that only bring power. */
export const POWER_RINGS = [
  { name: '−', x: 79.8, y: 35, textX: 93, textY: 58 },
  { name: '+', x: 180.2, y: 35, textX: 167, textY: 58 },
] as const;

/**
 * The rings that feel a finger, the place of their name, and the upper left corner of the square that takes the finger.
 */
export const PINS = [
  { key: 'pin0', name: 'P0', x: 29.6, y: 122, textX: 46, textY: 152, hitX: -14, hitY: 91 },
  { key: 'pin1', name: 'P1', x: 79.8, y: 209, textX: 105, textY: 204, hitX: 49, hitY: 176 },
  { key: 'pin2', name: 'P2', x: 180.2, y: 209, textX: 155, textY: 204, hitX: 149, hitY: 176 },
  { key: 'pin3', name: 'P3', x: 230.4, y: 122, textX: 214, textY: 152, hitX: 212, hitY: 91 },
] as const;

/** The Grove sockets, along the upper edges of the star. */
export const GROVES = [
  { name: 'A0', x: 67, y: 77, turn: -60, textX: 85.5, textY: 89 },
  { name: 'A1', x: 193, y: 77, turn: 60, textX: 174.5, textY: 89 },
] as const;

/** The motor outputs: the terminal on the board and the wheel beside it, which a wire joins. */
export const MOTORS = [
  { name: 'M0', x: 76, wheelX: 24, wire: 'M66 178C50 176 42 182 30 192', textX: 97, side: 'start' },
  { name: 'M1', x: 184, wheelX: 236, wire: 'M194 178C210 176 218 182 230 192', textX: 163, side: 'end' },
] as const;

/** Height of the terminals and of the wheels. */
export const TERMINAL_Y = 178;
export const WHEEL_Y = 194;

/** The three coloured lights below the display. */
export const RGB_LIGHTS = [
  { x: 110, y: 160 },
  { x: 130, y: 160 },
  { x: 150, y: 160 },
] as const;
