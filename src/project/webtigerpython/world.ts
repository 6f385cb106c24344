/**
 * WebTigerPython's worlds (`playground=` in its links, and its course files): JSON with the keys below. Its frame has y
 * downwards from the upper left corner; a direction is a number k of eighths of a turn, clockwise. Nothing but two public
 * links of autumn 2025 shows the form:
 *
 * | key              | value                                                                                             |
 * | ---------------- | ------------------------------------------------------------------------------------------------- |
 * | `StartBox`       | `[x, y, k]`: where the robot starts; k = 0 is up (k was 0 in both: chosen)                        |
 * | `Wallobjects`    | `[x, y, length, k]` each: its middle; k = 0 lies, k = 2 stands                                    |
 * | `Blockobjects`   | `[x, y, movable, k]` each: its middle (`movable` was `false` in the one that was seen: chosen)     |
 * | `playgroundSize` | `[width, height]`                                                                                 |
 *
 * A key with nothing in it is left out. Pen lines and the robot's size, which its editor has, were never seen.
 */
import { isRecord } from '#core/record';

/**
 * Its unit in mm. Chosen: with it the bays between the walls of a public exercise (227, 131 and 66) suit the limits of its
 * solution (20 and 30 cm).
 */
export const UNIT_MM = 1;

/** Thickness of its walls in mm. Chosen: a world does not say it. */
export const WALL_MM = 10;

/** Edge of its square blocks in mm. Chosen: a world does not say it. */
export const BLOCK_MM = 50;

/** Size of an arena that a world does not give, in its units: that of both public worlds. */
export const USUAL_SIZE = [2000, 2000] as const;

/** The number of directions. */
export const EIGHTHS = 8;

/** The keys of a world that are understood. */
export const worldKeys = ['StartBox', 'Wallobjects', 'Blockobjects', 'playgroundSize'] as const;
export type WorldKey = (typeof worldKeys)[number];

/** A world as JSON. */
export type WorldValue = Readonly<Partial<Record<WorldKey, readonly unknown[]>>>;

/** True if a JSON value is such a world: an object with one of its keys. */
export const looksLikeWorld = (value: unknown): value is Readonly<Record<string, unknown>> =>
  isRecord(value) && worldKeys.some((key) => Object.hasOwn(value, key));

/** Degrees counter-clockwise from our +x, 0 up to but without 360, of a direction in which 0 lies. */
export const degOfEighths = (k: number): number => ((EIGHTHS - k) % EIGHTHS) * 45;

/** The nearest direction to degrees counter-clockwise from our +x. */
export const eighthsOfDeg = (deg: number): number => mod(-Math.round(deg / 45));

/** Our heading, in degrees, of a start box in direction k, of which 0 is up. */
export const headingOfStart = (k: number): number => degOfEighths(mod(k - 2));

/** The direction of a start box that is nearest to a heading in degrees. */
export const startOfHeading = (deg: number): number => mod(eighthsOfDeg(deg) + 2);

const mod = (k: number): number => ((k % EIGHTHS) + EIGHTHS) % EIGHTHS;
