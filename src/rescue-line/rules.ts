import type { LeagueRules } from '#scene/league/league';

/** The points of a league in a year. Rules change every year: each is one entry here, with the year in its name. */
export interface PointRules {
  readonly year: number;
  /** Its name, as the league writes it. */
  readonly name: string;
  /** Time limit of a run. */
  readonly seconds: number;
  /** For being placed at the start. */
  readonly start: number;
  readonly gap: number;
  /** A crossing or a dead end; 0: there are none. */
  readonly crossing: number;
  readonly obstacle: number;
  /** For each tile since the last checkpoint, by the number of tries that failed in between; then nothing. */
  readonly tile: readonly number[];
  /** After so many failed tries the robot goes on from the next checkpoint. */
  readonly failedTries: number;
  /** For stopping on the last tile: so much, less `exitLack` for each lack of progress, never below 0. */
  readonly exit: number;
  readonly exitLack: number;
  /** How long the robot has to stand there. */
  readonly standSeconds: number;
  readonly victims: VictimRules;
}

/** Points for victims: a factor for all points, or points for each. */
export type VictimRules =
  | { readonly kind: 'factor'; readonly factor: number; readonly lack: number; readonly least: number }
  | { readonly kind: 'points'; readonly out: number; readonly rescue: number };

/**
 * The rules by league and year.
 *
 * - `line-2025`: Rescue Line rules 2025 of RoboCup Junior, points as in its scoring software of 2025.
 * - `line-entry-2026`: Rescue Line Entry rules 2026; where the scoring software differs, the text counts.
 */
export const pointRules: Readonly<Record<LeagueRules, PointRules>> = {
  'line-2025': {
    ...{ year: 2025, name: 'Rescue Line', seconds: 480 },
    ...{ start: 5, gap: 10, crossing: 10, obstacle: 20, tile: [5, 3, 1], failedTries: 3 },
    ...{ exit: 60, exitLack: 5, standSeconds: 5 },
    victims: { kind: 'factor', factor: 1.4, lack: 0.05, least: 1.25 },
  },
  'line-entry-2026': {
    ...{ year: 2026, name: 'Rescue Line Entry', seconds: 360 },
    ...{ start: 0, gap: 10, crossing: 0, obstacle: 10, tile: [5, 3, 1], failedTries: 3 },
    ...{ exit: 0, exitLack: 0, standSeconds: 5 },
    victims: { kind: 'points', out: 10, rescue: 30 },
  },
};
