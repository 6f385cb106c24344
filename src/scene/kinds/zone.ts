import type { Vec } from '#core/geometry';
import { paintProperties, property, shapeProperties } from '../json-text';
import { distanceToEdge, overlapMm, squaredDistance, type Outline } from '../outline';
import { sceneDefaults, type Paper, type SceneObject, type Zone } from '../scene';
import { outlineHolds, shapeBounds, shapeOutline, shapeParts, toOwnFrame } from '../shape/shape';
import type { SceneKind } from './kind';

function zoneKind(type: Zone['type']): SceneKind<Zone> {
  return {
    name: type,
    write: (zone, rotation) => [
      ...shapeProperties(zone, rotation),
      ...property('round', zone.round, sceneDefaults.round),
      ...property('number', zone.number, 0),
      ...property('blocks', zone.blocks, sceneDefaults.blocks),
      ...property('blockColor', zone.blockColor ?? null, null),
      ...paintProperties(zone),
    ],
    solid: () => [],
    bounds: shapeBounds,
    reachesInto: zoneOverlaps,
  };
}

/** True if an object is a zone of any kind. */
export const isZone = (object: SceneObject): object is Zone => zoneTypes.some((type) => type === object.type);

/** True if an object is a field on the floor, with or without a meaning for the verdict. */
export const isField = (object: SceneObject): object is Zone | Paper => object.type === 'paper' || isZone(object);

const zoneTypes: readonly SceneObject['type'][] = ['target', 'checkpoint', 'forbidden'] satisfies Zone['type'][];

/** A place that the robot, or blocks, must reach. */
export const target = zoneKind('target');

/** A place to be passed in the order of its numbers. */
export const checkpoint = zoneKind('checkpoint');

/** A place that must not be entered. */
export const forbidden = zoneKind('forbidden');

/** Figures of a course are whole mm; so little is an error of rounding. */
const ROUNDING_MM = 1e-6;

/** True if a place lies in a zone; its edge belongs to it. World mm. */
export function zoneHolds(zone: Zone, place: Vec): boolean {
  if (zone.corners) return outlineHolds(shapeOutline(zone), place, ROUNDING_MM);
  if (isFarFrom(zone, place)) return false;
  const { x, y } = toOwnFrame(zone, place);
  const halfX = zone.size[0] / 2 + ROUNDING_MM;
  const halfY = zone.size[1] / 2 + ROUNDING_MM;
  if (!zone.round) return Math.abs(x) <= halfX && Math.abs(y) <= halfY;
  const alongX = x / halfX;
  const alongY = y / halfY;
  return alongX * alongX + alongY * alongY <= 1;
}

/** Tells most places outside without turning them into the zone's frame: half of both sides and a mm away from its middle. */
function isFarFrom({ at, size }: Zone, place: Vec): boolean {
  const reach = (size[0] + size[1]) / 2 + 1;
  return Math.abs(place.x - at[0]) > reach || Math.abs(place.y - at[1]) > reach;
}

/** True if a zone contains a convex outline in world mm; its edge belongs to it. */
export function zoneContains(zone: Zone, outline: Outline): boolean {
  if (!outline.every((corner) => zoneHolds(zone, corner))) return false;
  // A hollow zone may reach into what it holds by the corners.
  return !zone.corners || !shapeOutline(zone).some((corner) => isWithin(outline, corner));
}

/** True if a place lies inside an outline and not only at its edge. */
const isWithin = (outline: Outline, place: Vec): boolean =>
  outlineHolds(outline, place, 0) && distanceToEdge(outline, place) > ROUNDING_MM;

/** True if a convex outline in world mm covers a part of a zone; touching its edge is not yet covering. */
export function zoneOverlaps(zone: Zone, outline: Outline): boolean {
  if (!zone.round) return shapeParts(zone).some((part) => overlapMm(outline, part) > ROUNDING_MM);
  const scaleX = 2 / zone.size[0];
  const scaleY = 2 / zone.size[1];
  const inCircle = outline.map((corner) => {
    const { x, y } = toOwnFrame(zone, corner);
    return { x: x * scaleX, y: y * scaleY };
  });
  return coversUnitCircle(inCircle);
}

/** True if a convex outline covers a part of the circle of radius 1 about the origin. */
function coversUnitCircle(outline: Outline): boolean {
  let lefts = 0;
  let rights = 0;
  for (const [index, from] of outline.entries()) {
    const to = outline[(index + 1) % outline.length] ?? from;
    if (squaredDistance({ x: 0, y: 0 }, from, to) < 1 - ROUNDING_MM) return true;
    if (from.x * to.y - from.y * to.x > 0) lefts++;
    else rights++;
  }
  return lefts === 0 || rights === 0; // the origin lies on the same side of all edges: the circle lies inside
}
