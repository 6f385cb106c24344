import type { LayoutKind, Pane, PaneSizes } from './layout-model';

/** The bars between panes, by the size they set. */
export type SplitterId = 'code' | 'board' | 'console' | 'top';

/** The grid of the panes in CSS's words, and where its splitters are. */
export interface PaneGrid {
  readonly columns: string;
  readonly rows: string;
  readonly areas: string;
  readonly splitters: readonly {
    readonly id: SplitterId;
    readonly axis: 'x' | 'y';
    readonly sign: 1 | -1;
    readonly sizePx: number;
  }[];
}

/** The space the panes have, in px. */
export interface Room {
  readonly widthPx: number;
  readonly heightPx: number;
}

const GAP = '8px';
/** Least sizes that are still of use, in px. */
const LEAST = { code: 220, board: 180, console: 96, top: 160, arena: 240 } as const;
/** Height of code and board, stacked, while something is unfolded below the board: room for the drawing and the dials, and for an arena in which a robot is seen. Chosen by eye. */
const TOP_UNFOLDED_PX = 460;
const BARS_PX = 60 + 8 + 8;

/** The wished sizes, with more height for the board if something is unfolded below it and no height was set. */
export function withRoomForPanel(wished: PaneSizes, isUnfolded: boolean): PaneSizes {
  return isUnfolded && wished.top === 0 ? { ...wished, top: TOP_UNFOLDED_PX } : wished;
}

/** How small and how large a splitter lets its pane be in this room. */
export function limitsOf(id: SplitterId, { widthPx, heightPx }: Room): { minPx: number; maxPx: number } {
  const minPx = LEAST[id];
  const most = {
    code: widthPx - LEAST.board - LEAST.arena - 32,
    board: Math.min(640, widthPx - LEAST.code - 24),
    console: heightPx - BARS_PX - LEAST.top - 16,
    top: heightPx - BARS_PX - LEAST.console - LEAST.arena - 32,
  };
  return { minPx, maxPx: Math.max(minPx, most[id]) };
}

/** Lays the shown panes out, whichever they are: a host may show any of them. */
export function gridOf(
  kind: LayoutKind,
  shown: Readonly<Record<Pane, boolean>>,
  wished: PaneSizes,
  room: Room,
): PaneGrid {
  const panes = (['code', 'board', 'arena', 'console'] as const).filter((name) => shown[name]);
  const [only] = panes;
  if (kind === 'phone' || panes.length < 2) {
    return { columns: REST, rows: REST, areas: `'${only ?? 'code'}'`, splitters: [] };
  }
  const fit = (id: SplitterId): number => {
    const { minPx, maxPx } = limitsOf(id, room);
    return Math.max(minPx, Math.min(maxPx, wished[id]));
  };
  return kind === 'narrow' ? stacked(shown, wished, fit) : inRow(shown, fit);
}

/** What takes the room that the others leave. */
const REST = 'minmax(0, 1fr)';

type Columns = Pick<PaneGrid, 'columns' | 'splitters'> & { readonly areas: readonly string[] };

/** Panes side by side. The one that shows most has the rest of the room, the others the size that was chosen. */
function columnsOf(panes: readonly ('code' | 'board' | 'arena')[], fit: (id: SplitterId) => number): Columns {
  const rest = panes.includes('arena') ? 'arena' : panes[0];
  const columns: string[] = [];
  const areas: string[] = [];
  const splitters: PaneGrid['splitters'][number][] = [];
  const add = (area: string, width: string): void => void (columns.push(width), areas.push(area));
  for (const [index, pane] of panes.entries()) {
    const before = panes[index - 1];
    if (before !== undefined) {
      // The bar moves the pane that has a size; one before it grows to the right, one behind it to the left.
      const [id, sign] = before === rest || before === 'arena' ? [pane, -1 as const] : [before, 1 as const];
      if (id !== 'arena') splitters.push({ id, axis: 'x', sign, sizePx: fit(id) });
      add(`s-${id}`, GAP);
    }
    add(pane, pane === rest || pane === 'arena' ? REST : `${fit(pane)}px`);
  }
  return { columns: columns.join(' '), areas, splitters };
}

/** Code, board and arena side by side, the console below them all. */
function inRow(shown: Readonly<Record<Pane, boolean>>, fit: (id: SplitterId) => number): PaneGrid {
  const panes = (['code', 'board', 'arena'] as const).filter((pane) => shown[pane]);
  const { columns, areas, splitters } = columnsOf(panes, fit);
  const row = `'${areas.join(' ')}'`;
  if (!shown.console) return { columns, rows: REST, areas: row, splitters };
  const below = (area: string): string => `'${areas.map(() => area).join(' ')}'`;
  return {
    columns,
    rows: `${REST} ${GAP} ${fit('console')}px`,
    areas: `${row} ${below('s-console')} ${below('console')}`,
    splitters: [...splitters, { id: 'console', axis: 'y', sign: -1, sizePx: fit('console') }],
  };
}

/** Code and board on top, the arena below in full width, then the console. */
function stacked(shown: Readonly<Record<Pane, boolean>>, wished: PaneSizes, fit: (id: SplitterId) => number): PaneGrid {
  const top = columnsOf(
    (['code', 'board'] as const).filter((pane) => shown[pane]),
    fit,
  );
  const splitters = [...top.splitters];
  const rows: string[] = [];
  const areas: string[] = [];
  const across = (area: string): string => `'${(top.areas.length > 0 ? top.areas : ['']).map(() => area).join(' ')}'`;
  const add = (row: string, area: string): void => void (rows.push(row), areas.push(area));
  if (top.areas.length > 0) add(REST, `'${top.areas.join(' ')}'`);
  if (shown.arena) {
    if (rows.length > 0) {
      const topPx = fit('top');
      rows[0] = wished.top === 0 ? 'minmax(0, 0.8fr)' : `${topPx}px`;
      splitters.push({ id: 'top', axis: 'y', sign: 1, sizePx: topPx });
      add(GAP, across('s-top'));
    }
    add(REST, across('arena'));
  }
  if (shown.console) {
    add(GAP, across('s-console'));
    add(`${fit('console')}px`, across('console'));
    splitters.push({ id: 'console', axis: 'y', sign: -1, sizePx: fit('console') });
  }
  return { columns: top.columns || REST, rows: rows.join(' '), areas: areas.join(' '), splitters };
}
