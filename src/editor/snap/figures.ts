import type { Vec } from '#core/geometry';
import { objectsPut, singleEdits, type SceneEdit } from '#scene/edit';
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
}

const NONE: Figures = { reading: null, marks: [] };

/** A drag of a tool that is under way. */
export interface UsedTool {
  readonly tool: Tool;
  readonly drag: Drag;
}

/**
 * The figures of what an edit would do. Guide lines show what is in line afterwards; they stay away when nothing snaps.
 *
 * @param used the tool and its drag; `null`: keys move what is selected
 */
export function figuresOf(edit: SceneEdit | null, context: ToolContext, used: UsedTool | null): Figures {
  const byDeg = used?.tool.turns?.(used.drag, context) ?? null;
  if (byDeg !== null) return { reading: { type: 'turned', byDeg }, marks: [] };
  if (edit === null) return NONE;
  const reading = readingOf(context.scene, edit);
  if (reading === null || reading.type === 'heading') return { reading, marks: [] };
  const { frame, changed } = changedBy(edit, context);
  if (frame === null) return { reading, marks: [] };
  const lures = luresOf(context.scene, changed, context.footprint);
  const guides = used?.drag.free === true ? [] : guidesOf(frame, lures);
  return { reading, marks: [...guides, ...distancesOf(frame, lures)] };
}

/** How long a line is that is drawn freely. */
export function inkReading(path: readonly Vec[]): Reading {
  let mm = 0;
  let before = path[0];
  for (const place of path) {
    mm += before ? distanceMm(before, place) : 0;
    before = place;
  }
  return { type: 'length', mm, deg: null, from: path[0] ?? { x: 0, y: 0 } };
}

/** Where an edit puts things, and which of them were there before. */
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
