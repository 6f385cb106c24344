import type { Vec } from '#core/geometry';
import { boundsOf } from '#scene/kinds/index';
import { boundsAll } from '../bounds';
import { putMoved, type Clip, type Pasted } from '../clipboard';
import { placeOf } from '../kinds/index';
import { frameAround, frameOf, endsOf } from '../snap/frames';
import { snappedStep } from '../snap/attract';
import { luresOf } from '../snap/lures';
import { minus, toPoint, toVec } from '../plane';
import { nothingSelected, type Drag, type ToolContext } from '../tools/tool';

/**
 * Puts a part into the course with its middle at a place. It snaps like things that are moved: ends of its lines go
 * onto ends of lines that are there, else edges, middles and the grid attract it.
 *
 * @returns `null`: it is empty, or there is no number left for its checkpoint
 */
export function brought(
  { scene, footprint }: Pick<ToolContext, 'scene' | 'footprint'>,
  { objects }: Clip,
  at: Vec,
  how: Pick<Drag, 'free' | 'reachMm'>,
): Pasted | null {
  const around = boundsAll(objects.map(boundsOf));
  const frame = frameAround(objects.map(frameOf));
  if (!around || !frame) return null;
  const middle = { x: (around.minX + around.maxX) / 2, y: (around.minY + around.maxY) / 2 };
  const ends = objects.flatMap((object) => endsOf(object) ?? []);
  const [first] = objects;
  const moving = { frame, ends, anchor: ends[0] ?? (first ? toVec(placeOf(first)) : null) };
  const lures = luresOf(scene, nothingSelected, footprint);
  const step = snappedStep(moving, minus(at, middle), lures, { path: [at], adds: false, ...how });
  return putMoved(scene, objects, toPoint(step));
}
