import { escaped } from '#check/report/escaped';
import type { SweepResult, SweepRun } from '../sweep-texts';
import { curveScale } from './curve-scale';

/** A drawing in its own pixels: the curve, below it the lane of those that have no figure. */
const [WIDE, HIGH, LANE] = [800, 300, 34] as const;
const [LEFT, RIGHT, TOP, FOOT] = [64, 16, 24, 30] as const;
/** Room for the signs above and below the curve. */
const GAP = 12;

/** Most points that get a sign of their own. Chosen: beyond it they would touch each other. */
const MOST_SIGNS = 200;

/** The measure that the curve shows, with its unit. */
interface Measure {
  readonly title: string;
  readonly of: (run: SweepRun) => number | null;
}

/** The curve of one thing that varies over a measure: passed as rings on it, the others as crosses in a lane below. */
export function curveOf({ varied: [name = ''], runs }: SweepResult, { title, of }: Measure): string {
  const points = runs.map((run, place) => ({ run, x: at(run, place), figure: figureOf(run, of) }));
  const xs = curveScale(
    points.map(({ x }) => x),
    LEFT,
    WIDE - RIGHT,
  );
  const figures = points.flatMap(({ figure }) => (figure === null ? [] : [figure]));
  const ys = curveScale(figures, HIGH - LANE - GAP, TOP + GAP);
  const hasLane = figures.length < points.length;
  const size = points.length > MOST_SIGNS ? 2 : 5;
  const marks = points.map(({ x, figure, run }) =>
    figure === null ? cross(xs(x), HIGH - LANE / 2, size) : ring(xs(x), ys(figure), size, run),
  );
  const [low, high] = [figures.reduce(least, Infinity), figures.reduce(most, -Infinity)];
  const lines = stretchesOf(points).map((stretch) => {
    const places = stretch.map(({ x, figure }) => `${xs(x)},${ys(figure)}`);
    return `<polyline class="curve" points="${places.join(' ')}"/>`;
  });
  return `<svg viewBox="0 0 ${WIDE} ${HIGH + FOOT}" role="img" aria-label="${escaped(`${name}: ${title}`)}">
${hasLane ? `<rect class="lane" x="${LEFT}" y="${HIGH - LANE}" width="${WIDE - LEFT - RIGHT}" height="${LANE}"/>` : ''}
<path class="axis" d="M${LEFT} ${TOP}V${HIGH}H${WIDE - RIGHT}"/>
${figures.length === 0 ? '' : `<text x="${LEFT - 8}" y="${ys(high) + 5}" text-anchor="end">${shownNumber(high)}</text>`}
${low < high ? `<text x="${LEFT - 8}" y="${ys(low) + 5}" text-anchor="end">${shownNumber(low)}</text>` : ''}
<text x="${LEFT}" y="${TOP - 8}">${escaped(title)}</text>
<text x="${LEFT}" y="${HIGH + 20}">${escaped(String(runs[0]?.values[0] ?? ''))}</text>
<text x="${(LEFT + WIDE - RIGHT) / 2}" y="${HIGH + 20}" text-anchor="middle">${escaped(name)}</text>
<text x="${WIDE - RIGHT}" y="${HIGH + 20}" text-anchor="end">${escaped(String(runs.at(-1)?.values[0] ?? ''))}</text>
${lines.join('\n')}
${marks.join('\n')}
</svg>`;
}

/** The place of a run on the axis: its number, or for choices its place in their order. */
const at = ({ values: [value] }: SweepRun, place: number): number => (typeof value === 'number' ? value : place);

/** A run that has not passed has no time to the goal. */
const figureOf = (run: SweepRun, of: Measure['of']): number | null => (run.passed === false ? null : of(run));

/** A number in up to one digit after the point. */
const shownNumber = (value: number): string => String(Math.round(value * 10) / 10);

const least = (one: number, other: number): number => Math.min(one, other);
const most = (one: number, other: number): number => Math.max(one, other);

/** The stretches of the curve between runs that have no figure. */
function stretchesOf(
  points: readonly { readonly x: number; readonly figure: number | null }[],
): readonly (readonly { readonly x: number; readonly figure: number }[])[] {
  const stretches: { readonly x: number; readonly figure: number }[][] = [[]];
  for (const { x, figure } of points) {
    if (figure === null) stretches.push([]);
    else stretches.at(-1)?.push({ x, figure });
  }
  return stretches.filter(({ length }) => length > 1);
}

const ring = (x: number, y: number, size: number, { passed }: SweepRun): string =>
  `<circle class="${passed === null ? 'dot' : 'ring'}" cx="${x}" cy="${y}" r="${size}"/>`;

const cross = (x: number, y: number, size: number): string =>
  `<path class="cross" d="M${x - size} ${y - size}l${2 * size} ${2 * size}m0 ${-2 * size}l${-2 * size} ${2 * size}"/>`;

/** The map of two things that vary: a square for each pair, with sign and ground. */
export function mapOf({ varied: [rowName = '', columnName = ''], runs }: SweepResult): string {
  const rows = distinct(runs.map(({ values }) => values[0]));
  const columns = distinct(runs.map(({ values }) => values[1]));
  const size = Math.max(4, Math.min(40, (WIDE - LEFT - RIGHT) / columns.length));
  const [high, wide] = [rows.length * size, columns.length * size];
  const squares = runs.map(({ values: [row, column], passed, reason }) => {
    const [x, y] = [LEFT + columns.indexOf(column) * size, TOP + rows.indexOf(row) * size];
    const [ground, sign] = passed === true ? ['good', '✓'] : passed === false || reason !== null ? ['bad', '✗'] : ['', '·']; // prettier-ignore
    const text = size < 14 ? '' : `<text class="sign-${passed === true ? 'yes' : 'no'}" x="${x + size / 2}" y="${y + size / 2 + 5}" text-anchor="middle">${sign}</text>`; // prettier-ignore
    return `<rect class="${ground === '' ? 'axis' : ground}" x="${x}" y="${y}" width="${size - 1}" height="${size - 1}"/>${text}`;
  });
  const text = (x: number, y: number, said: unknown, side = 'start'): string =>
    `<text x="${x}" y="${y}" text-anchor="${side}">${escaped(String(said))}</text>`;
  return `<svg viewBox="0 0 ${WIDE} ${TOP + high + 40}" role="img" aria-label="${escaped(`${rowName} × ${columnName}`)}">
${squares.join('\n')}
${text(LEFT - 6, TOP + 14, rows[0] ?? '', 'end')}
${rows.length > 1 ? text(LEFT - 6, TOP + high - 4, rows.at(-1) ?? '', 'end') : ''}
${text(LEFT, TOP + high + 16, columns[0] ?? '')}
${columns.length > 1 ? text(LEFT + wide, TOP + high + 16, columns.at(-1) ?? '', 'end') : ''}
${text(LEFT, TOP + high + 34, `↓ ${rowName}   → ${columnName}`)}
</svg>`;
}

const distinct = <T>(values: readonly T[]): readonly T[] => [...new Set(values)];
