import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';

import type { Points, Series } from '../series/series';
import { valueAt } from '../series/series';
import type { Look } from './looks';
import type { Span } from './span';

/** A curve as it is drawn. */
export interface Curve {
  readonly series: Series;
  readonly points: Points;
  readonly look: Look;
}

/** The format of the numbers beside the axes. */
export interface AxisTexts {
  readonly across: (value: number, step: number) => string;
  readonly up: (value: number, step: number) => string;
}

const FONT = '12px Roboto, "Segoe UI", sans-serif';
/** An axis at the right; its lines would cross those of the left one. */
const AT_RIGHT = { side: 1, grid: { show: false } };
/** Room for the numbers, in px. */
const BELOW = 24;
const BESIDE = 52;

/** Draws curves on a canvas and marks a time over them. */
export class ChartPlot {
  private plot: uPlot | null = null;
  private curves: readonly Curve[] = [];
  /** The fixed properties of the plot: changing one makes it again. */
  private made = '';
  private span: Span = [0, 1];
  private at: number | null = null;
  private readonly line = document.createElement('div');
  private marks: readonly SVGElement[] = [];

  constructor(
    private readonly host: HTMLElement,
    private readonly texts: AxisTexts,
  ) {
    this.line.className = 'at-line';
  }

  /** Draws curves over a stretch. They have two units at most: the first at the left, the other at the right. */
  draw(curves: readonly Curve[], span: Span): void {
    const [widthPx, heightPx] = [this.host.clientWidth, this.host.clientHeight];
    if (widthPx < 60 || heightPx < 40) return;
    this.curves = curves;
    this.span = span;
    const kind = JSON.stringify([
      curves.map(({ series, look }) => [series.id, series.unit, look.colour]),
      this.colours(),
    ]);
    const data = dataOf(curves);
    if (this.plot === null || kind !== this.made) {
      this.end();
      this.made = kind;
      this.plot = new uPlot(this.options(widthPx, heightPx), data, this.host);
      this.addMarks(this.plot);
    } else {
      const { plot } = this;
      if (plot.width !== widthPx || plot.height !== heightPx) plot.setSize({ width: widthPx, height: heightPx });
      plot.batch(() => {
        plot.setData(data, false);
        plot.setScale('x', { min: span[0], max: span[1] });
      });
    }
    this.placeMarks();
  }

  /** Marks a time; `null`: none. */
  mark(at: number | null): void {
    this.at = at;
    this.placeMarks();
  }

  /**
   * The value on the horizontal axis at a place of the window, kept within the plot; `null` before anything is drawn.
   */
  acrossAt(clientX: number): number | null {
    if (this.plot === null) return null;
    const box = this.plot.over.getBoundingClientRect();
    return this.plot.posToVal(Math.min(Math.max(clientX - box.left, 0), box.width), 'x');
  }

  /** The area of the curves; `null` before anything is drawn. */
  get area(): HTMLElement | null {
    return this.plot?.over ?? null;
  }

  get canvas(): HTMLCanvasElement | null {
    return this.plot?.ctx.canvas ?? null;
  }

  end(): void {
    this.plot?.destroy();
    this.plot = null;
    this.marks = [];
  }

  private colours(): readonly string[] {
    const style = getComputedStyle(this.host);
    return ['--text-2', '--line', ...this.curves.map(({ look }) => look.colour)].map((name) =>
      style.getPropertyValue(name).trim(),
    );
  }

  private options(width: number, height: number): uPlot.Options {
    const [ink = '', grid = '', ...colours] = this.colours();
    const units = unitsOf(this.curves);
    const axis = (more: uPlot.Axis): uPlot.Axis => ({
      ...{
        stroke: ink,
        font: FONT,
        gap: 4,
        grid: { stroke: grid, width: 1 },
        ticks: { stroke: grid, width: 1, size: 4 },
      },
      ...more,
    });
    return {
      ...{ width, height, pxAlign: true, legend: { show: false } },
      padding: [10, units.length > 1 ? 0 : 14, 0, 0],
      cursor: { show: false, drag: { x: false, y: false } },
      scales: {
        x: { time: false, auto: false, range: () => [this.span[0], this.span[1]] },
        ...Object.fromEntries(units.map((unit, side) => [scaleOf(side), { range: rangeFor(unit) }])),
      },
      axes: [
        axis({ size: BELOW, space: 70, values: (_, splits) => numbers(splits, this.texts.across) }),
        ...units.map((unit, side) =>
          axis({
            ...{
              scale: scaleOf(side),
              size: BESIDE,
              space: (_plot: uPlot, _axis: number, _min: number, _max: number, px: number) => Math.max(26, px / 9),
            },
            ...(side === 1 && AT_RIGHT),
            values: (_: uPlot, splits: number[]) => withUnit(numbers(splits, this.texts.up), unit),
          }),
        ),
      ],
      series: [
        {},
        ...this.curves.map(({ series, look }, place): uPlot.Series => {
          const stroke = colours[place] ?? ink;
          return {
            ...{ scale: scaleOf(units.indexOf(series.unit)), stroke, width: 2, dash: [...look.dash] },
            ...(series.isStepped && uPlot.paths.stepped && { paths: uPlot.paths.stepped({ align: 1 }) }),
            points: { size: 8, width: 0, fill: stroke, paths: pointPaths(look) },
          };
        }),
      ],
    };
  }

  private addMarks(plot: uPlot): void {
    plot.over.append(this.line);
    this.marks = this.curves.map(({ look }) => {
      const svg = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
      svg.setAttribute('class', 'at-mark');
      svg.setAttribute('viewBox', '-8 -8 16 16');
      svg.style.setProperty('--curve', `var(${look.colour})`);
      const path = document.createElementNS('http://www.w3.org/2000/svg', 'path');
      path.setAttribute('d', look.point);
      svg.append(path);
      plot.over.append(svg);
      return svg;
    });
  }

  private placeMarks(): void {
    const { plot, at } = this;
    if (plot === null) return;
    const isSeen = at !== null && at >= this.span[0] && at <= this.span[1];
    this.line.hidden = !isSeen;
    const left = isSeen ? plot.valToPos(at, 'x') : 0;
    this.line.style.transform = `translateX(${left}px)`;
    const units = unitsOf(this.curves);
    for (const [place, mark] of this.marks.entries()) {
      const curve = this.curves[place];
      const value = isSeen && curve ? valueAt(curve.points, at) : null;
      mark.style.display = value === null ? 'none' : '';
      if (value === null || curve === undefined) continue;
      const top = plot.valToPos(value, scaleOf(units.indexOf(curve.series.unit)));
      mark.style.transform = `translate(${left}px, ${top}px)`;
    }
  }
}

const scaleOf = (side: number): string => (side === 1 ? 'right' : 'left');

/** The units of curves, in their order. */
export const unitsOf = (curves: readonly { readonly series: Series }[]): readonly string[] => [
  ...new Set(curves.map(({ series }) => series.unit)),
];

/** One row of times for all curves; where a curve has no value at the time of another one, it goes on. */
function dataOf(curves: readonly Curve[]): uPlot.AlignedData {
  if (curves.length === 0) return [[], []];
  return uPlot.join(curves.map(({ points }) => [points.timesS as number[], points.values as (number | null)[]]));
}

/** The range of an axis: values that are on or off fill the height, all others are scaled. */
const rangeFor =
  (unit: string): uPlot.Range.Function =>
  (_, min, max) => {
    if (unit === '0/1') return [-0.1, 1.15];
    if ((min as number | null) === null || (max as number | null) === null) return [0, 1];
    return uPlot.rangeNum(min, max, 0.1, true);
  };

function numbers(splits: readonly number[], text: (value: number, step: number) => string): string[] {
  const step = Math.abs((splits[1] ?? 1) - (splits[0] ?? 0));
  return splits.map((value) => text(value, step));
}

/** The uppermost number has the unit. */
const withUnit = (texts: string[], unit: string): string[] =>
  unit === '' || unit === '0/1'
    ? texts
    : texts.map((text, place) => (place === texts.length - 1 ? `${text} ${unit}` : text));

/** Draws the points of a curve where they are far enough apart to be seen. */
const pointPaths =
  (look: Look): uPlot.Series.Points.PathBuilder =>
  (plot, place, from, to, few) => {
    const { scale = 'left' } = plot.series[place] ?? {};
    const outline = new Path2D(look.point);
    const fill = new Path2D();
    const size = uPlot.pxRatio;
    const add = (at: number): void => {
      const value = plot.data[place]?.[at];
      const time = plot.data[0][at];
      if (typeof value !== 'number' || time === undefined) return;
      const [x, y] = [plot.valToPos(time, 'x', true), plot.valToPos(value, scale, true)];
      fill.addPath(outline, new DOMMatrix([size, 0, 0, size, x, y]));
    };
    if (few) few.forEach(add);
    else for (let at = from; at <= to; at++) add(at);
    return { stroke: null, fill, clip: null, flags: 0 };
  };
