import type { ArenaMode } from '../mode/mode-model';
import type { LayoutKind, Pane, PaneSizes } from './layout-model';
import { gridOf, type PaneGrid, type Room } from './pane-grid';

type Shown = Readonly<Record<Pane, boolean>>;

/** Width of the bench of tools, in px. */
const BENCH_PX = { wide: 324, medium: 304 } as const;
/** Least width of the program while somebody looks back, in px: lines of a pupil's program fit into it. */
const PAST_CODE_PX = 400;

/** True where the tools have a bench in the place of the program; elsewhere they lie below the arena. */
export const hasBench = (mode: ArenaMode, kind: LayoutKind, { arena }: Pick<Shown, 'arena'>): boolean =>
  mode === 'build' && arena && (kind === 'wide' || kind === 'medium');

/** The panes' grid in a mode. */
export function gridOfMode(mode: ArenaMode, kind: LayoutKind, shown: Shown, wished: PaneSizes, room: Room): PaneGrid {
  if (hasBench(mode, kind, shown)) return benchGrid(kind === 'wide' ? BENCH_PX.wide : BENCH_PX.medium);
  if (mode !== 'lookBack' || !shown.code || !shown.arena) return gridOf(kind, shown, wished, room);
  return gridOf(kind, shown, { ...wished, code: Math.max(wished.code, PAST_CODE_PX) }, room);
}

/** The bench and the arena beside it, at the full height. */
const benchGrid = (widthPx: number): PaneGrid => ({
  columns: `${widthPx}px 8px minmax(0, 1fr)`,
  rows: 'minmax(0, 1fr)',
  areas: "'bench . arena'",
  splitters: [],
});
