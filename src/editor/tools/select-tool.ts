import type { Vec } from '#core/geometry';
import type { SceneEdit } from '#scene/edit';
import { moved } from '../arrange';
import { endOf, isTap, startOf } from '../drag';
import { draggedTurn, handleDragged } from '../handle-drag';
import { handleAt } from '../handles';
import { minus } from '../plane';
import { countOf, includes, joined, only, thingsAt, thingsIn, toggled, type Thing } from '../selection';
import { movingOf, snappedStep } from '../snap/attract';
import { luresOf } from '../snap/lures';
import {
  nothingSelected,
  type Drag,
  type Handle,
  type Mark,
  type Selection,
  type Tool,
  type ToolContext,
  type Turn,
} from './tool';

/**
 * Selects, moves, sizes and turns. A tap selects the topmost thing, again on the same place the next below; a drag moves
 * what it began on, or what is selected if that is part of it; a drag from nothing catches what its frame touches.
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
      case 'things':
        return moved(context.scene, grip.selection, stepOf(drag, grip, context), context.footprint);
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
    return [{ type: 'frame', from: startOf(drag), to: endOf(drag) }];
  },
  select(drag, context): Selection {
    const { scene, selection, footprint } = context;
    const grip = gripOf(drag, context);
    if (isTap(drag)) return tapped(drag, context, grip.type === 'handle');
    if (grip.type === 'handle') return selection;
    if (grip.type === 'things') return grip.selection;
    const framed = thingsIn(scene, startOf(drag), endOf(drag), footprint);
    return drag.adds ? joined(selection, framed) : framed;
  },
};

/** The things that a drag has grabbed. */
type Grip =
  | { readonly type: 'handle'; readonly handle: Handle }
  /** `held`: the thing right under the pointer; it is the one that the grid attracts. */
  | { readonly type: 'things'; readonly held: Thing; readonly selection: Selection }
  | { readonly type: 'floor' };

const grips = new WeakMap<Vec, { readonly context: ToolContext; readonly drag: Drag; readonly grip: Grip }>();

/** What a drag has grabbed, kept for as long as its starting place: it is needed on every move. */
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
  { scene, selection, footprint }: ToolContext,
): boolean =>
  known.context.scene === scene &&
  known.context.selection === selection &&
  known.context.footprint === footprint &&
  known.drag.reachMm === reachMm &&
  known.drag.adds === adds;

function findGrip(drag: Drag, { scene, selection, footprint }: ToolContext): Grip {
  const start = startOf(drag);
  const handle = handleAt(scene, selection, footprint, start, drag.reachMm);
  if (handle) return { type: 'handle', handle };
  const things = thingsAt(scene, start, drag.reachMm, footprint);
  const [topmost] = things;
  if (topmost === undefined) return { type: 'floor' };
  const held = things.find((thing) => includes(selection, thing));
  if (held !== undefined) return { type: 'things', held, selection };
  return { type: 'things', held: topmost, selection: drag.adds ? joined(selection, only(topmost)) : only(topmost) };
}

/** The displacement of a drag, with what it snaps to. */
function stepOf(drag: Drag, { held, selection }: Extract<Grip, { type: 'things' }>, context: ToolContext): Vec {
  const step = minus(endOf(drag), startOf(drag));
  const { scene, footprint } = context;
  const moving = movingOf(held, selection, context);
  return moving === null ? step : snappedStep(moving, step, luresOf(scene, selection, footprint), drag);
}

function tapped(drag: Drag, { scene, selection, footprint }: ToolContext, isOnHandle: boolean): Selection {
  const things = thingsAt(scene, startOf(drag), drag.reachMm, footprint);
  const [topmost] = things;
  if (topmost === undefined) return drag.adds || isOnHandle ? selection : nothingSelected;
  if (drag.adds) return toggled(selection, topmost);
  const now = countOf(selection) === 1 ? things.findIndex((thing) => includes(selection, thing)) : -1;
  return only(things[(now + 1) % things.length] ?? topmost);
}
