import { applyEdit, objectsPut, singleEdits, type SceneEdit } from './edit';
import { inverse } from './inverse';
import type { Scene, SceneObject } from './scene';

/** Steps that can be taken back. Chosen: more than a lesson has. */
export const HISTORY_STEPS = 1000;

/**
 * Characters that the edits of these steps have together as JSON; the oldest steps beyond are given up. Chosen: a picture of
 * the largest size is moved sixteen times, 2000 objects 200 times.
 */
export const HISTORY_CHARACTERS = 50_000_000;

/** An edit that was done, with the one that takes it back. */
export interface Step {
  readonly edit: SceneEdit;
  readonly inverse: SceneEdit;
  /** Length of the edit as JSON. The content of the inverse was in the course before. */
  readonly characters: number;
}

/** A course with the steps that led to it, and those that were taken back. Immutable. */
export interface History {
  /** Oldest first. */
  readonly past: readonly Step[];
  readonly present: Scene;
  /** The next one first. */
  readonly future: readonly Step[];
}

/** The beginning: nothing to take back. */
export const historyOf = (scene: Scene): History => ({ past: [], present: scene, future: [] });

/** An edit of `scene` as a step. */
export const stepOf = (scene: Scene, edit: SceneEdit): Step => ({
  edit,
  inverse: inverse(scene, edit),
  characters: JSON.stringify(edit).length,
});

/** One step further; steps that were taken back are given up. An edit that changes nothing is no step. */
export function advanced(history: History, edit: SceneEdit): History {
  const present = applyEdit(history.present, edit);
  if (present === history.present) return history;
  return { past: latest([...history.past, stepOf(history.present, edit)]), present, future: [] };
}

/** The things that a step changes, whether it is done or undone. */
export interface Touched {
  /** The objects that come, go or change, in their state before and after. */
  readonly objects: readonly SceneObject[];
  /** The robot's start. */
  readonly robot: boolean;
  /** The size of the arena. */
  readonly size: boolean;
}

/** The things that a step changes. */
export function touchedBy({ edit, inverse: back }: Step): Touched {
  const edits = [edit, back].flatMap(singleEdits);
  return {
    objects: edits.flatMap(objectsPut),
    robot: edits.some(({ type }) => type === 'robot'),
    size: edits.some((single) => single.type === 'course' && single.changes.size !== undefined),
  };
}

function latest(steps: readonly Step[]): readonly Step[] {
  let room = HISTORY_CHARACTERS;
  const isBeyond = ({ characters }: Step, index: number): boolean =>
    steps.length - index > HISTORY_STEPS || (room -= characters) < 0;
  return steps.slice(steps.findLastIndex(isBeyond) + 1);
}

/** One step back, or the same history at its beginning. */
export function undone(history: History): History {
  const step = history.past.at(-1);
  if (step === undefined) return history;
  const { past, present, future } = history;
  return { past: past.slice(0, -1), present: applyEdit(present, step.inverse), future: [step, ...future] };
}

/** One step forth again, or the same history at its end. */
export function redone(history: History): History {
  const [step, ...future] = history.future;
  if (step === undefined) return history;
  return { past: [...history.past, step], present: applyEdit(history.present, step.edit), future };
}
