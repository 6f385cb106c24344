import type { Painted, PaintColor } from './paint/paint';
import { sceneDefaults, type Point, type Shaped } from './scene';

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

/** Writes a rotation as a property, as a version of the file has it; nothing for 0. */
export type Rotation = (angleDeg: number) => readonly string[];

/** From version 5 on: in degrees. */
export const asAngle: Rotation = (angleDeg) => property('angle', angleDeg, sceneDefaults.angle);

/** Before version 5: in eighths of a full turn. */
export const asTurn: Rotation = (angleDeg) => property('turn', angleDeg / 45, sceneDefaults.angle);

/** Colour and infrared of what may be painted. */
export const paintProperties = (
  { color, infrared }: Painted,
  ifMissing: PaintColor | null = null,
): readonly string[] => [
  ...property('color', color ?? null, ifMissing),
  ...property('infrared', infrared ?? null, null),
];

/** Place, size, rotation and, if it is a polygon, the corners of a shape. */
export const shapeProperties = ({ at, size, angle, corners }: Shaped, rotation: Rotation): readonly string[] => [
  `"at": ${pair(at)}`,
  `"size": ${pair(size)}`,
  ...rotation(angle),
  ...(corners === undefined ? [] : [`"corners": [${corners.map(pair).join(', ')}]`]),
];
