import { sceneDefaults, type Point } from './scene';
import type { Box } from './outline';

/** A place or an extent in the form of a file. */
export const pair = (point: Point): string => `[${point[0]}, ${point[1]}]`;

/** A property in the form of a file; nothing for a default value. */
export function property(
  name: string,
  value: string | number | boolean | null,
  ifMissing: string | number | boolean | null,
): string[] {
  return value === ifMissing ? [] : [`"${name}": ${JSON.stringify(value)}`];
}

/** Properties as an object on one line. */
export const braces = (properties: readonly string[]): string => `{ ${properties.join(', ')} }`;

/** Place, size and rotation of a box. */
export const boxProperties = ({ at, size, turn }: Box): readonly string[] => [
  `"at": ${pair(at)}`,
  `"size": ${pair(size)}`,
  ...property('turn', turn, sceneDefaults.turn),
];
