import type { Point } from '#scene/scene';

import type { Group, Paint, Shape, Words } from './shapes';
import { element, escapeXml, pathThrough, type Attributes } from './svg-write';

/** Fonts of the texts in a picture; every viewer has one of them. */
export const SVG_FONT = 'Roboto, Arial, Helvetica, sans-serif';

/** From a place of the world, y up, to the picture's, y down. */
export type ToPicture = (at: Point) => Point;

const asItIs: ToPicture = (at) => at;

/**
 * Shapes as SVG, in mm of the picture, with presentation attributes only: office programs read no style sheets. Rims around
 * words and squeezed letters are left out.
 */
export const svgOf = (shapes: readonly Shape[], to: ToPicture): string =>
  shapes.map((shape) => svgOfShape(shape, to)).join('');

function svgOfShape(shape: Shape, to: ToPicture): string {
  switch (shape.form) {
    case 'group':
      return svgOfGroup(shape, to);
    case 'words':
      return svgOfWords(shape);
    case 'icon': {
      const transform = `scale(${(shape.across / 24).toFixed(4)}) translate(-12 -12)`;
      return element('path', { d: shape.path, ...painted(shape), transform });
    }
    case 'lines': {
      const d = shape.lines.map((line) => pathThrough(line.map(to), shape.isClosed)).join('');
      return d === '' ? '' : element('path', { d, ...painted(shape) });
    }
    case 'ellipse': {
      const [cx, cy] = to(shape.at);
      const [rx, ry] = shape.radii;
      const place = { cx: cx || undefined, cy: cy || undefined };
      return rx === ry
        ? element('circle', { ...place, r: rx, ...painted(shape) })
        : element('ellipse', { ...place, rx, ry, ...painted(shape) });
    }
    case 'rect': {
      const [[x, y], [width, height]] = [shape.at, shape.size];
      return element('rect', { x, y, width, height, rx: shape.round || undefined, ...painted(shape) });
    }
  }
}

function svgOfGroup({ at, turn, inside }: Group, to: ToPicture): string {
  const [x, y] = to(at);
  const shapes = svgOf(inside, asItIs);
  if (shapes === '' || (x === 0 && y === 0 && turn === 0)) return shapes;
  const move = `translate(${x.toFixed(3)} ${y.toFixed(3)})`;
  return element('g', { transform: turn === 0 ? move : `${move} rotate(${(-turn).toFixed(3)})` }, shapes);
}

const svgOfWords = ({ text, at: [x, y], from, size, weight, fill }: Words): string =>
  element(
    'text',
    {
      ...{ x, y, 'font-family': SVG_FONT, 'font-size': size, 'font-weight': weight },
      ...{ 'text-anchor': from, fill },
    },
    escapeXml(text),
  );

function painted({ fill, stroke, width, opacity, dash, dashFrom, cap, join }: Paint): Attributes {
  const [ground, line] = [colored(fill), colored(stroke)];
  return {
    fill: ground?.color ?? 'none',
    'fill-opacity': ground && (opacity ?? ground.opacity),
    stroke: line?.color,
    'stroke-opacity': line && (opacity ?? line.opacity),
    'stroke-width': line && width,
    'stroke-dasharray': dash?.map((mm) => Math.round(mm * 1000) / 1000).join(' '),
    'stroke-dashoffset': dashFrom || undefined,
    'stroke-linecap': cap,
    'stroke-linejoin': join,
  };
}

/** A colour, and how much of it covers: office programs know no `rgba()`. */
function colored(color: string | undefined): { readonly color: string; readonly opacity?: number } | undefined {
  if (color === undefined) return undefined;
  const [, red, green, blue, alpha] = /^rgba\((\d+), (\d+), (\d+), ([\d.]+)\)$/.exec(color) ?? [];
  if (alpha === undefined) return { color };
  const hex = [red, green, blue].map((part) => Number(part).toString(16).padStart(2, '0')).join('');
  return { color: `#${hex}`, opacity: Number(alpha) };
}
