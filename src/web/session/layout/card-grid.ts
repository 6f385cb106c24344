import type { CardForm, LayoutKind, PaneSizes } from './layout-model';
import {
  BARS_PX,
  consoleRow,
  fitting,
  FOLDED_PX,
  GAP,
  gridOf,
  LEAST,
  REST,
  topBeside,
  type PaneGrid,
  type Room,
  type Rows,
  type Shown,
} from './pane-grid';

/** Height of a card's title line with the frame around it, and of the small board: high below the card of a wide window, else a row. */
const TITLE_PX = 54;
const SMALL_PX = { high: 146, row: 84 } as const;
/** Height that the program keeps beside a long card, where that leaves the card the second one. Chosen by eye. */
const PROGRAM_PX = 220;
const CARD_PX = 150;
/** From this height of the room on, the small board below the card is high. */
const HIGH_PX = 690;
/** Share of the height for program and card where the arena lies below them. Chosen by eye. */
const TOP_SHARE = 0.355;

/**
 * The panes with the card beside the program. While it is open the board is small, below it; as a title line it leaves
 * the board its place. Where program or arena is missing the card stands before the others.
 */
export function cardGrid(kind: LayoutKind, shown: Shown, wished: PaneSizes, room: Room, card: CardForm): PaneGrid {
  if (kind === 'phone') return gridOf(kind, shown, wished, room);
  if (kind === 'narrow') return stacked(shown, wished, room, card);
  if (!shown.code || !shown.arena) return before(gridOf(kind, shown, wished, room), card);
  return kind === 'wide' ? inThree(shown, wished, room, card) : inTwo(shown, wished, room, card);
}

/** Program, card with the board below it, arena; the console below the first two. */
function inThree(shown: Shown, wished: PaneSizes, room: Room, card: CardForm): PaneGrid {
  const fit = fitting(wished, room);
  const smallPx = room.heightPx >= HIGH_PX ? SMALL_PX.high : SMALL_PX.row;
  const isOpen = card === 'open';
  const rows = [isOpen ? REST : `${TITLE_PX}px`];
  const middle = ['card'];
  if (shown.board || !isOpen) {
    rows.push(GAP, isOpen ? `${smallPx}px` : REST);
    middle.push('.', shown.board ? 'board' : '.');
  }
  const below = consoleOf(shown, wished, room);
  const line = (code: string, area: string): string =>
    `'${code} ${code === 'code' ? 's-code' : code} ${area} s-board arena'`;
  return {
    columns: `${fit('code')}px ${GAP} ${fit('board')}px ${GAP} ${REST}`,
    rows: [...rows, ...below.rows].join(' '),
    areas: [...middle.map((area) => line('code', area)), ...below.areas.map((area) => line(area, area))].join(' '),
    splitters: [
      { id: 'code', axis: 'x', sign: 1, sizePx: fit('code') },
      { id: 'board', axis: 'x', sign: 1, sizePx: fit('board') },
      ...below.splitters,
    ],
  };
}

/** Card, program, board and console below each other, the arena at the full height beside them. */
function inTwo(shown: Shown, wished: PaneSizes, room: Room, card: CardForm): PaneGrid {
  const fit = fitting(wished, room);
  const below = consoleOf(shown, wished, room);
  const consolePx = shown.console ? (wished.isConsoleFolded ? FOLDED_PX : fit('console')) + 8 : 0;
  const allPx = room.heightPx - BARS_PX - consolePx - 8;
  const freePx = allPx - Math.max(LEAST.top, Math.min(PROGRAM_PX, allPx - CARD_PX - SMALL_PX.row - 8));
  const isOpen = card === 'open';
  const boardPx = isOpen ? SMALL_PX.row : Math.max(LEAST.below, Math.min(fit('below'), freePx - TITLE_PX - 8));
  const cardPx = Math.max(TITLE_PX, freePx - (shown.board ? boardPx + 8 : 0));
  const board: Rows = {
    rows: [GAP, `${boardPx}px`],
    areas: [isOpen ? '.' : 's-below', 'board'],
    splitters: isOpen ? [] : [{ id: 'below', axis: 'y', sign: -1, sizePx: boardPx }],
  };
  const parts: readonly Rows[] = [
    // As high as its text, as long as the program keeps some lines.
    { rows: [isOpen ? `fit-content(${cardPx}px)` : `${TITLE_PX}px`, GAP], areas: ['card', '.'], splitters: [] },
    { rows: [REST], areas: ['code'], splitters: [] },
    ...(shown.board ? [board] : []),
    below,
  ];
  return {
    columns: `${fit('code')}px ${GAP} ${REST}`,
    rows: parts.flatMap(({ rows }) => rows).join(' '),
    areas: parts.flatMap(({ areas }) => areas.map((area) => `'${area} s-code arena'`)).join(' '),
    splitters: [
      { id: 'code', axis: 'x', sign: 1, sizePx: fit('code') },
      ...parts.flatMap(({ splitters }) => splitters),
    ],
  };
}

/** Program and card on top, the arena below in full width, then console and small board side by side. */
function stacked(shown: Shown, wished: PaneSizes, room: Room, card: CardForm): PaneGrid {
  const fit = fitting(wished, room);
  const isOpen = card === 'open';
  const consolePx = !shown.console ? 0 : wished.isConsoleFolded ? FOLDED_PX : fit('console');
  const isBoardBelow = shown.board && isOpen;
  const lastPx = Math.max(consolePx, isBoardBelow ? SMALL_PX.row : 0);
  const suggestedPx = Math.round(TOP_SHARE * (room.heightPx - BARS_PX - lastPx));
  const topPx = topBeside(wished.top === 0 ? suggestedPx : fit('top'), lastPx + 8, room);
  const first = shown.code ? 'code' : null;
  const line = (left: string, between: string, right: string): string =>
    first === null ? `'${right}'` : `'${left} ${between} ${right}'`;
  const top = (area: string): string => line('code', 's-board', area);
  const across = (area: string): string => line(area, area, area);
  const topRow = (px: number): string => (shown.arena ? `${px}px` : REST);
  const rows = isOpen ? [topRow(topPx)] : [`${TITLE_PX}px`, GAP, topRow(topPx - TITLE_PX - 8)];
  const areas = isOpen ? [top('card')] : [top('card'), top('.'), top(shown.board ? 'board' : '.')];
  if (shown.arena) {
    rows.push(GAP, REST);
    areas.push(across('s-top'), across('arena'));
  }
  const hasBar = shown.console && !wished.isConsoleFolded;
  if (lastPx > 0) {
    rows.push(GAP, `${lastPx}px`);
    const [left, right] = [shown.console ? 'console' : 'board', isBoardBelow ? 'board' : 'console'];
    areas.push(across(hasBar ? 's-console' : '.'), line(left, left === right ? left : '.', right));
  }
  return {
    columns: first === null ? REST : `${REST} ${GAP} ${fit('board')}px`,
    rows: rows.join(' '),
    areas: areas.join(' '),
    splitters: [
      ...(first === null ? [] : [{ id: 'board', axis: 'x', sign: -1, sizePx: fit('board') } as const]),
      ...(shown.arena ? [{ id: 'top', axis: 'y', sign: 1, sizePx: topPx } as const] : []),
      ...(hasBar ? [{ id: 'console', axis: 'y', sign: -1, sizePx: lastPx } as const] : []),
    ],
  };
}

/** A grid with a column of its own for the card before the others. */
function before({ columns, rows, areas, splitters }: PaneGrid, card: CardForm): PaneGrid {
  const lines = areas.match(/[^']*[^' ][^']*/g) ?? [];
  if (card === 'folded')
    return {
      columns,
      rows: `${TITLE_PX}px ${GAP} ${rows}`,
      areas: [
        ...['card', '.'].map(
          (name) =>
            `'${(lines[0] ?? '')
              .split(' ')
              .map(() => name)
              .join(' ')}'`,
        ),
        areas,
      ].join(' '),
      splitters,
    };
  return {
    columns: `300px ${GAP} ${columns}`,
    rows,
    areas: lines.map((line) => `'card . ${line}'`).join(' '),
    splitters,
  };
}

const consoleOf = (shown: Shown, wished: PaneSizes, room: Room): Rows =>
  shown.console ? consoleRow(wished, fitting(wished, room)) : { rows: [], areas: [], splitters: [] };
