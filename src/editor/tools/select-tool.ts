import type { Vec } from '#core/geometry';
import type { SceneEdit } from '#scene/edit';
import { movingSelection } from '../arrange';
import { copiedBy } from '../clipboard';
import { endOf, isTap, startOf } from '../drag';
import { draggedTurn, handleDragged } from '../handle-drag';
import { handleAt } from '../handles';
import { thingsInLasso } from '../lasso';
import { isBendable } from '../lines/bendable';
import { minus } from '../plane';
import { includes, joined, takenBy, thingsAt, thingsIn, toggled, type Thing } from '../selection';
import { movingOf, snappedStep } from '../snap/attract';
import { luresOf } from '../snap/lures';
import {
  nothingSelected,
  type Drag,
  type Handle,
  type Mark,
  type Opened,
  type Selection,
  type Tool,
  type ToolContext,
  type Turn,
} from './tool';

/**
 * Selects, moves, sizes and turns. A tap selects the topmost thing or its group, again on the same place the next below; a drag moves
 * what it began on, or what is selected if that is part of it, or with Alt copies of it; a drag from nothing catches what
 * its frame or lasso touches.
 */
export const selectTool: Tool = {
  id: 'select',
  cursor: 'default',
  edit(drag, context): SceneEdit | null {
    if (isTap(drag)) return null;
    const grip = gripOf(drag, context);
    switch (grip.type) {
      case 'handle':
        return handleDragged(grip.handle, drag, context);
      case 'things': {
        const step = stepOf(drag, grip, context);
        if (drag.alt === true) return copiedBy(context.scene, grip.selection, step)?.edit ?? null;
        return movingSelection(context.scene, grip.selection, step, context.footprint);
      }
      case 'floor':
        return null;
      default:
        return grip satisfies never;
    }
  },
  turns(drag, context): Turn | null {
    const grip = isTap(drag) ? null : gripOf(drag, context);
    if (grip?.type !== 'handle' || grip.handle.kind !== 'rotate') return null;
    return draggedTurn(drag, context.scene, context.selection);
  },
  marks(drag, context, isDown): readonly Mark[] {
    if (!isDown || isTap(drag) || gripOf(drag, context).type !== 'floor') return [];
    if (context.options.catches === 'lasso') return [{ type: 'lasso', path: drag.path }];
    return [{ type: 'frame', from: startOf(drag), to: endOf(drag) }];
  },
  select(drag, context): Selection {
    const { scene, selection } = context;
    const grip = gripOf(drag, context);
    if (isTap(drag)) return tapped(drag, context, grip.type === 'handle');
    if (grip.type === 'handle') return selection;
    if (grip.type === 'floor')
      return adds(drag, context) ? joined(selection, caught(drag, context)) : caught(drag, context);
    if (drag.alt !== true) return grip.selection;
    return copiedBy(scene, grip.selection, stepOf(drag, grip, context))?.selection ?? selection;
  },
  opens: opened,
};

/** A group opens the thing in it; then labels open their words, lines their points, polygons their corners. */
function opened(drag: Drag, { scene, selection, footprint }: ToolContext): Opened | null {
  const [topmost] = thingsAt(scene, startOf(drag), drag.reachMm, footprint);
  if (topmost && takenBy(scene, topmost, selection).ids.length > 1) return { part: 'thing', id: topmost };
  const object = scene.objects.find(({ id }) => id === topmost);
  if (object?.type === 'label') return { part: 'words', id: object.id };
  return object && isBendable(object) ? { part: 'points', id: object.id } : null;
}

/** The selection that a drag from the floor makes. */
function caught(drag: Drag, { scene, options, footprint }: ToolContext): Selection {
  return options.catches === 'lasso'
    ? thingsInLasso(scene, drag.path, footprint)
    : thingsIn(scene, startOf(drag), endOf(drag), footprint);
}

/** True if a tap or drag adds to what is selected. */
const adds = (drag: Drag, { options }: ToolContext): boolean => drag.adds || options.several;

/** The handle, the things or the floor that a drag has grabbed. */
type Grip =
  | { readonly type: 'handle'; readonly handle: Handle }
  /** `held`: the thing right under the pointer; it is the one that the grid attracts. */
  | { readonly type: 'things'; readonly held: Thing; readonly selection: Selection }
  | { readonly type: 'floor' };

const grips = new WeakMap<Vec, { readonly context: ToolContext; readonly drag: Drag; readonly grip: Grip }>();

/** The grip of a drag, cached per starting place: it is needed on every move. */
function gripOf(drag: Drag, context: ToolContext): Grip {
  const start = startOf(drag);
  const known = grips.get(start);
  if (known && isSameGrip(known, drag, context)) return known.grip;
  const grip = findGrip(drag, context);
  grips.set(start, { context, drag: { ...drag, path: [start] }, grip });
  return grip;
}

const isSameGrip = (
  known: { readonly context: ToolContext; readonly drag: Drag },
  { reachMm, adds }: Drag,
  { scene, selection, footprint, options }: ToolContext,
): boolean =>
  known.context.scene === scene &&
  known.context.options.several === options.several &&
  known.context.selection === selection &&
  known.context.footprint === footprint &&
  known.drag.reachMm === reachMm &&
  known.drag.adds === adds;

function findGrip(drag: Drag, context: ToolContext): Grip {
  const { scene, selection, footprint } = context;
  const start = startOf(drag);
  const handle = handleAt(scene, selection, footprint, start, drag.reachMm);
  if (handle) return { type: 'handle', handle };
  const things = thingsAt(scene, start, drag.reachMm, footprint);
  const [topmost] = things;
  if (topmost === undefined) return { type: 'floor' };
  const held = things.find((thing) => includes(selection, thing));
  if (held !== undefined) return { type: 'things', held, selection };
  const taken = takenBy(scene, topmost, selection);
  return { type: 'things', held: topmost, selection: adds(drag, context) ? joined(selection, taken) : taken };
}

/** The displacement of a drag, with what it snaps to. */
function stepOf(drag: Drag, { held, selection }: Extract<Grip, { type: 'things' }>, context: ToolContext): Vec {
  const step = minus(endOf(drag), startOf(drag));
  const { scene, footprint } = context;
  const moving = movingOf(held, selection, context);
  return moving === null ? step : snappedStep(moving, step, luresOf(scene, selection, footprint), drag);
}

function tapped(drag: Drag, context: ToolContext, isOnHandle: boolean): Selection {
  const { scene, selection, footprint } = context;
  const things = thingsAt(scene, startOf(drag), drag.reachMm, footprint);
  // Those of one group are one: the next below is another one.
  const units = distinct(things.map((thing) => takenBy(scene, thing, selection)));
  const [topmost] = units;
  if (topmost === undefined) return adds(drag, context) || isOnHandle ? selection : nothingSelected;
  if (adds(drag, context)) return toggled(selection, topmost);
  const now = units.findIndex((unit) => isJust(selection, unit));
  return units[(now + 1) % units.length] ?? topmost;
}

/** True if nothing more and nothing less is selected. */
const isJust = (selection: Selection, { ids, robot }: Selection): boolean =>
  selection.robot === robot && selection.ids.length === ids.length && ids.every((id) => selection.ids.includes(id));

const distinct = (units: readonly Selection[]): readonly Selection[] =>
  units.filter((unit, index) => units.findIndex((other) => isJust(other, unit)) === index);
