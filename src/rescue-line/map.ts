import type { Side } from './side';

/** A map of the editor of RoboCup Junior, as far as a course can be made of it. */
export interface LineMap {
  readonly name: string;
  /** Columns and rows. */
  readonly columns: number;
  readonly rows: number;
  /** Seconds of a run; `null`: not said. */
  readonly seconds: number | null;
  /** The first tile. */
  readonly start: Place;
  /** The first tile after the evacuation zone; `null`: none. */
  readonly afterZone: Place | null;
  readonly victims: { readonly living: number; readonly dead: number };
  /** Those on the ground floor, by `keyOf` their place. */
  readonly tiles: ReadonlyMap<string, MapTile>;
  /** Number of tiles on other floors: they are left out. */
  readonly upstairs: number;
}

/** The place of a tile: x to the right, y down. */
export interface Place {
  readonly x: number;
  readonly y: number;
}

export const keyOf = ({ x, y }: Place): string => `${String(x)},${String(y)}`;

/** A tile of a map. */
export interface MapTile {
  readonly at: Place;
  /** Quarter turns clockwise. */
  readonly turns: number;
  /** Name of its picture without the ending, such as `tile-12`; `exit` and `zone` also by their ids. */
  readonly image: string;
  /** For each side of the tile before it is turned: the side at which a robot leaves that has entered there. */
  readonly paths: ReadonlyMap<Side, Side>;
  readonly gaps: number;
  readonly crossings: number;
  readonly obstacles: number;
  readonly isCheckpoint: boolean;
  /** Things on it that do not exist here. */
  readonly unlike: readonly Unlike[];
}

/** The things of a field that have a height, which no course has. */
export const unlikes = ['seesaw', 'bumps', 'ramp', 'floors'] as const;
export type Unlike = (typeof unlikes)[number];

/** The picture of the last tile. */
export const EXIT = 'exit';

/** The picture of a tile of the evacuation zone. */
export const ZONE = 'zone';

/** Limits of maps: a course is at most 10 m long. */
export const mapLimits = {
  /** Columns and rows. */
  side: 33,
  /** All tiles on all floors. */
  tiles: 1_500,
  floors: 20,
  perTile: 20,
  victims: 10,
  seconds: 3_600,
} as const;
