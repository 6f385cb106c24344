/**
 * Paint on the floor and on things. Its colour is for eyes and colour sensors, how much infrared it returns for line
 * sensors: they are two things, because what is dark to the eye may be bright in infrared (`reflectance.ts`).
 */

/** The colours that a stroke has had from the first version on, in the order of links. Each is a CSS colour name as well. */
export const firstColors = ['black', 'gray', 'white', 'red', 'yellow', 'green', 'blue'] as const;

/** The colours that paint may have. */
export const paintColors = ['black', 'gray', 'white', 'red', 'yellow', 'green', 'blue', 'orange', 'purple', 'brown', 'silver'] as const; // prettier-ignore
export type PaintColor = (typeof paintColors)[number];

/** Something that may be painted. */
export interface Painted {
  /** Left out: no paint. Sensors see bare floor, or of what stands on it a body without a colour. */
  readonly color?: PaintColor;
  /** How much infrared its paint returns: 0 nothing, 1 as much as bare light floor. Left out: as usual for its colour. */
  readonly infrared?: number;
}

/** True if files before version 8 can say a colour. */
export const isFirstColor = (color: PaintColor): color is (typeof firstColors)[number] =>
  firstColors.some((one) => one === color);

/** The property that gives a thing a colour; `null`: left out. */
export const colorProperty = (color: PaintColor | null): Pick<Painted, 'color'> => (color === null ? {} : { color });
