import { describe, expect, it } from 'vitest';

import { cardGrid } from './card-grid';
import type { LayoutKind } from './layout-model';

const all = { code: true, board: true, arena: true, console: true };
const wished = { code: 344, board: 268, console: 186, top: 0, below: 208, isConsoleFolded: true };
const laptop = { widthPx: 1350, heightPx: 617 };
const tablet = { widthPx: 804, heightPx: 1172 };

/** Rows of names, as `grid-template-areas` has them. */
const rowsOf = (areas: string): string[][] => [...areas.matchAll(/'([^']+)'/g)].map(([, row]) => row!.split(' '));
const columnOf = (areas: string, at: number): (string | undefined)[] => rowsOf(areas).map((row) => row.at(at));

describe('the panes with a card', () => {
  it('have it between program and arena on a wide screen, the small board below it', () => {
    const open = cardGrid('wide', all, wished, laptop, 'open');
    expect(open.columns).toBe('344px 8px 268px 8px minmax(0, 1fr)');
    expect(open.rows).toBe('minmax(0, 1fr) 8px 84px 8px 48px');
    expect(columnOf(open.areas, 2)).toEqual(['card', '.', 'board', '.', 'console']);
    expect(columnOf(open.areas, -1).every((area) => area === 'arena')).toBe(true);
    expect(open.splitters.map(({ id }) => id)).toEqual(['code', 'board']);
    expect(cardGrid('wide', all, wished, { ...laptop, heightPx: 760 }, 'open').rows).toContain('146px');
  });

  it('leave the board its whole column below the title line', () => {
    const folded = cardGrid('wide', all, wished, laptop, 'folded');
    expect(folded.rows).toBe('54px 8px minmax(0, 1fr) 8px 48px');
    expect(columnOf(folded.areas, 2)).toEqual(['card', '.', 'board', '.', 'console']);
  });

  it('have the card as high as its text above the program on a smaller screen, which keeps 220 px', () => {
    const grid = cardGrid('medium', all, wished, { widthPx: 1164, heightPx: 812 }, 'open');
    expect(columnOf(grid.areas, 0)).toEqual(['card', '.', 'code', '.', 'board', '.', 'console']);
    const [, cardPx] = /fit-content\((\d+)px\)/.exec(grid.rows) ?? [];
    expect(812 - 76 - 56 - 92 - 8 - Number(cardPx)).toBe(220);
  });

  it('leave the card its text where the console takes much room', () => {
    const room = { widthPx: 1008, heightPx: 600 };
    const grid = cardGrid('medium', all, { ...wished, console: 162, isConsoleFolded: false }, room, 'open');
    expect(grid.rows).toContain('fit-content(94px)'); // with 160 px for the program
  });

  it('have program and card above the arena on a tablet held upright, console and board below it', () => {
    const grid = cardGrid('narrow', all, wished, tablet, 'open');
    expect(rowsOf(grid.areas)).toEqual([
      ['code', 's-board', 'card'],
      ['s-top', 's-top', 's-top'],
      ['arena', 'arena', 'arena'],
      ['.', '.', '.'],
      ['console', '.', 'board'],
    ]);
    const folded = cardGrid('narrow', all, wished, tablet, 'folded');
    expect(columnOf(folded.areas, 2)).toEqual(['card', '.', 'board', 's-top', 'arena', '.', 'console']);
  });

  it('stand before those that a host shows without the program', () => {
    const shown = { ...all, code: false, console: false };
    expect(rowsOf(cardGrid('wide', shown, wished, laptop, 'open').areas)).toEqual([
      ['card', '.', 'board', 's-board', 'arena'],
    ]);
    expect(columnOf(cardGrid('wide', shown, wished, laptop, 'folded').areas, 0)).toEqual(['card', '.', 'board']);
  });

  it.each(['wide', 'medium', 'narrow'] as const)(
    'name as many columns and rows as they lay out (%s)',
    (kind: LayoutKind) => {
      for (const card of ['open', 'folded'] as const)
        for (const board of [true, false])
          for (const console of [true, false])
            for (const isConsoleFolded of [true, false]) {
              const sizes = { ...wished, isConsoleFolded };
              const { columns, rows, areas } = cardGrid(kind, { ...all, board, console }, sizes, laptop, card);
              const tracks = (list: string): number => list.replaceAll('minmax(0, 1fr)', 'rest').split(' ').length;
              expect(rowsOf(areas)).toHaveLength(tracks(rows));
              for (const row of rowsOf(areas)) expect(row).toHaveLength(tracks(columns));
            }
    },
  );
});
