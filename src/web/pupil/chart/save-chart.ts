import type { Curve } from './plot/chart-plot';
import { valueAt } from './series/series';
import type { Span } from './plot/span';

/**
 * The curves within a stretch as a table, one row for each time at which one of them has a value of its own.
 *
 * @param time heading of the column of times, in seconds
 */
export function csvOfCurves(curves: readonly Curve[], [from, to]: Span, time: string): string {
  const times = [...new Set(curves.flatMap(({ points }) => points.timesS))]
    .filter((timeS) => timeS >= from && timeS <= to)
    .sort((one, other) => one - other);
  const own = curves.map(({ points }) => new Map(points.timesS.map((timeS, at) => [timeS, points.values[at] ?? null])));
  const headings = curves.map(({ series: { name, unit } }) =>
    unit === '' || unit === '0/1' ? name : `${name} (${unit})`,
  );
  const rows = times.map((timeS) => [timeS, ...own.map((values) => values.get(timeS) ?? null)]);
  return [
    [`${time} (s)`, ...headings].map(cell),
    ...rows.map((row) => row.map((value) => (value === null ? '' : plain(value)))),
  ]
    .map((cells) => `${cells.join(',')}\n`)
    .join('');
}

const cell = (text: string): string => (/[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
/** Six decimals are finer than anything that is measured. */
const plain = (value: number): string => String(Math.round(value * 1e6) / 1e6);

/** Rows with a time in s and the value of each curve then, at even intervals of a stretch: for screen readers. */
export function sampledRows(
  curves: readonly Curve[],
  [from, to]: Span,
  rows: number,
): readonly (readonly (number | null)[])[] {
  return Array.from({ length: rows }, (_, row) => {
    const timeS = from + ((to - from) * row) / Math.max(1, rows - 1);
    return [timeS, ...curves.map(({ points }) => valueAt(points, timeS))];
  });
}

/** The least and the largest value of a curve within a stretch; `null` if it has none there. */
export function rangeWithin({ points }: Curve, [from, to]: Span): readonly [min: number, max: number] | null {
  let [min, max] = [Infinity, -Infinity];
  for (const [at, timeS] of points.timesS.entries()) {
    const value = points.values[at];
    if (timeS < from || timeS > to || typeof value !== 'number') continue;
    min = Math.min(min, value);
    max = Math.max(max, value);
  }
  return min <= max ? [min, max] : null;
}

/**
 * The chart as a picture, with the names of the curves above it.
 *
 * @param names of the curves, each with its curve for its look
 */
export function pictureOf(
  canvas: HTMLCanvasElement,
  names: readonly { readonly text: string; readonly curve: Curve }[],
  style: CSSStyleDeclaration,
): Promise<Blob | null> {
  const scale = canvas.width / Math.max(1, canvas.clientWidth);
  const head = 30 * scale;
  const picture = document.createElement('canvas');
  picture.width = canvas.width;
  picture.height = canvas.height + head;
  const to = picture.getContext('2d');
  if (to === null) return Promise.resolve(null);
  const colour = (name: string): string => style.getPropertyValue(name).trim();
  to.fillStyle = colour('--surface');
  to.fillRect(0, 0, picture.width, picture.height);
  to.drawImage(canvas, 0, head);
  to.scale(scale, scale);
  to.font = '600 13px Roboto, "Segoe UI", sans-serif';
  to.textBaseline = 'middle';
  let x = 12;
  for (const { text, curve } of names) {
    to.strokeStyle = to.fillStyle = colour(curve.look.colour);
    to.lineWidth = 2;
    to.setLineDash([...curve.look.dash]);
    to.beginPath();
    to.moveTo(x, 16);
    to.lineTo(x + 28, 16);
    to.stroke();
    to.save();
    to.translate(x + 14, 16);
    to.fill(new Path2D(curve.look.point));
    to.restore();
    to.fillStyle = colour('--text');
    to.fillText(text, x + 34, 16);
    x += 54 + to.measureText(text).width;
  }
  return new Promise((resolve) => picture.toBlob(resolve, 'image/png'));
}
