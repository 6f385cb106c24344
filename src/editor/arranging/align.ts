import type { SceneEdit } from '#scene/edit';
import type { Bounds, Outline } from '#scene/outline';
import type { Scene } from '#scene/scene';
import { movingSelection } from '../arrange';
import { boundsAll } from '../bounds';
import { combined } from '../edits';
import { boundsOfSelection, freeObjects, only, takenBy } from '../selection';
import type { Selection } from '../tools/tool';

/**
 * The line on which things are aligned: one of their edges, or their middles, on an upright line (`upright`) or a
 * level one (`level`).
 */
export type Alignment = 'left' | 'upright' | 'right' | 'top' | 'level' | 'bottom';

/** Something that moves as a whole: a thing, a group that is selected altogether, the robot. */
interface Unit {
  readonly selection: Selection;
  readonly around: Bounds;
}

/** Brings all that is selected onto the same line; `null` when it is there already, or is one thing alone. */
export function aligned(
  scene: Scene,
  selection: Selection,
  to: Alignment,
  footprint: readonly Outline[] = [],
): SceneEdit | null {
  const units = unitsOf(scene, selection, footprint);
  const around = boundsAll(units.map((unit) => unit.around));
  if (!around || units.length < 2) return null;
  return movedApart(scene, footprint, units, (unit) => stepTo(to, unit.around, around));
}

function stepTo(to: Alignment, unit: Bounds, all: Bounds): { readonly x: number; readonly y: number } {
  switch (to) {
    case 'left':
      return { x: all.minX - unit.minX, y: 0 };
    case 'right':
      return { x: all.maxX - unit.maxX, y: 0 };
    case 'upright':
      return { x: (all.minX + all.maxX - unit.minX - unit.maxX) / 2, y: 0 };
    case 'top':
      return { x: 0, y: all.maxY - unit.maxY };
    case 'bottom':
      return { x: 0, y: all.minY - unit.minY };
    case 'level':
      return { x: 0, y: (all.minY + all.maxY - unit.minY - unit.maxY) / 2 };
    default:
      return to satisfies never;
  }
}

/** Leaves the same gap between all that is selected; the outermost stay. `null`: fewer than three, or nothing moves. */
export function distributed(
  scene: Scene,
  selection: Selection,
  axis: 'x' | 'y',
  footprint: readonly Outline[] = [],
): SceneEdit | null {
  const edges = ({ around }: Unit): readonly [number, number] =>
    axis === 'x' ? [around.minX, around.maxX] : [around.minY, around.maxY];
  const middle = (unit: Unit): number => edges(unit)[0] + edges(unit)[1];
  const units = unitsOf(scene, selection, footprint).toSorted((a, b) => middle(a) - middle(b));
  const [first, last] = [units[0], units.at(-1)];
  if (!first || !last || units.length < 3) return null;
  const lengths = units.map((unit) => edges(unit)[1] - edges(unit)[0]);
  const taken = lengths.reduce((sum, length) => sum + length, 0);
  const gap = (edges(last)[1] - edges(first)[0] - taken) / (units.length - 1);
  const starts = new Map<Unit, number>();
  let next = edges(first)[0];
  for (const [index, unit] of units.entries()) {
    starts.set(unit, next);
    next += (lengths[index] ?? 0) + gap;
  }
  return movedApart(scene, footprint, units, (unit) => {
    const step = (starts.get(unit) ?? 0) - edges(unit)[0];
    return axis === 'x' ? { x: step, y: 0 } : { x: 0, y: step };
  });
}

const movedApart = (
  scene: Scene,
  footprint: readonly Outline[],
  units: readonly Unit[],
  step: (unit: Unit) => { readonly x: number; readonly y: number },
): SceneEdit | null => combined(units.map((unit) => movingSelection(scene, unit.selection, step(unit), footprint)));

function unitsOf(scene: Scene, selection: Selection, footprint: readonly Outline[]): readonly Unit[] {
  const units: Unit[] = [];
  const done = new Set<string>();
  for (const { id } of freeObjects(scene, selection)) {
    if (done.has(id)) continue;
    const unit = takenBy(scene, id, selection);
    const around = boundsOfSelection(scene, unit);
    if (around) units.push({ selection: unit, around });
    for (const member of unit.ids) done.add(member);
  }
  const robot = selection.robot ? boundsOfSelection(scene, only(null), footprint) : null;
  return robot ? [...units, { selection: only(null), around: robot }] : units;
}
