import type { LayoutKind, Pane, PaneSizes } from './layout-model';

/** The bars between panes, by the size they set. */
export type SplitterId = 'code' | 'board' | 'console' | 'top' | 'below';

/** The grid of the panes in CSS's words, and its splitters. */
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

export const GAP = '8px';
/** Least sizes that are still of use, in px. */
export const LEAST = { code: 220, board: 180, console: 96, top: 160, below: 132, arena: 240 } as const;
/** Height of a folded console: its head and the frame around it. */
export const FOLDED_PX = 48;
/** The arena's share of the window while it is being watched. */
const WATCHED = 2 / 3;
/** Height of code and board, stacked, while something is unfolded below the board: room for the drawing and the dials, and for an arena in which a robot is seen. Chosen by eye. */
const TOP_UNFOLDED_PX = 460;
export const BARS_PX = 60 + 8 + 8;
/** Share of the height that an arena below the program keeps: its course is 420 px wide on a tablet held upright. */
const ARENA_SHARE = 0.39;

/** Height of what lies above a stacked arena, which keeps its share where that leaves the program some lines. */
export const topBeside = (wishedPx: number, belowPx: number, { heightPx }: Room): number =>
  Math.max(LEAST.top, Math.min(wishedPx, heightPx - BARS_PX - 8 - belowPx - Math.round(ARENA_SHARE * heightPx)));

/** Height of the board below the program while something is unfolded in it. Chosen by eye. */
const BELOW_UNFOLDED_PX = 330;

/**
 * The wished sizes, with more height for the board if something is unfolded below it: `top` if no height was set,
 * `below` at least `BELOW_UNFOLDED_PX`.
 */
export function withRoomForPanel(wished: PaneSizes, isUnfolded: boolean): PaneSizes {
  if (!isUnfolded) return wished;
  const top = wished.top === 0 ? TOP_UNFOLDED_PX : wished.top;
  return { ...wished, top, below: Math.max(wished.below, BELOW_UNFOLDED_PX) };
}

/** The sizes with which the arena has two thirds of the window: of its width, or of its height where panes are stacked. */
export function withLargeArena(wished: PaneSizes, { widthPx, heightPx }: Room): PaneSizes {
  const left = (px: number): number => Math.round(px * (1 - WATCHED));
  return { ...wished, code: left(widthPx) - 16, top: Math.max(LEAST.top, left(heightPx - BARS_PX) - FOLDED_PX - 16) };
}

/** The wished sizes, within their limits. */
export const fitting =
  (wished: PaneSizes, room: Room): Fit =>
  (id) => {
    const { minPx, maxPx } = limitsOf(id, room);
    return Math.max(minPx, Math.min(maxPx, wished[id]));
  };

/** The limits within which a splitter can size its pane in this room. */
export function limitsOf(id: SplitterId, { widthPx, heightPx }: Room): { minPx: number; maxPx: number } {
  const minPx = LEAST[id];
  const most = {
    code: widthPx - LEAST.board - LEAST.arena - 32,
    board: Math.min(640, widthPx - LEAST.code - 24),
    console: heightPx - BARS_PX - LEAST.top - 16,
    top: heightPx - BARS_PX - LEAST.console - LEAST.arena - 32,
    below: heightPx - BARS_PX - LEAST.console - LEAST.top - 16,
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
  const fit = fitting(wished, room);
  if (kind === 'narrow') return stacked(shown, wished, room, fit);
  if (!shown.code || !shown.arena) return inRow(shown, wished, fit);
  return kind === 'wide' ? beside(shown, wished, fit) : inColumn(shown, wished, room, fit);
}

/** The grid with the row of devices on top; an arena at the full height stays beside it. */
export function withDeviceRow({ columns, rows, areas, splitters }: PaneGrid): PaneGrid {
  const lines = areas.match(/[^']*[^' ][^']*/g)?.map((line) => line.split(' ')) ?? [];
  const isBeside = lines.length > 0 && lines.every((line) => line.length > 2 && line.at(-1) === 'arena');
  const line = (name: string): string =>
    `'${(lines[0] ?? []).map((area, at, all) => (isBeside && at >= all.length - 2 ? area : name)).join(' ')}'`;
  return {
    columns,
    rows: `var(--device-row) ${GAP} ${rows}`,
    areas: `${line('devices')} ${line('.')} ${areas}`,
    splitters,
  };
}

/** The track that takes the remaining room. */
export const REST = 'minmax(0, 1fr)';

type Columns = Pick<PaneGrid, 'columns' | 'splitters'> & { readonly areas: readonly string[] };

/** Panes side by side. The arena, or else the first pane, has the rest of the room, the others their chosen size. */
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

export type Shown = Readonly<Record<Pane, boolean>>;
export type Fit = (id: SplitterId) => number;
export type Rows = Pick<PaneGrid, 'splitters'> & {
  readonly rows: readonly string[];
  readonly areas: readonly string[];
};

/** The row of the console and the bar above it; folded it is as high as its head, and has no bar. */
export function consoleRow({ isConsoleFolded }: PaneSizes, fit: Fit): Rows {
  if (isConsoleFolded) return { rows: [GAP, `${FOLDED_PX}px`], areas: ['.', 'console'], splitters: [] };
  const sizePx = fit('console');
  return {
    rows: [GAP, `${sizePx}px`],
    areas: ['s-console', 'console'],
    splitters: [{ id: 'console', axis: 'y', sign: -1, sizePx }],
  };
}

/** Code and board side by side with the console below them, the arena at the full height beside. */
function beside(shown: Shown, wished: PaneSizes, fit: Fit): PaneGrid {
  const { columns, areas, splitters } = columnsOf(
    (['code', 'board', 'arena'] as const).filter((pane) => shown[pane]),
    fit,
  );
  const row = (place: (area: string) => string): string => `'${areas.map(place).join(' ')}'`;
  const below = shown.console ? consoleRow(wished, fit) : { rows: [], areas: [], splitters: [] };
  const isRight = areas.length - 2; // the arena, and the bar before it
  const line = (name: string): string => `'${areas.map((area, at) => (at >= isRight ? area : name)).join(' ')}'`;
  return {
    columns,
    rows: [REST, ...below.rows].join(' '),
    areas: [row((area) => area), ...below.areas.map(line)].join(' '),
    splitters: [...splitters, ...below.splitters],
  };
}

/** Code, board and console below each other, the arena at the full height beside them. */
function inColumn(shown: Shown, wished: PaneSizes, room: Room, fit: Fit): PaneGrid {
  const codePx = fit('code');
  const below = shown.console ? consoleRow(wished, fit) : { rows: [], areas: [], splitters: [] };
  const consolePx = shown.console ? (wished.isConsoleFolded ? FOLDED_PX : fit('console')) + 8 : 0;
  // The program keeps some lines, whatever the board would like to have.
  const boardPx = Math.max(LEAST.below, Math.min(fit('below'), room.heightPx - BARS_PX - consolePx - LEAST.top - 8));
  const board: Rows = {
    rows: [GAP, `${boardPx}px`],
    areas: ['s-below', 'board'],
    splitters: [{ id: 'below', axis: 'y', sign: -1, sizePx: boardPx }],
  };
  const parts = [{ rows: [REST], areas: ['code'], splitters: [] }, ...(shown.board ? [board] : []), below];
  return {
    columns: `${codePx}px ${GAP} ${REST}`,
    rows: parts.flatMap(({ rows }) => rows).join(' '),
    areas: parts.flatMap(({ areas }) => areas.map((area) => `'${area} s-code arena'`)).join(' '),
    splitters: [{ id: 'code', axis: 'x', sign: 1, sizePx: codePx }, ...parts.flatMap(({ splitters }) => splitters)],
  };
}

/** Panes side by side, the console below them all. */
function inRow(shown: Shown, wished: PaneSizes, fit: Fit): PaneGrid {
  const panes = (['code', 'board', 'arena'] as const).filter((pane) => shown[pane]);
  const { columns, areas, splitters } = columnsOf(panes, fit);
  const below = shown.console ? consoleRow(wished, fit) : { rows: [], areas: [], splitters: [] };
  return {
    columns,
    rows: [REST, ...below.rows].join(' '),
    areas: [`'${areas.join(' ')}'`, ...below.areas.map((name) => `'${areas.map(() => name).join(' ')}'`)].join(' '),
    splitters: [...splitters, ...below.splitters],
  };
}

/** Code and board on top, the arena below in full width, then the console. */
function stacked(shown: Shown, wished: PaneSizes, room: Room, fit: Fit): PaneGrid {
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
      const consolePx = shown.console ? (wished.isConsoleFolded ? FOLDED_PX : fit('console')) + 8 : 0;
      const topPx = topBeside(fit('top'), consolePx, room);
      rows[0] = wished.top === 0 ? 'minmax(0, 0.8fr)' : `${topPx}px`;
      splitters.push({ id: 'top', axis: 'y', sign: 1, sizePx: topPx });
      add(GAP, across('s-top'));
    }
    add(REST, across('arena'));
  }
  if (shown.console) {
    const below = consoleRow(wished, fit);
    for (const [at, row] of below.rows.entries()) add(row, across(below.areas[at] ?? '.'));
    splitters.push(...below.splitters);
  }
  return { columns: top.columns || REST, rows: rows.join(' '), areas: areas.join(' '), splitters };
}
