import type { Vec } from '#core/geometry';
import type { Point, SceneObject } from '#scene/scene';
import { TILE_MM } from '#scene/league/league';
import type { LineMap, Place } from './map';
import { HALF_MM } from './shapes';

/** The middle of a tile in the arena. */
export type Floor = (tile: Place) => Vec;

/** The floor of a map: its lowest row lies along the lower edge of the arena. */
export const floorOf =
  ({ rows }: Pick<LineMap, 'rows'>): Floor =>
  ({ x, y }) => ({ x: TILE_MM * x + HALF_MM, y: TILE_MM * (rows - 1 - y) + HALF_MM });

/** A place in whole mm. */
export const rounded = ({ x, y }: Vec): Point => [Math.round(x) + 0, Math.round(y) + 0];

/** An object that gets its id later. */
export type Unnamed = SceneObject extends infer O ? (O extends SceneObject ? Omit<O, 'id'> : never) : never;
