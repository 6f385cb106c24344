import type { Vec } from '#core/geometry';
import { objectsPut, singleEdits, type SceneEdit } from '#scene/edit';
import { startOf } from '../drag';
import { distanceMm } from '../plane';
import type { Drag, Mark, Selection, Tool, ToolContext } from '../tools/tool';
import { frameAround, frameOf, frameOfRobot, type Frame } from './frames';
import { distancesOf, guidesOf } from './guides';
import { luresOf } from './lures';
import { readingOf, type Reading } from './reading';

/** Figures and lines that are shown while something is drawn, moved, sized or turned. */
export interface Figures {
  readonly reading: Reading | null;
  /** Guide lines and distances. */
  readonly marks: readonly Mark[];
  /** The frame of the things at their new place. */
  readonly frame: Frame | null;
}

/** Nothing is under way. */
export const noFigures: Figures = { reading: null, marks: [], frame: null };

/** A drag of a tool that is under way. */
export interface UsedTool {
  readonly tool: Tool;
  readonly drag: Drag;
}

/**
 * The figures of an edit. Guide lines show what is in line afterwards; there are none while a drag is free.
 *
 * @param used the tool and its drag; `null`: keys move what is selected
 */
export function figuresOf(edit: SceneEdit | null, context: ToolContext, used: UsedTool | null): Figures {
  const reading = (used && turnReading(used, context)) ?? editReading(edit, context, used);
  if (edit === null || reading === null || reading.type === 'heading' || reading.type === 'turned')
    return { ...noFigures, reading };
  const { frame, changed } = changedBy(edit, context);
  if (frame === null) return { ...noFigures, reading };
  const lures = luresOf(context.scene, changed, context.footprint);
  const guides = used?.drag.free === true ? [] : guidesOf(frame, lures);
  return { reading, marks: [...guides, ...distancesOf(frame, lures)], frame };
}

function turnReading({ tool, drag }: UsedTool, context: ToolContext): Reading | null {
  const turn = tool.turns?.(drag, context) ?? null;
  return turn && { type: 'turned', ...turn };
}

const editReading = (edit: SceneEdit | null, { scene }: ToolContext, used: UsedTool | null): Reading | null =>
  edit && readingOf(scene, edit, used && startOf(used.drag));

/** The live measurement of a drag with a tool; `null`: none. */
export const readingBy = (tool: Tool, drag: Drag, context: ToolContext): Reading | null =>
  turnReading({ tool, drag }, context) ?? editReading(tool.edit(drag, context), context, { tool, drag });

/** The length of a line that is drawn freely, without a direction. */
export function inkReading(path: readonly Vec[]): Reading {
  let mm = 0;
  let before = path[0];
  for (const place of path) {
    mm += before ? distanceMm(before, place) : 0;
    before = place;
  }
  return { type: 'length', mm, deg: null, from: path[0] ?? { x: 0, y: 0 } };
}

/** The frame of the things that an edit moves or adds, and which of them existed before. */
function changedBy(edit: SceneEdit, { scene, footprint }: ToolContext): { frame: Frame | null; changed: Selection } {
  const frames: Frame[] = [];
  const ids: string[] = [];
  let robot = false;
  for (const one of singleEdits(edit)) {
    frames.push(...objectsPut(one).map(frameOf));
    if (one.type === 'replace') ids.push(...one.changes.map(({ id }) => id));
    if (one.type !== 'robot') continue;
    robot = true;
    const there = frameOfRobot({ ...scene, robot: { ...scene.robot, ...one.robot } }, footprint);
    if (there) frames.push(there);
  }
  return { frame: frameAround(frames), changed: { ids, robot } };
}
