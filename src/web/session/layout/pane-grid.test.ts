import { describe, expect, it } from 'vitest';

import { gridOf, limitsOf, withDeviceRow, withLargeArena, withRoomForPanel } from './pane-grid';

const all = { code: true, board: true, arena: true, console: true };
const room = { widthPx: 1424, heightPx: 900 };
const sizes = { code: 420, board: 256, console: 186, top: 0, below: 208, isConsoleFolded: false };

/** Rows of names, as `grid-template-areas` has them. */
const rowsOf = (areas: string): string[][] => [...areas.matchAll(/'([^']+)'/g)].map(([, row]) => row!.split(' '));

describe('the grid of the panes', () => {
  it('gives the arena the full height on a wide screen, and puts the console below code and board', () => {
    const grid = gridOf('wide', all, sizes, room);
    expect(grid.columns).toBe('420px 8px 256px 8px minmax(0, 1fr)');
    expect(grid.rows).toBe('minmax(0, 1fr) 8px 186px');
    expect(rowsOf(grid.areas)).toEqual([
      ['code', 's-code', 'board', 's-board', 'arena'],
      ['s-console', 's-console', 's-console', 's-board', 'arena'],
      ['console', 'console', 'console', 's-board', 'arena'],
    ]);
    expect(grid.splitters.map((splitter) => splitter.id)).toEqual(['code', 'board', 'console']);
  });

  it('puts code, board and console below each other beside the arena on a smaller screen', () => {
    const grid = gridOf('medium', all, sizes, { widthPx: 1008, heightPx: 768 });
    expect(grid.columns).toBe('420px 8px minmax(0, 1fr)');
    expect(grid.rows).toBe('minmax(0, 1fr) 8px 208px 8px 186px');
    expect(rowsOf(grid.areas).map(([left]) => left)).toEqual(['code', 's-below', 'board', 's-console', 'console']);
    expect(rowsOf(grid.areas).every(([, bar, right]) => bar === 's-code' && right === 'arena')).toBe(true);
  });

  it('has the row of devices above what is written and read; beside it the arena keeps its full height', () => {
    const wide = withDeviceRow(gridOf('wide', all, sizes, room));
    expect(wide.rows).toBe('var(--device-row) 8px minmax(0, 1fr) 8px 186px');
    expect(rowsOf(wide.areas).slice(0, 3)).toEqual([
      ['devices', 'devices', 'devices', 's-board', 'arena'],
      ['.', '.', '.', 's-board', 'arena'],
      ['code', 's-code', 'board', 's-board', 'arena'],
    ]);
    const medium = withDeviceRow(gridOf('medium', all, sizes, { widthPx: 1008, heightPx: 768 }));
    expect(rowsOf(medium.areas)[0]).toEqual(['devices', 's-code', 'arena']);
    const narrow = withDeviceRow(gridOf('narrow', all, sizes, { widthPx: 800, heightPx: 1100 }));
    expect(new Set(rowsOf(narrow.areas)[0])).toEqual(new Set(['devices']));
    const phone = withDeviceRow(gridOf('phone', { ...all, code: false }, sizes, { widthPx: 390, heightPx: 800 }));
    expect(rowsOf(phone.areas)).toEqual([['devices'], ['.'], ['board']]);
  });

  it('leaves the program 160 px in a low window, whatever the board would like to have', () => {
    const low = { widthPx: 1084, heightPx: 600 };
    const tall = withRoomForPanel({ ...sizes, isConsoleFolded: true }, true);
    const [, , boardPx] = gridOf('medium', all, tall, low).rows.replace('minmax(0, 1fr)', 'rest').split(' ');
    expect(low.heightPx - 76 - 56 - 8 - parseInt(boardPx ?? '', 10)).toBeGreaterThanOrEqual(160);
  });

  it.each(['wide', 'medium', 'narrow'] as const)(
    'shows the head alone of a folded console, without a bar (%s)',
    (kind) => {
      const grid = gridOf(kind, all, { ...sizes, isConsoleFolded: true }, room);
      expect(grid.rows.endsWith(' 8px 48px')).toBe(true);
      expect(grid.splitters.map(({ id }) => id)).not.toContain('console');
    },
  );

  it('gives two thirds of the width to an arena that is to be watched, or of the height where panes are stacked', () => {
    const widthPx = 1350;
    const [codePx] = gridOf('wide', { ...all, board: false }, withLargeArena(sizes, { widthPx, heightPx: 768 }), {
      widthPx,
      heightPx: 768,
    }).columns.split(' ');
    expect((widthPx - 8 - parseInt(codePx ?? '', 10)) / widthPx).toBeCloseTo(2 / 3, 1);
    const upright = { widthPx: 820, heightPx: 1180 };
    const rows = gridOf('narrow', all, { ...withLargeArena(sizes, upright), isConsoleFolded: true }, upright).rows;
    expect((1180 - 76 - parseInt(rows, 10) - 64) / (1180 - 76)).toBeCloseTo(2 / 3, 1);
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

  it('gives code and board more height on a tablet held upright while something is unfolded, as far as the arena keeps its share', () => {
    const upright = { widthPx: 820, heightPx: 1180 };
    const rows = (top: number, isUnfolded: boolean): string =>
      gridOf('narrow', all, withRoomForPanel({ ...sizes, top }, isUnfolded), upright).rows;
    expect(rows(0, true).startsWith('442px ')).toBe(true);
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
