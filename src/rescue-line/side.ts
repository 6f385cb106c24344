/** A side of a tile, as the quarter turns clockwise from its top. */
export type Side = 0 | 1 | 2 | 3;

export const [TOP, RIGHT, BOTTOM, LEFT] = [0, 1, 2, 3] as const;

/** The sides in the words of a map. */
export const sideNames = ['top', 'right', 'bottom', 'left'] as const;

/** A side after so many quarter turns clockwise; less than 0: counter-clockwise. */
export const turned = (side: Side, quarters: number): Side => ((side + quarters + 8) % 4) as Side;

/** The side on the other side. */
export const opposite = (side: Side): Side => turned(side, 2);

/** The step of columns and rows (down) over a side. */
export const stepOver = (side: Side): { readonly x: number; readonly y: number } => STEPS[side];

const STEPS = [
  { x: 0, y: -1 },
  { x: 1, y: 0 },
  { x: 0, y: 1 },
  { x: -1, y: 0 },
] as const;

/** The heading in degrees of a robot that leaves over a side. */
export const headingOver = (side: Side): number => [90, 0, 270, 180][side] ?? 0;
