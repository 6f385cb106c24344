import type { Vec } from '#core/geometry';
import type { Outline } from '#scene/outline';
import type { Scene, SceneObject } from '#scene/scene';
import { freeObjects } from '../selection';
import type { Selection } from '../tools/tool';
import { axes, endsOf, frameOf, frameOfArena, frameOfRobot, type Axis, type Frame } from './frames';

/** A line across the arena that attracts: an edge or the middle of a thing. */
export interface Lure {
  readonly atMm: number;
  readonly of: Frame;
}

/** The attractors along one axis, each list in ascending order. */
export interface AxisLures {
  readonly edges: readonly Lure[];
  readonly middles: readonly Lure[];
}

/** Everything in a course that may attract something. Made once per gesture. */
export interface Lures extends Readonly<Record<Axis, AxisLures>> {
  /** The frames of all things. */
  readonly frames: readonly Frame[];
  /** The ends of all lines. */
  readonly ends: readonly Vec[];
  readonly arena: Frame;
}

interface Known {
  readonly moved: readonly SceneObject[];
  readonly robot: boolean;
  readonly footprint: readonly Outline[];
  readonly lures: Lures;
}

/** The attractors of the last gesture in a course. */
const known = new WeakMap<Scene, Known>();

/** The attractors in a course: all things except the moved ones, and the arena. */
export function luresOf(scene: Scene, selection: Selection, footprint: readonly Outline[]): Lures {
  const moved = freeObjects(scene, selection);
  const { robot } = selection;
  const before = known.get(scene);
  if (before?.footprint === footprint && before.robot === robot && areSame(before.moved, moved)) return before.lures;
  const lures = findLures(scene, moved, robot ? null : frameOfRobot(scene, footprint));
  known.set(scene, { moved, robot, footprint, lures });
  return lures;
}

const areSame = (some: readonly SceneObject[], others: readonly SceneObject[]): boolean =>
  some.length === others.length && some.every((object, index) => object === others[index]);

function findLures(scene: Scene, moved: readonly SceneObject[], robot: Frame | null): Lures {
  const gone = new Set(moved);
  const others = scene.objects.filter((object) => !gone.has(object));
  const frames = [...others.map(frameOf), ...(robot === null ? [] : [robot])];
  const arena = frameOfArena(scene.size);
  const [x, y] = axes.map(([axis]) => alongAxis([...frames, arena], axis)) as [AxisLures, AxisLures];
  return { x, y, frames, arena, ends: others.flatMap((object) => endsOf(object) ?? []) };
}

function alongAxis(frames: readonly Frame[], axis: Axis): AxisLures {
  const ascending = (lures: readonly Lure[]): readonly Lure[] => [...lures].sort((one, two) => one.atMm - two.atMm);
  return {
    edges: ascending(frames.flatMap((of) => [of[axis].min, of[axis].max].map((atMm) => ({ atMm, of })))),
    middles: ascending(frames.map((of) => ({ atMm: of[axis].mid, of }))),
  };
}

/** The lures that lie within reach of a place, in ascending order. */
export function luresNear(lures: readonly Lure[], atMm: number, reachMm: number): readonly Lure[] {
  const first = firstFrom(lures, atMm - reachMm);
  let end = first;
  while (end < lures.length && (lures[end]?.atMm ?? Infinity) <= atMm + reachMm) end += 1;
  return lures.slice(first, end);
}

/** The index of the first lure at a place or beyond. */
function firstFrom(lures: readonly Lure[], atMm: number): number {
  let low = 0;
  let high = lures.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((lures[middle]?.atMm ?? Infinity) < atMm) low = middle + 1;
    else high = middle;
  }
  return low;
}
