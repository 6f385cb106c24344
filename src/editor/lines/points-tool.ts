import type { Vec } from '#core/geometry';
import { isSame } from '#core/same';
import type { SceneEdit } from '#scene/edit';
import { endOf, isTap, startOf } from '../drag';
import { changing } from '../edits';
import { distanceMm, minus, plus, toVec } from '../plane';
import { only, thingsAt } from '../selection';
import { onGrid } from '../snap';
import type { Drag, Mark, Selection, Tool, ToolContext } from '../tools/tool';
import { bendableOf, bentAlong, isBendable, lineAlong, mayHaveMore, type Bendable } from './bendable';
import {
  controlPlaces,
  neighbours,
  partMiddles,
  withControlAt,
  withNewControl,
  withoutControl,
  type BentLine,
} from './control-points';
import { endNear, puttingJoined } from './join-lines';

/**
 * Bends the selected line at its points, or a polygon at its corners: a drag moves one, from between two it draws out a
 * new one, onto a neighbour it takes it away. An end that comes to the end of a line that looks the same joins it.
 */
export const pointsTool: Tool = {
  id: 'points',
  cursor: 'default',
  edit(drag, context): SceneEdit | null {
    const bent = isTap(drag) ? null : dragged(drag, context);
    if (!bent?.after || isSame(bent.after, bent.before)) return null;
    return drag.free || bent.after.type !== 'stroke'
      ? changing([bent.after])
      : puttingJoined(context.scene, bent.after);
  },
  marks(drag, context, isDown): readonly Mark[] {
    const object = bentBy(context);
    if (!object) return [];
    const bent = isDown && !isTap(drag) ? dragged(drag, context) : null;
    const marks = pointMarks(bent?.after ?? object, drag.reachMm);
    return bent?.ring ? [...marks, { type: 'snap', at: bent.ring }] : marks;
  },
  marksAtRest(context) {
    const object = bentBy(context);
    return object ? pointMarks(object, 0) : [];
  },
  select(drag, { scene, selection, footprint }): Selection {
    const isOther = (id: string | null): boolean => scene.objects.some((one) => one.id === id && isBendable(one));
    const other = thingsAt(scene, startOf(drag), drag.reachMm, footprint).find(isOther);
    return isTap(drag) && other !== undefined && !selection.ids.includes(other ?? '') ? only(other) : selection;
  },
};

/** The course without the point of what is selected at a place; `null`: there is none, or too little would be left. */
export function linePointRemoved(context: ToolContext, place: Vec, reachMm: number): SceneEdit | null {
  const object = bentBy(context);
  const line = object && lineAlong(object);
  const hold = line && holdAt(line, place, reachMm);
  const left = line && hold && !hold.isNew ? withoutControl(line, hold.control) : null;
  const after = object && left && bentAlong(object, left);
  return after && changing([after]);
}

const bentBy = ({ scene, selection }: ToolContext): Bendable | null => bendableOf(scene, selection);

/** The handle that a drag moves: a control, or the middle of the part after one. */
interface Hold {
  readonly control: number;
  readonly isNew: boolean;
  readonly at: Vec;
}

function holdAt(line: BentLine, place: Vec, reachMm: number): Hold | null {
  const controls = controlPlaces(line).map((at, control) => ({ control, isNew: false, at }));
  const middles = partMiddles(line).map(({ after, at }) => ({ control: after, isNew: true, at }));
  const nearest = (holds: readonly Hold[]): Hold | null => {
    let best: Hold | null = null;
    for (const hold of holds)
      if (distanceMm(hold.at, place) <= (best ? distanceMm(best.at, place) : reachMm)) best = hold;
    return best;
  };
  const control = nearest(controls);
  const middle = nearest(middles);
  if (!control || !middle) return control ?? middle;
  return distanceMm(middle.at, place) < distanceMm(control.at, place) ? middle : control;
}

interface Bent {
  readonly before: Bendable;
  /** `null`: it cannot be bent so. */
  readonly after: Bendable | null;
  /** The end of another line to which its end has come. */
  readonly ring: Vec | null;
}

function dragged(drag: Drag, context: ToolContext): Bent | null {
  const before = bentBy(context);
  const whole = before && lineAlong(before);
  const hold = whole && holdAt(whole, startOf(drag), drag.reachMm);
  if (!before || !hold || (hold.isNew && !mayHaveMore(before))) return null;
  const line = hold.isNew ? withNewControl(whole, hold.control) : whole;
  const control = hold.isNew ? hold.control + 1 : hold.control;
  const place = plus(hold.at, minus(endOf(drag), startOf(drag)));
  const result = (bent: BentLine, ring: Vec | null = null): Bent => ({ before, after: bentAlong(before, bent), ring });
  if (!hold.isNew && isOnNeighbour(line, control, place, drag.reachMm)) {
    const left = withoutControl(line, control);
    if (left) return result(left);
  }
  if (drag.free) return result(withControlAt(line, control, place));
  const isEnd = neighbours(line, control).includes(null);
  const end = isEnd && before.type === 'stroke' ? endNear(context.scene, before, place, drag.reachMm, before.id) : null;
  if (end) return result(withControlAt(line, control, toVec(end)), toVec(end));
  return result(withControlAt(line, control, onGrid(place, drag.reachMm)));
}

/** True if a control was dragged onto one beside it; those that lay close from the beginning must come closer. */
function isOnNeighbour(line: BentLine, control: number, place: Vec, reachMm: number): boolean {
  const places = controlPlaces(line);
  const own = places[control];
  return neighbours(line, control).some((other) => {
    const there = other === null ? undefined : places[other];
    return (
      own !== undefined &&
      there !== undefined &&
      distanceMm(there, place) <= Math.min(reachMm, distanceMm(there, own) / 2)
    );
  });
}

/** All points of a line that can be taken hold of; middles only where there is room for one. */
function pointMarks(object: Bendable, reachMm: number): readonly Mark[] {
  const line = lineAlong(object);
  const places = controlPlaces(line);
  const middles = (mayHaveMore(object) ? partMiddles(line) : []).filter(({ after, at }) => {
    const start = places[after];
    return start !== undefined && distanceMm(start, at) > reachMm;
  });
  return [
    ...middles.map(({ at }): Mark => ({ type: 'point', at, isNew: true })),
    ...places.map((at): Mark => ({ type: 'point', at, isNew: false })),
  ];
}
