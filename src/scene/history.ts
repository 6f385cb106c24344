import type { Scene } from './scene';

/** Steps that can be taken back. Chosen: more than a lesson has; the scenes share what they have in common. */
export const HISTORY_STEPS = 1000;

/** A course with the way it came about. Immutable. */
export interface History {
  /** Oldest first. */
  readonly past: readonly Scene[];
  readonly present: Scene;
  /** The next one first. */
  readonly future: readonly Scene[];
}

/** The beginning: nothing to take back. */
export const historyOf = (scene: Scene): History => ({ past: [], present: scene, future: [] });

/** One step further; what was taken back before is given up. The same scene again is no step. */
export function advanced(history: History, scene: Scene): History {
  if (scene === history.present) return history;
  return { past: [...history.past, history.present].slice(-HISTORY_STEPS), present: scene, future: [] };
}

/** One step back, or the same history at its beginning. */
export function undone({ past, present, future }: History): History {
  const before = past[past.length - 1];
  if (before === undefined) return { past, present, future };
  return { past: past.slice(0, -1), present: before, future: [present, ...future] };
}

/** One step forth again, or the same history at its end. */
export function redone({ past, present, future }: History): History {
  const [next, ...rest] = future;
  if (next === undefined) return { past, present, future };
  return { past: [...past, present], present: next, future: rest };
}
