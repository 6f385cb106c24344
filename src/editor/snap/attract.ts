import type { Vec } from '#core/geometry';
import type { SceneObject } from '#scene/scene';
import { movedBy, placeOf } from '../kinds/index';
import { distanceMm, minus, plus, toPoint, toVec } from '../plane';
import { ATTRACTS_MM, gridMm, intoArena } from '../snap';
import { freeObjects, type Thing } from '../selection';
import { nothingSelected, type Drag, type Lure, type Selection, type ToolContext } from '../tools/tool';
import { endsOf, frameAround, frameOf, frameOfRobot, shiftedFrame, type Axis, type Frame } from './frames';
import { luresNear, luresOf, type AxisLures, type Lures } from './lures';
import { equalSteps } from './row';

/** Things attract from this far, in mm: half as far as the grid, so that its lines can be met beside them, too. */
const thingsReachMm = (reachMm: number): number => Math.min(reachMm, ATTRACTS_MM) / 2;

/** The things that are moved, before they are. */
export interface Moving {
  readonly frame: Frame;
  /** The ends of the lines among few things, as of a part of a track; they go onto ends of other lines. */
  readonly ends: readonly Vec[];
  /** The place that the grid attracts. */
  readonly anchor: Vec | null;
}

/** Maximum number of things in one part of a track. Chosen: a crossing with a field and some walls. */
const FEW = 12;

/** The things that move when one of the selection is dragged; `null`: none. */
export function movingOf(held: Thing, selection: Selection, { scene, footprint }: ToolContext): Moving | null {
  const objects = freeObjects(scene, selection);
  const robot = selection.robot ? frameOfRobot(scene, footprint) : null;
  const frame = frameAround([...objects.map(frameOf), ...(robot === null ? [] : [robot])]);
  const heldObject = objects.find(({ id }) => id === held);
  const anchor = held === null ? toVec(scene.robot.at) : heldObject ? toVec(placeOf(heldObject)) : null;
  return (
    frame && {
      frame,
      ends: objects.length > FEW || robot !== null ? [] : objects.flatMap((object) => endsOf(object) ?? []),
      anchor,
    }
  );
}

/**
 * The displacement of things that snap: a line's end onto that of another, else each axis on its own to the nearest edge,
 * middle or equal distance, else to the grid.
 */
export function snappedStep({ frame, ends, anchor }: Moving, step: Vec, lures: Lures, { free, reachMm }: Drag): Vec {
  if (free) return step;
  const nearMm = thingsReachMm(reachMm);
  const toEnd = stepToEnd(
    ends.map((end) => plus(end, step)),
    lures.ends,
    nearMm,
  );
  if (toEnd) return plus(step, toEnd);
  const there = shiftedFrame(frame, step);
  const along = (axis: Axis): number => {
    const toThing = stepAlong(there, lures, axis, nearMm);
    if (toThing !== null) return step[axis] + toThing;
    return anchor === null ? step[axis] : gridMm(anchor[axis] + step[axis], reachMm) - anchor[axis];
  };
  return { x: along('x'), y: along('y') };
}

function stepToEnd(ends: readonly Vec[], others: readonly Vec[], reachMm: number): Vec | null {
  let best: Vec | null = null;
  let bestMm = reachMm;
  for (const end of ends) {
    for (const other of others) {
      if (Math.abs(other.x - end.x) > bestMm || Math.abs(other.y - end.y) > bestMm) continue;
      const mm = distanceMm(end, other);
      if (mm > bestMm) continue;
      best = minus(other, end);
      bestMm = mm;
    }
  }
  return best;
}

/** The shortest step to an edge, a middle or an equal distance; `null`: none is within reach. */
function stepAlong(frame: Frame, lures: Lures, axis: Axis, reachMm: number): number | null {
  const { min, mid, max } = frame[axis];
  const steps = [
    ...stepsTo(lures[axis], 'edges', min, reachMm),
    ...stepsTo(lures[axis], 'edges', max, reachMm),
    ...stepsTo(lures[axis], 'middles', mid, reachMm),
    ...equalSteps(frame, lures.frames, axis),
  ];
  return shortest(steps, reachMm);
}

function shortest(steps: readonly number[], reachMm: number): number | null {
  let best: number | null = null;
  for (const mm of steps) if (Math.abs(mm) <= Math.abs(best ?? reachMm)) best = mm;
  return best;
}

const stepsTo = (lures: AxisLures, what: keyof AxisLures, atMm: number, reachMm: number): readonly number[] =>
  luresNear(lures[what], atMm, reachMm).map((lure) => lure.atMm - atMm);

/** A drag for which things attract what it draws or sizes; `moved`: those that do not, because they change themselves. */
export function withLure(drag: Drag, { scene, footprint }: ToolContext, moved: Selection = nothingSelected): Drag {
  if (drag.free) return drag;
  const lures = luresOf(scene, moved, footprint);
  const nearMm = thingsReachMm(drag.reachMm);
  const lure: Lure = (mm, axis) => {
    const step = shortest(
      [...stepsTo(lures[axis], 'edges', mm, nearMm), ...stepsTo(lures[axis], 'middles', mm, nearMm)],
      nearMm,
    );
    return step === null ? null : mm + step;
  };
  return { ...drag, lure };
}

/** A new object where it snaps when it is put at its place. */
export function snappedObject(object: SceneObject, drag: Drag, { scene, footprint }: ToolContext): SceneObject {
  const at = toVec(placeOf(object));
  const moving = { frame: frameOf(object), ends: [], anchor: at };
  const lures = luresOf(scene, nothingSelected, footprint);
  const to = toPoint(intoArena(plus(at, snappedStep(moving, { x: 0, y: 0 }, lures, drag)), scene.size));
  return movedBy(object, to[0] - at.x, to[1] - at.y);
}
