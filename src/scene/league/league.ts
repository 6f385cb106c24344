/** The rules by which a line of RoboCup Junior is scored: the league and its year. */
export const leagueRules = ['line-2025', 'line-entry-2026'] as const;
export type LeagueRules = (typeof leagueRules)[number];

/** A place or an extent in whole mm, as in the rest of the course. */
type Point = readonly [x: number, y: number];

/** A line of tiles that is scored by the rules of a league. */
export interface League {
  readonly rules: LeagueRules;
  /** In the order in which the robot passes them; a tile that it passes twice is there twice. */
  readonly tiles: readonly LeagueTile[];
  /** The evacuation zone; left out: none. */
  readonly zone?: RescueZone;
}

/** A tile on the way. */
export interface LeagueTile {
  /** Its middle. */
  readonly at: Point;
  /** The direction in which the robot leaves it, in degrees: 0, 90, 180 or 270. Of the last: in which it comes. */
  readonly heading: number;
  /** Left out, each of these: 0. */
  readonly gaps?: number;
  readonly crossings?: number;
  readonly obstacles?: number;
  /** A robot that has lost the line begins here anew. */
  readonly checkpoint?: true;
  /** The robot comes here out of the evacuation zone. */
  readonly afterZone?: true;
}

/** A rectangle along the axes; victims are the round blocks in it, black ones dead. */
export interface RescueZone {
  /** Its middle. */
  readonly at: Point;
  readonly size: Point;
}

/** The side of a tile in mm. */
export const TILE_MM = 300;

/** Limits of a league. */
export const leagueLimits = {
  tiles: { min: 1, max: 1_000 },
  /** Gaps, crossings or obstacles of a tile. */
  perTile: { min: 0, max: 20 },
  zoneMm: { min: TILE_MM, max: 5_000 },
} as const;

/** The headings of tiles. */
export const tileHeadings = [0, 90, 180, 270] as const;
