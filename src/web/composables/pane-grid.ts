import type { LayoutKind, Pane, PaneSizes } from './use-layout';

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
/** Height of code and board, stacked, while something is unfolded below the board: room for the drawing and the dials. */
const TOP_UNFOLDED_PX = 540;
const BARS_PX = 60 + 8 + 8;

/** The wished sizes, with more height for the board where something is unfolded below it and nobody set a height. */
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

/** Lays the shown panes out. */
export function gridOf(
  kind: LayoutKind,
  shown: Readonly<Record<Pane, boolean>>,
  wished: PaneSizes,
  room: Room,
): PaneGrid {
  if (kind === 'phone') {
    const pane = (['code', 'board', 'arena', 'console'] as const).find((name) => shown[name]) ?? 'code';
    return { columns: 'minmax(0, 1fr)', rows: 'minmax(0, 1fr)', areas: `'${pane}'`, splitters: [] };
  }
  const fit = (id: SplitterId): number => {
    const { minPx, maxPx } = limitsOf(id, room);
    return Math.max(minPx, Math.min(maxPx, wished[id]));
  };
  return kind === 'narrow' ? stacked(shown, wished, fit) : inRow(shown, fit);
}

/** Code, board and arena side by side, the console below them all. */
function inRow(shown: Readonly<Record<Pane, boolean>>, fit: (id: SplitterId) => number): PaneGrid {
  const columns: string[] = [];
  const areas: string[] = [];
  const splitters: PaneGrid['splitters'][number][] = [];
  const add = (area: string, width: string): void => void (columns.push(width), areas.push(area));
  const rest = 'minmax(0, 1fr)';
  const codeEnds = shown.board || shown.arena;
  const codeSizes = shown.arena;
  add('code', codeSizes ? `${fit('code')}px` : rest);
  if (codeEnds) {
    add(codeSizes ? 's-code' : 's-board', GAP);
    if (codeSizes) splitters.push({ id: 'code', axis: 'x', sign: 1, sizePx: fit('code') });
  }
  if (shown.board) {
    add('board', `${fit('board')}px`);
    splitters.push({ id: 'board', axis: 'x', sign: shown.arena ? 1 : -1, sizePx: fit('board') });
    if (shown.arena) add('s-board', GAP);
  }
  if (shown.arena) add('arena', rest);
  splitters.push({ id: 'console', axis: 'y', sign: -1, sizePx: fit('console') });
  const below = (area: string): string => `'${areas.map(() => area).join(' ')}'`;
  return {
    columns: columns.join(' '),
    rows: `${rest} ${GAP} ${fit('console')}px`,
    areas: `'${areas.join(' ')}' ${below('s-console')} ${below('console')}`,
    splitters,
  };
}

/** Code and board on top, the arena below in full width, then the console. */
function stacked(shown: Readonly<Record<Pane, boolean>>, wished: PaneSizes, fit: (id: SplitterId) => number): PaneGrid {
  const splitters: PaneGrid['splitters'][number][] = [];
  const rest = 'minmax(0, 1fr)';
  const across = (area: string): string => (shown.board ? `'${area} ${area} ${area}'` : `'${area}'`);
  if (shown.board) splitters.push({ id: 'board', axis: 'x', sign: -1, sizePx: fit('board') });
  const rows: string[] = [];
  const areas: string[] = [shown.board ? `'code s-board board'` : `'code'`];
  if (shown.arena) {
    const topPx = fit('top');
    rows.push(wished.top === 0 ? 'minmax(0, 0.8fr)' : `${topPx}px`, GAP, rest, GAP);
    areas.push(across('s-top'), across('arena'));
    splitters.push({ id: 'top', axis: 'y', sign: 1, sizePx: topPx });
  } else {
    rows.push(rest, GAP);
  }
  rows.push(`${fit('console')}px`);
  areas.push(across('s-console'), across('console'));
  splitters.push({ id: 'console', axis: 'y', sign: -1, sizePx: fit('console') });
  return {
    columns: shown.board ? `${rest} ${GAP} ${fit('board')}px` : rest,
    rows: rows.join(' '),
    areas: areas.join(' '),
    splitters,
  };
}
