import type { Table } from './device-log';
import { isNumber } from './number-in';
import { timeOf } from './time-heading';

/** A reading: across and up. */
export type Point = readonly [x: number, y: number];
/**
 * Readings that belong together, in order. A new line begins after a cell that is not a number, and when the time jumps
 * back.
 */
export type Line = readonly Point[];

/** The horizontal axis: the time in seconds, a column of times without a unit, or the number of the row. */
export type Axis =
  { readonly kind: 'seconds' } | { readonly kind: 'own'; readonly heading: string } | { readonly kind: 'rows' };

/** A column of either table, with the curves of both. */
export interface Chart {
  readonly heading: string;
  readonly device: readonly Line[];
  readonly simulation: readonly Line[];
}

/** Two tables over one axis. */
export interface Comparison {
  readonly axis: Axis;
  /** True if their times are not of one kind, or only one has times: rows are counted instead. */
  readonly isWithoutCommonTime: boolean;
  /** The device's columns first, then those of the simulation alone. */
  readonly charts: readonly Chart[];
}

/** Joins a device's table and that of the simulation: columns of the same name share a chart. */
export function compare(device: Table, simulation: Table): Comparison {
  const axes = [device, simulation].filter(({ rows }) => rows.length > 0).map(axisOf);
  const [first = { kind: 'rows' } as const, second = first] = axes;
  const isSame = first.kind === second.kind;
  const axis: Axis = isSame ? first : { kind: 'rows' };
  const columns = [...new Set([...device.headings, ...simulation.headings])].filter((name) => timeOf(name) === null);
  const charts = columns.map((heading) => ({
    heading,
    device: linesOf(device, heading, axis),
    simulation: linesOf(simulation, heading, axis),
  }));
  return {
    axis,
    isWithoutCommonTime: !isSame,
    charts: charts.filter((chart) => chart.device.length + chart.simulation.length > 0),
  };
}

function axisOf({ headings }: Table): Axis {
  if (headings.some((heading) => typeof timeOf(heading)?.unitS === 'number')) return { kind: 'seconds' };
  const own = headings.find((heading) => timeOf(heading) !== null);
  return own === undefined ? { kind: 'rows' } : { kind: 'own', heading: own };
}

/** The curves of a table, which never changes: only that of a running program is followed by another one. */
const known = new WeakMap<Table, Map<string, readonly Line[]>>();

function linesOf(table: Table, heading: string, axis: Axis): readonly Line[] {
  const curves = known.get(table) ?? new Map<string, readonly Line[]>();
  known.set(table, curves);
  const key = `${axis.kind} ${heading}`;
  const lines = curves.get(key) ?? newLines(table, heading, axis);
  curves.set(key, lines);
  return lines;
}

function newLines(table: Table, heading: string, axis: Axis): readonly Line[] {
  const column = table.headings.indexOf(heading);
  if (column === -1) return [];
  const across = acrossOf(table, axis);
  const lines: Point[][] = [];
  let line: Point[] = [];
  const end = (): void => {
    if (line.length > 0) lines.push(line);
    line = [];
  };
  for (const [number, row] of table.rows.entries()) {
    const cell = row[column] ?? '';
    if (cell === '') continue; // nothing was logged: the line continues
    const x = across(row, number);
    if (x === null || !isNumber(cell)) {
      end();
      continue;
    }
    if (line.length > 0 && x < (line.at(-1)?.[0] ?? x)) end();
    line.push([x, Number(cell)]);
  }
  end();
  return lines;
}

/**
 * Horizontal position of a row. A log whose unit was changed has several columns of times: the one with a value counts.
 */
function acrossOf({ headings }: Table, axis: Axis): (row: readonly string[], number: number) => number | null {
  if (axis.kind === 'rows') return (_row, number) => number + 1;
  const times = headings.flatMap((heading, place) => {
    const time = timeOf(heading);
    const fits = time !== null && (axis.kind === 'own' || time.unitS !== null);
    return fits ? [{ place, factor: time.unitS ?? 1 }] : [];
  });
  return (row) => {
    const time = times.find(({ place }) => isNumber(row[place] ?? ''));
    return time === undefined ? null : Number(row[time.place]) * time.factor;
  };
}

/** The least and the largest x (`which` 0) or y (1) of some lines; `null` without a point. */
export function rangeOf(lines: readonly Line[], which: 0 | 1): readonly [min: number, max: number] | null {
  let min = Infinity;
  let max = -Infinity;
  for (const line of lines)
    for (const point of line) {
      min = Math.min(min, point[which]);
      max = Math.max(max, point[which]);
    }
  return min <= max ? [min, max] : null;
}

/**
 * A line that looks the same with fewer points: of each part of the width its first, least, largest and last.
 *
 * @param parts how many parts may have points of their own: one for each pixel
 */
export function thinned(line: Line, parts: number): Line {
  const range = rangeOf([line], 0);
  if (range === null || line.length <= 4 * parts) return line;
  const width = (range[1] - range[0]) / parts || 1;
  const kept: Point[] = [];
  let from = 0;
  for (let at = 1; at <= line.length; at += 1) {
    const isEnd = at === line.length || partOf(line[at]) !== partOf(line[from]);
    if (!isEnd) continue;
    kept.push(...ends(line.slice(from, at)));
    from = at;
  }
  return kept;

  function partOf(point: Point | undefined): number {
    return Math.min(parts - 1, Math.floor(((point?.[0] ?? 0) - (range?.[0] ?? 0)) / width));
  }
}

/** First, least, largest and last, in their order. */
function ends(line: Line): Line {
  let least = 0;
  let largest = 0;
  for (const [place, [, y]] of line.entries()) {
    if (y < (line[least]?.[1] ?? y)) least = place;
    if (y > (line[largest]?.[1] ?? y)) largest = place;
  }
  const places = new Set([0, least, largest, line.length - 1]);
  return line.filter((_, place) => places.has(place));
}
