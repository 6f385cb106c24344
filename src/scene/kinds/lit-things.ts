import type { Common, Point, Shaped, Standing } from './base';
import type { Switching } from './switching';

/** A lamp that hangs over the arena: a point that shines the same in all directions, which no body feels. */
export interface Lamp extends Common {
  readonly type: 'lamp';
  readonly at: Point;
  /** Above the floor in mm. */
  readonly height: number;
  /** In cd, which are lx at a metre. */
  readonly brightness: number;
  /** For the eye; left out: warm white. */
  readonly color?: LampColor;
  /** How it is switched on; left out: it is always on. */
  readonly on?: Switching;
}

/** The colours of lamps beside warm white. */
export const lampColors = ['red', 'yellow', 'green', 'blue'] as const;
export type LampColor = (typeof lampColors)[number];

/** A wall that opens: solid while it is closed, nothing while it is open. It closes on nothing that stands in it. */
export interface Barrier extends Common, Standing {
  readonly type: 'barrier';
  readonly from: Point;
  readonly to: Point;
  /** Full thickness in mm. */
  readonly thickness: number;
  /** How it is opened. */
  readonly opens: Switching;
}

/** A roof over a part of the floor: dark inside, and nothing else. */
export interface Tunnel extends Common, Shaped {
  readonly type: 'tunnel';
}
