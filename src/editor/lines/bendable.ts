import { boundsOfOutline } from '#scene/outline';
import { sceneLimits, type Block, type Point, type Scene, type SceneObject, type Spikes, type Stroke, type Zone } from '#scene/scene'; // prettier-ignore
import { polygonFault } from '#scene/shape/polygon-fault';
import { polygonThrough, shapeOutline, toOwnFrame } from '#scene/shape/shape';
import { isLargeEnough } from '../kinds/box';
import { plus, toPoint, toVec, turned, within } from '../plane';
import type { Selection } from '../tools/tool';
import { bentLine, pointsOfBent, type BentLine } from './control-points';

/** A body or a zone with corners. */
type Polygon = (Block | Spikes | Zone) & { readonly corners: readonly Point[] };

/** Things that are bent at their points: a line, or a polygon at its corners. */
export type Bendable = Stroke | Polygon;

/** The selected thing that can be bent: the only one selected, if it has points and is not locked. */
export function bendableOf(scene: Scene, { ids: [id, ...more], robot }: Selection): Bendable | null {
  const object = more.length > 0 || robot ? undefined : scene.objects.find((one) => one.id === id);
  return object && !object.lock && isBendable(object) ? object : null;
}

/** True if a thing has points that can be taken hold of. */
export const isBendable = (object: SceneObject): object is Bendable =>
  object.type === 'stroke' ? object.points.length > 1 : 'corners' in object;

/** A thing as a line with its controls; that of a polygon is closed, and each corner is a control. */
export function lineAlong(object: Bendable): BentLine {
  if (object.type === 'stroke') return bentLine(object);
  const places = shapeOutline(object);
  return { places, isClosed: true, controls: places.map((_, index) => index) };
}

/** True if a thing may have one point more. */
export const mayHaveMore = (object: Bendable): boolean =>
  object.type === 'stroke' || object.corners.length < sceneLimits.corners.max;

/** A thing along another line; `null`: too little would be left, or an outline would cross itself. */
export function bentAlong(object: Bendable, line: BentLine): Bendable | null {
  if (object.type !== 'stroke') return polygonAlong(object, line);
  const points = pointsOfBent(line);
  return points.length < 2 ? null : { ...object, points };
}

/** A polygon with other corners; its rotation stays, and so do the places of corners that were not moved. */
function polygonAlong(polygon: Polygon, { places }: BentLine): Polygon | null {
  const { at, angle, size } = polygon;
  const [width, height] = size;
  // Counted from the lower left, where the corners of a polygon that was drawn are whole millimetres.
  const corners = places.map((place) => toPoint(plus(toOwnFrame(polygon, place), { x: width / 2, y: height / 2 })));
  if (polygonFault(corners)) return null;
  const bent = polygonThrough(corners);
  if (bent.size.some((mm) => within(mm, sceneLimits.blockMm) !== mm) || !isLargeEnough(bent)) return null;
  const { minX, minY, maxX, maxY } = boundsOfOutline(corners.map(toVec));
  const middle = { x: (minX + maxX - width) / 2, y: (minY + maxY - height) / 2 };
  return { ...polygon, ...bent, at: toPoint(plus(toVec(at), turned(middle, angle))), angle };
}
