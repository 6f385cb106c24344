import { nameOrder } from '#check/report/names';
import type { WorldResult } from '#check/result';

import type { Row } from '../model/class-model';
import { stateOf, timeOf, worldsPassed, type RowState } from '../model/rows-in-order';

/** The names that the wall shows: of those who have passed, all, or none. A card without a name has a number. */
export const namings = ['passed', 'all', 'none'] as const;
export type Naming = (typeof namings)[number];

/** The orders of cards: as they came, by name, the fastest first. */
export const wallOrders = ['came', 'name', 'fastest'] as const;
export type WallOrder = (typeof wallOrders)[number];

/** A hand-in as the class may see it. */
export interface WallCard {
  /** `null`: it is shown by its number. */
  readonly name: string | null;
  readonly number: number;
  readonly state: RowState;
  /** The visible world, in which its way is shown; `null`: it was not run. */
  readonly world: WorldResult | null;
  /** Simulated ms until it had passed; `null`: it has not. */
  readonly passedMs: number | null;
  readonly points: number;
  readonly stars: number | null;
  readonly worlds: { readonly passed: number; readonly of: number };
}

/**
 * Numbers for hand-ins, drawn by lot: a class's list is in the order of its names, and a number by that order would be
 * nearly a name.
 */
export class Lots {
  private readonly drawn = new Map<string, number>();

  /** @param random from 0 up to 1 */
  constructor(private readonly random: () => number = Math.random) {}

  /** The numbers of these names, and of all before; a number once drawn stays. */
  of(names: readonly string[]): ReadonlyMap<string, number> {
    const waiting = names.filter((name) => !this.drawn.has(name));
    while (waiting.length > 0) {
      const [name] = waiting.splice(Math.floor(this.random() * waiting.length), 1);
      if (name !== undefined) this.drawn.set(name, this.drawn.size + 1);
    }
    return this.drawn;
  }
}

interface Wishes {
  readonly naming: Naming;
  readonly order: WallOrder;
  readonly language: string;
}

/**
 * The cards of a wall. In the order `fastest` the times come first; otherwise, and at equal times, cards without a name
 * stand last, by their numbers: their place says nothing of whose they are.
 */
export function wallCards(rows: readonly Row[], lots: Lots, { naming, order, language }: Wishes): readonly WallCard[] {
  const numbers = lots.of(rows.map(({ name }) => name));
  const compare = nameOrder(language);
  return rows
    .map((row) => cardOf(row, numbers.get(row.name) ?? 0, naming))
    .toSorted((one, other) => {
      const fastest = order === 'fastest' ? keyOf(one.passedMs) - keyOf(other.passedMs) : 0;
      if (fastest !== 0) return fastest;
      if (one.name === null || other.name === null)
        return Number(one.name === null) - Number(other.name === null) || one.number - other.number;
      return order === 'came' ? 0 : compare(one.name, other.name);
    });
}

/** The sort key of a time: hand-ins that have not passed are last and equal. */
const keyOf = (ms: number | null): number => ms ?? Number.MAX_SAFE_INTEGER;

function cardOf(row: Row, number: number, naming: Naming): WallCard {
  const state = stateOf(row);
  const isNamed = naming === 'all' || (naming === 'passed' && state === 'passed');
  const { result } = row;
  return {
    ...{ name: isNamed ? row.shown : null, number, state },
    world: result?.worlds[0] ?? null,
    passedMs: state === 'passed' ? timeOf(row) : null,
    points: result?.points ?? 0,
    stars: result?.stars ?? null,
    worlds: { passed: worldsPassed(row), of: result?.worlds.length ?? 0 },
  };
}

/** A size on the screen, in px. */
export interface Size {
  readonly width: number;
  readonly height: number;
}

/** Gap between two cards. */
export const GAP_PX = 8;

/** Chosen: below this a name cannot be read from the last row, nor a way be made out. Then the wall scrolls. */
const SMALLEST: Size = { width: 140, height: 96 };

/** The layout of the cards. */
export interface WallGrid {
  readonly columns: number;
  /** Height of a row, in px. */
  readonly rowPx: number;
  /** Size of a card's name, in px: it grows with the card. */
  readonly namePx: number;
}

/**
 * The layout in which cards get their largest drawings. Where they would be too low, there are as many columns as the
 * least width allows, and the wall is longer than its area.
 *
 * @param aspect width of a course by its height
 */
export function gridFor(count: number, area: Size, aspect: number): WallGrid {
  const most = Math.max(1, Math.floor((area.width + GAP_PX) / (SMALLEST.width + GAP_PX)));
  let best: { readonly grid: WallGrid; readonly drawingPx: number } | null = null;
  for (let columns = 1; columns <= Math.min(count, most); columns += 1) {
    const width = shareOf(area.width, columns);
    const rowPx = Math.floor(shareOf(area.height, Math.ceil(count / columns)));
    const drawingPx = Math.min(width, (rowPx - wordsPx(width)) * aspect);
    if (rowPx >= SMALLEST.height && (best === null || drawingPx > best.drawingPx))
      best = { grid: { columns, rowPx, namePx: namePx(width) }, drawingPx };
  }
  if (best !== null) return best.grid;
  const width = shareOf(area.width, most);
  return { columns: most, rowPx: Math.round(width / aspect + wordsPx(width)), namePx: namePx(width) };
}

const shareOf = (px: number, count: number): number => (px - GAP_PX * (count - 1)) / count;

const namePx = (cardWidth: number): number => Math.round(Math.min(30, Math.max(15, cardWidth / 12)));

/** Height of a card's two lines. */
const wordsPx = (cardWidth: number): number => 12 + 2.4 * namePx(cardWidth);
