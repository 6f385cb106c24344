import type { LeagueRules } from '#scene/league/league';

/** The points of a run by the rules of a league, as plain data. */
export interface Points {
  readonly rules: LeagueRules;
  /** All points so far. */
  readonly score: number;
  /** All that can be earned, along the way. */
  readonly lines: readonly PointLine[];
  /** The factor for victims by which all points are multiplied; left out: 1. */
  readonly factor?: number;
  /** Number of lacks of progress. */
  readonly lacks: number;
  /** The section that the robot is in, from 1 on: each ends at a checkpoint or on the last tile. */
  readonly section: number;
  /** Its try at this section, from 1 on. */
  readonly attempt: number;
  /** Number of the tile that it has reached, from 0 on. */
  readonly tile: number;
}

/** The kinds of what brings points. */
export const pointKinds = ['start', 'gap', 'crossing', 'obstacle', 'tiles', 'exit', 'living', 'dead', 'moved', 'rescued'] as const; // prettier-ignore

/** Something on the way that brings points. */
export interface PointLine {
  readonly what: (typeof pointKinds)[number];
  /** Number of the tile that it belongs to; victims belong to the last one before the zone. */
  readonly tile: number;
  /** Number of gaps, tiles, … */
  readonly count: number;
  /** The points that it has brought; still open: those that it brings now. */
  readonly points: number;
  /** `missed`: its section was passed over. */
  readonly state: 'earned' | 'open' | 'missed';
}
