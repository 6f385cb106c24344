import type { Vec } from '#core/geometry';
import type { Scene } from '#scene/scene';
import type { Drag, ToolContext } from './tool';

/** A calculation that goes along the path of a drag. Its states are never changed, only followed by others. */
export interface Fold<State> {
  /**
   * Number of places that are processed together for good. The rest of the path, which is shorter, is processed again
   * on every move; rounding happens once per block.
   */
  readonly block: number;
  /** Before the first place. */
  start(drag: Drag, context: ToolContext): State;
  /** After some more of the path; the first of `places` is the last of those before. */
  after(state: State, places: readonly Vec[], drag: Drag, context: ToolContext): State;
}

interface Kept<State> {
  readonly first: Vec;
  readonly last: Vec;
  readonly count: number;
  readonly free: boolean;
  readonly reachMm: number;
  readonly options: ToolContext['options'];
  readonly state: State;
}

/**
 * Makes a function that runs a calculation along a drag and remembers its progress in the same course, so that a long
 * drag costs no more per move than a short one. It always returns what it would without memory.
 */
export function alongPath<State>(fold: Fold<State>): (drag: Drag, context: ToolContext) => State {
  const kept = new WeakMap<Scene, Kept<State>>();
  return (drag, context) => {
    const { path } = drag;
    const [first] = path;
    if (first === undefined) return fold.start(drag, context);
    const known = kept.get(context.scene);
    const isKnown = known !== undefined && continues(known, drag, context);
    let state = isKnown ? known.state : fold.start(drag, context);
    let count = isKnown ? known.count : 0;
    for (; path.length - count >= fold.block; count += fold.block)
      state = fold.after(state, path.slice(Math.max(0, count - 1), count + fold.block), drag, context);
    const last = path[count - 1];
    if (last)
      kept.set(context.scene, {
        first,
        last,
        count,
        free: drag.free,
        reachMm: drag.reachMm,
        options: context.options,
        state,
      });
    return count === path.length ? state : fold.after(state, path.slice(Math.max(0, count - 1)), drag, context);
  };
}

/** True if the beginning of a drag is known. Places are compared by identity: they never change. */
function continues<State>(known: Kept<State>, drag: Drag, context: ToolContext): boolean {
  return (
    drag.path[0] === known.first &&
    drag.path[known.count - 1] === known.last &&
    drag.reachMm === known.reachMm &&
    drag.free === known.free &&
    context.options === known.options
  );
}
