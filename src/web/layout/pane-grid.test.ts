import { describe, expect, it } from 'vitest';

import { gridOf, limitsOf, withRoomForPanel } from './pane-grid';

const all = { code: true, board: true, arena: true, console: true };
const room = { widthPx: 1424, heightPx: 900 };
const sizes = { code: 420, board: 256, console: 212, top: 0 };

describe('the grid of the panes', () => {
  it('puts code, board and arena side by side above the console on a wide screen', () => {
    const grid = gridOf('wide', all, sizes, room);
    expect(grid.columns).toBe('420px 8px 256px 8px minmax(0, 1fr)');
    expect(grid.rows).toBe('minmax(0, 1fr) 8px 212px');
    expect(grid.splitters.map((splitter) => splitter.id)).toEqual(['code', 'board', 'console']);
  });

  it('gives the room of a hidden arena to the program', () => {
    const grid = gridOf('wide', { ...all, arena: false }, sizes, room);
    expect(grid.columns).toBe('minmax(0, 1fr) 8px 256px');
    expect(grid.areas.startsWith("'code s-board board'")).toBe(true);
  });

  it('shows the program alone when board and arena are hidden', () => {
    expect(gridOf('wide', { ...all, arena: false, board: false }, sizes, room).columns).toBe('minmax(0, 1fr)');
  });

  it('stacks on a tablet held upright: code and board, arena, console', () => {
    const grid = gridOf('narrow', all, { ...sizes, code: 0, board: 264 }, { widthPx: 820, heightPx: 1180 });
    expect(grid.areas).toContain("'code s-board board' 's-top s-top s-top' 'arena arena arena'");
  });

  it('gives code and board 460 px on a tablet held upright while something is unfolded, unless a height was chosen', () => {
    const upright = { widthPx: 820, heightPx: 1180 };
    const rows = (top: number, isUnfolded: boolean): string =>
      gridOf('narrow', all, withRoomForPanel({ ...sizes, top }, isUnfolded), upright).rows;
    expect(rows(0, true).startsWith('460px ')).toBe(true);
    expect(rows(0, false).startsWith('minmax(0, 0.8fr) ')).toBe(true);
    expect(rows(300, true).startsWith('300px ')).toBe(true);
  });

  it('shows one pane on a phone', () => {
    const grid = gridOf('phone', { code: false, board: false, arena: true, console: false }, sizes, room);
    expect(grid.areas).toBe("'arena'");
    expect(grid.splitters).toEqual([]);
  });

  it('never lets a remembered size push another pane out of a smaller window', () => {
    const small = { widthPx: 1010, heightPx: 600 };
    const grid = gridOf('medium', all, { ...sizes, code: 3000, console: 3000 }, small);
    expect(grid.columns.startsWith(`${limitsOf('code', small).maxPx}px`)).toBe(true);
    expect(limitsOf('code', small).maxPx).toBeLessThan(600);
  });

  it.each(['wide', 'narrow'] as const)('names as many columns and rows as it lays out (%s)', (kind) => {
    for (const shown of [
      all,
      { ...all, board: false },
      { ...all, arena: false },
      { ...all, board: false, arena: false },
    ]) {
      const grid = gridOf(kind, shown, sizes, room);
      const count = (tracks: string): number => tracks.replaceAll(/\([^)]*\)/g, '').split(' ').length;
      const areas = [...grid.areas.matchAll(/'([^']*)'/g)].map((match) => match[1]!.split(' '));
      expect(areas).toHaveLength(count(grid.rows));
      for (const row of areas) expect(row).toHaveLength(count(grid.columns));
      for (const { id } of grid.splitters) expect(grid.areas).toContain(`s-${id}`);
    }
  });
});

describe('the grid of the panes that a host shows', () => {
  const panes = ['code', 'board', 'arena', 'console'] as const;
  const none = { code: false, board: false, arena: false, console: false };
  const subsets = Array.from({ length: 15 }, (_, index) =>
    Object.fromEntries(panes.map((pane, place) => [pane, ((index + 1) & (1 << place)) !== 0])),
  ) as unknown as (typeof none)[];

  /** Rows of names, as `grid-template-areas` has them. */
  const rowsOf = (areas: string): string[][] => [...areas.matchAll(/'([^']+)'/g)].map(([, row]) => row!.split(' '));
  /** Sizes of a track list; `minmax(0, 1fr)` is one. */
  const tracksOf = (list: string): string[] => list.match(/minmax\([^)]*\)|\S+/g) ?? [];

  it.each(['wide', 'medium', 'narrow'] as const)(
    'has each of them in one place, and one that takes the rest: %s',
    (kind) => {
      for (const shown of subsets) {
        const { areas, columns, rows, splitters } = gridOf(kind, shown, sizes, room);
        const cells = rowsOf(areas);
        expect(cells.length, areas).toBe(tracksOf(rows).length);
        for (const row of cells) expect(row.length, areas).toBe(tracksOf(columns).length);
        for (const pane of panes) expect(cells.flat().includes(pane), `${pane} in ${areas}`).toBe(shown[pane]);
        for (const { id } of splitters) expect(cells.flat(), areas).toContain(`s-${id}`);
        for (const bar of cells.flat().filter((name) => name.startsWith('s-')))
          expect(splitters.map(({ id }) => `s-${id}`)).toContain(bar);
        expect(columns, areas).toContain('fr)');
        expect(rows, areas).toContain('fr)');
      }
    },
  );

  it('is the whole window for one pane alone', () => {
    for (const kind of ['wide', 'narrow', 'phone'] as const) {
      const grid = gridOf(kind, { ...none, arena: true }, sizes, room);
      expect(grid).toEqual({ columns: 'minmax(0, 1fr)', rows: 'minmax(0, 1fr)', areas: "'arena'", splitters: [] });
    }
  });

  it('puts the board beside the arena, which has the rest', () => {
    const grid = gridOf('wide', { ...none, board: true, arena: true }, sizes, room);
    expect(grid.columns).toBe('256px 8px minmax(0, 1fr)');
    expect(grid.areas).toBe("'board s-board arena'");
    expect(grid.splitters).toEqual([{ id: 'board', axis: 'x', sign: 1, sizePx: 256 }]);
  });
});
