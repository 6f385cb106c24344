import { degOf } from '#core/angle';
import type { Pose, Vec } from '#core/geometry';
import { courseShapes } from '#picture/course';
import { PRINT_PX, type Look } from '#picture/look';
import { SVG_FONT, svgOf, type ToPicture } from '#picture/svg';
import { element, escapeXml, figure, pathThrough } from '#picture/svg-write';
import type { Point, Scene } from '#scene/scene';

import { gridSteps } from '../../pupil/arena/picture/draw-floor';
import { rulerLabels, rulerTicks } from '../../pupil/arena/picture/draw-rulers';
import { lightPalette as colors } from '../../pupil/arena/model/palette';
import { readRobotDrawing } from '../../pupil/arena/robot/robot-drawing';
import { shownLanguage } from '../../kit/i18n';
import { numberText } from '../../kit/i18n/number-text';
import { RIM_SHARE } from './shapes/rim-share';
import { taskSvg, type PictureTask } from './task/svg-task';

/** Additions to the course in its picture. */
export interface PictureOptions {
  readonly grid: boolean;
  readonly rulers: boolean;
  /** The robot's pose, and the text of its robot.svg; `null`: no robot. */
  readonly robot: { readonly pose: Pose; readonly scale: number; readonly drawing: string } | null;
  /** The robot's trails; empty: none is drawn. */
  readonly path: readonly (readonly Vec[])[];
  /** Address of the background's picture, or `null` if there is none, or if the caller paints it. */
  readonly background: string | null;
  /** Without it the floor is transparent. */
  readonly floor: boolean;
  /** No sign of a zone and no name of a start is set in smaller type, in mm of the arena; left out: all as it is. */
  readonly leastTypeMm?: number;
  /** The task below the arena, or beside a high one; `null`: it is not shown. */
  readonly task: PictureTask | null;
}

/** A picture and its extent in mm: that of the arena with what stands around it, and of the task. */
export interface CoursePicture {
  readonly svg: string;
  readonly size: Point;
  /** Its extent without the task. */
  readonly alone: Point;
  /** Place of the arena's upper left corner in it. */
  readonly corner: Point;
}

/** Room for the rulers, in parts of the arena's longer side: they grow with the arena, as on a screen. */
const RULER_SHARE = 0.055;

/**
 * Writes a course as an SVG document in true size: its own units are mm. Plain shapes, no scripts, style sheets or
 * links, so that drawing and office programs open it as it is.
 */
export function courseSvg(scene: Scene, options: PictureOptions): CoursePicture {
  const [width, height] = scene.size;
  const unit = Math.max(width, height) / 100;
  const rim = RIM_SHARE * 100 * unit;
  const ruler = options.rulers ? RULER_SHARE * 100 * unit : 0;
  const corner: Point = [ruler + rim, options.rulers ? 2 * unit : rim];
  const alone: Point = [
    corner[0] + width + (options.rulers ? 2 * unit : rim),
    corner[1] + height + Math.max(rim, ruler),
  ];
  const task = options.task === null ? null : taskSvg(options.task, scene.size, corner, alone);
  const size = task?.size ?? alone;
  const to: ToPicture = ([x, y]) => [x, height - y];
  const look: Look = {
    ...{ colors, px: PRINT_PX, leastTypeMm: options.leastTypeMm },
    seconds: (seconds) => numberText(seconds, shownLanguage()),
  };
  const inside = [
    options.background === null || scene.background === null ? '' : backgroundSvg(scene, options.background, to),
    options.grid ? gridSvg(scene.size) : '',
    svgOf(courseShapes(scene.objects, look), to),
    pathSvg(options.path, to, unit),
    options.robot === null ? '' : robotSvg(options.robot, to),
  ].join('\n');
  const frame = { width, height };
  const body = [
    element('title', {}, escapeXml(scene.name)),
    element('defs', {}, element('clipPath', { id: 'parcours-arena' }, element('rect', frame))),
    element(
      'g',
      { transform: `translate(${corner.map(figure).join(' ')})` },
      options.floor ? element('rect', { ...frame, fill: colors.floor }) : '',
      element('g', { 'clip-path': 'url(#parcours-arena)' }, `\n${inside}\n`),
      element('rect', { ...frame, fill: 'none', stroke: colors.floorEdge, 'stroke-width': rim / 2 }),
      options.rulers ? rulersSvg(scene.size, unit) : '',
    ),
    ...(task === null ? [] : [task.svg]),
  ].join('\n');
  const root = {
    xmlns: 'http://www.w3.org/2000/svg',
    width: `${figure(size[0])}mm`,
    height: `${figure(size[1])}mm`,
    viewBox: `0 0 ${size.map(figure).join(' ')}`,
  };
  return {
    svg: `<?xml version="1.0" encoding="UTF-8"?>\n${element('svg', root, `\n${body}\n`)}\n`,
    size,
    alone,
    corner,
  };
}

function backgroundSvg({ background }: Scene, href: string, to: ToPicture): string {
  if (background === null) return '';
  const [x, y] = to([background.at[0], background.at[1] + background.size[1]]);
  const [width, height] = background.size;
  return element('image', { x, y, width, height, preserveAspectRatio: 'none', href, style: 'mix-blend-mode:multiply' });
}

function gridSvg([width, height]: Point): string {
  const { mm, strongMm } = gridSteps(1000 / Math.max(width, height)); // as on a screen 1000 px wide
  const lines = (step: number): string => {
    const paths: string[] = [];
    for (let x = step; x < width; x += step) paths.push(pathThrough([[x, 0], [x, height]])); // prettier-ignore
    for (let y = step; y < height; y += step) paths.push(pathThrough([[0, height - y], [width, height - y]])); // prettier-ignore
    return paths.join('');
  };
  const line = { fill: 'none', 'stroke-width': Math.max(width, height) / 1400 };
  return (
    element('path', { ...line, d: lines(mm), stroke: colors.grid }) +
    element('path', { ...line, d: lines(strongMm), stroke: colors.gridStrong })
  );
}

function rulersSvg([width, height]: Point, unit: number): string {
  const size = 1.8 * unit;
  const pxPerMm = 10 / unit; // as on a screen 1000 px wide
  const text = { 'font-family': SVG_FONT, 'font-size': size, fill: colors.rulerText };
  const measure = (label: string): number => label.length * size * 0.58;
  const labels = (length: number): ReturnType<typeof rulerLabels> =>
    rulerLabels(rulerTicks(length, pxPerMm), (mm) => mm, { from: -2 * unit, to: length + 2 * unit }, measure);
  const ticks: string[] = [];
  for (const { mm, label } of rulerTicks(width, pxPerMm))
    ticks.push(pathThrough([[mm, height + 0.4 * unit], [mm, height + (label === null ? 0.8 : 1.2) * unit]])); // prettier-ignore
  for (const { mm, label } of rulerTicks(height, pxPerMm))
    ticks.push(pathThrough([[-0.4 * unit, height - mm], [(label === null ? -0.8 : -1.2) * unit, height - mm]])); // prettier-ignore
  return [
    element('path', { d: ticks.join(''), fill: 'none', stroke: colors.rulerTick, 'stroke-width': unit * 0.14 }),
    ...labels(width).map(({ text: label, at }) =>
      element('text', { ...text, x: at, y: height + 3.2 * unit, 'text-anchor': 'middle' }, label),
    ),
    ...rulerTicks(height, pxPerMm).flatMap(({ mm, label }) =>
      label === null || mm === 0
        ? []
        : [element('text', { ...text, x: -1.7 * unit, y: height - mm + size * 0.36, 'text-anchor': 'end' }, label)],
    ),
  ].join('\n');
}

function pathSvg(pieces: PictureOptions['path'], to: ToPicture, unit: number): string {
  const d = pieces
    .filter(({ length }) => length > 1)
    .map((piece) => pathThrough(piece.map(({ x, y }) => to([x, y]))))
    .join('');
  if (d === '') return '';
  const line = { d, fill: 'none', 'stroke-linejoin': 'round', 'stroke-linecap': 'round' };
  return (
    element('path', { ...line, stroke: colors.traceCasing, 'stroke-width': 0.6 * unit }) +
    element('path', { ...line, stroke: colors.trace, 'stroke-width': 0.28 * unit })
  );
}

/** The robot's own drawing, put in as it is: front up, its origin in the middle of the axle. */
function robotSvg({ pose, scale, drawing }: NonNullable<PictureOptions['robot']>, to: ToPicture): string {
  const { svg, viewBox } = readRobotDrawing(drawing);
  const [x, y] = to([pose.xMm, pose.yMm]);
  const turn = 90 - degOf(pose.headingRad);
  const place = ['x', 'y', 'width', 'height'].map((name, i) => {
    const value = [viewBox.x, viewBox.y, viewBox.width, viewBox.height][i] ?? 0;
    return ` ${name}="${figure(value)}"`;
  });
  const inner = svg
    .slice(svg.search(/<svg\b/))
    .replace(/<!--[\s\S]*?-->/g, '')
    .replace(/<svg\b[^>]*>/, (root) =>
      root.replace(/\s(?:x|y|width|height)\s*=\s*"[^"]*"/g, '').replace('<svg', `<svg${place.join('')}`),
    );
  const transform = `translate(${figure(x)} ${figure(y)}) rotate(${figure(turn)}) scale(${figure(scale)})`;
  return element('g', { transform }, inner);
}
