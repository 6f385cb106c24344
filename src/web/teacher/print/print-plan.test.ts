import { describe, expect, it } from 'vitest';
import { MOST_SHEETS, planPrint, smallestSheet, tileName, type Paper, type PrintPlan } from './print-plan';

function plan(size: readonly [number, number], paper: Paper): PrintPlan {
  const found = planPrint(size, paper);
  if ('problem' in found) throw new Error(found.problem);
  return found;
}

describe('a course on sheets', () => {
  it('takes 25 sheets of A4 across for 120 × 90 cm, which is fewer than upright', () => {
    // Across a sheet shows 277 × 190 mm, 10 mm of it twice: 5 × 5. Upright it would be 7 × 4 = 28.
    const { page, columns, rows, tiles } = plan([1200, 900], 'a4-tiles');
    expect(page).toEqual([297, 210]);
    expect([columns, rows, tiles.length]).toEqual([5, 5, 25]);
    expect(tiles.map(({ name }) => name).slice(0, 6)).toEqual(['A1', 'B1', 'C1', 'D1', 'E1', 'A2']);
  });

  it('covers the whole arena, each tile beginning 10 mm before its neighbour ends', () => {
    for (const size of [
      [1200, 900],
      [200, 200],
      [277, 190],
      [278, 191],
      [1189, 3000],
      [2500, 2500],
    ] as const) {
      const { tiles, columns, rows } = plan(size, 'a4-tiles');
      for (const { column, row, upperLeft, size: shown } of tiles) {
        const right = tiles.find((tile) => tile.column === column + 1 && tile.row === row);
        const below = tiles.find((tile) => tile.column === column && tile.row === row + 1);
        if (right) expect(upperLeft[0] + shown[0] - right.upperLeft[0]).toBe(10);
        else expect(upperLeft[0] + shown[0]).toBe(size[0]);
        if (below) expect(below.upperLeft[1] - (upperLeft[1] - shown[1])).toBe(10);
        else expect(upperLeft[1] - shown[1]).toBe(0);
        expect(Math.min(...shown)).toBeGreaterThan(10);
      }
      expect(tiles.length).toBe(columns * rows);
    }
  });

  it('says how many sheets a 10 m arena would take instead of making them', () => {
    expect(planPrint([10_000, 10_000], 'a4-tiles')).toEqual({ problem: 'too-many-sheets', sheets: 2128 });
    const largest = planPrint([10_000, 10_000], 'a3-tiles');
    expect('sheets' in largest && largest.sheets > MOST_SHEETS).toBe(true);
  });

  it('fits on one sheet when there is room for the margin as well', () => {
    expect(plan([1169, 821], 'a0').page).toEqual([1189, 841]);
    expect(plan([821, 1169], 'a0').page).toEqual([841, 1189]);
    expect(planPrint([1200, 900], 'a0')).toEqual({ problem: 'too-large-for-paper' });
    expect(smallestSheet([400, 277])).toBe('a3');
    expect(smallestSheet([401, 277])).toBe('a2');
    expect(smallestSheet([1200, 900])).toBe('exact');
  });

  it('has a sheet of its own size up to what a PDF can hold: 5.08 m', () => {
    expect(plan([1200, 900], 'exact')).toMatchObject({ page: [1220, 920], columns: 1, rows: 1 });
    expect(plan([5060, 900], 'exact').page[0]).toBe(5080);
    expect(planPrint([5061, 900], 'exact')).toEqual({ problem: 'too-large-for-paper' });
  });

  it('counts its columns in letters as a spreadsheet does', () => {
    expect([0, 25, 26, 51, 52, 701, 702].map((column) => tileName(column, 0))).toEqual([
      ...['A1', 'Z1', 'AA1', 'AZ1', 'BA1', 'ZZ1', 'AAA1'],
    ]);
  });
});
