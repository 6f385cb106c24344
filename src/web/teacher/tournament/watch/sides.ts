import { deviceColor } from '#picture/device-colors';

/** A program in a match: its number and its colour, which mark its robot. */
export interface MatchSide {
  readonly number: number;
  readonly color: string;
}

/** The two sides, the first one first: dark enough for the floor and for white numbers in every theme. */
export const SIDES: readonly [MatchSide, MatchSide] = [
  { number: 1, color: deviceColor(0) },
  { number: 2, color: deviceColor(1) },
];
