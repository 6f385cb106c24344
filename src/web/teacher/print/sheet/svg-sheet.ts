import { pathOf } from '../../../kit/links/qr-code';
import { element, figure, pathThrough } from '#picture/svg-write';
import { rowSvg } from '../task/svg-rows';
import { SHEET_MM, SQUARE_MM, type Box, type Mark, type SheetContent, type SheetLayout } from './sheet-layout';

/** Fonts whose letters are as wide as those that the rows are set for, wherever there is one of them. */
const LOOK = { 'font-family': 'Arial, Liberation Sans, Helvetica, Roboto, sans-serif', fill: '#000000' };

/** Grey that a copier still takes, light enough to write on. */
export const LINE_COLORS = { strong: '#000000', write: '#7B8491', squares: '#A9B1BB' } as const;
/** Widths of lines in mm. */
export const LINE_MM = { strong: 0.3, write: 0.2, squares: 0.15 } as const;

/** Each sheet as an SVG document in true size, to look at and to print. @param course the drawing of the course as an SVG document */
export const sheetSvgs = (content: SheetContent, { pages }: SheetLayout, course: string): readonly string[] =>
  pages.map((marks) => {
    const [width, height] = SHEET_MM;
    const root = {
      ...{ xmlns: 'http://www.w3.org/2000/svg', width: `${String(width)}mm`, height: `${String(height)}mm` },
      viewBox: `0 0 ${String(width)} ${String(height)}`,
    };
    const paper = element('rect', { width, height, fill: '#ffffff' });
    return element('svg', root, paper, ...marks.map((mark) => markSvg(mark, content, course)));
  });

function markSvg(mark: Mark, { task, qr }: SheetContent, course: string): string {
  switch (mark.kind) {
    case 'row':
      return rowSvg(mark.row, mark.at, LOOK, task.picture?.data);
    case 'line': {
      const look = mark.isStrong ? 'strong' : 'write';
      const line = { stroke: LINE_COLORS[look], 'stroke-width': LINE_MM[look] };
      return element('path', { d: pathThrough([mark.from, mark.to]), ...line });
    }
    case 'course':
      return placed(course, mark);
    case 'qr': {
      if (qr === null) return '';
      const [x, y] = mark.at;
      const transform = `translate(${figure(x)} ${figure(y)}) scale(${String(mark.size[0] / qr.size)})`;
      return element('path', { d: pathOf(qr), transform, 'shape-rendering': 'crispEdges' });
    }
    case 'squares':
      return element('path', {
        ...{ d: squareLines(mark).map((line) => pathThrough(line)).join(''), fill: 'none' }, // prettier-ignore
        ...{ stroke: LINE_COLORS.squares, 'stroke-width': LINE_MM.squares },
      });
    default:
      return mark satisfies never;
  }
}

/** The lines of squared paper. */
export function squareLines({ at: [x, y], size: [width, height] }: Box) {
  const count = (mm: number): number => Math.round(mm / SQUARE_MM);
  const across = Array.from({ length: count(height) + 1 }, (_, row) => y + row * SQUARE_MM);
  const down = Array.from({ length: count(width) + 1 }, (_, column) => x + column * SQUARE_MM);
  return [
    ...across.map((at) => [[x, at], [x + width, at]] as const), // prettier-ignore
    ...down.map((at) => [[at, y], [at, y + height]] as const), // prettier-ignore
  ];
}

/** An SVG document within another, at this place in this size. */
const placed = (svg: string, { at: [x, y], size: [width, height] }: Box): string =>
  svg.slice(svg.search(/<svg\b/)).replace(/<svg\b[^>]*>/, (root) => {
    const place = { x, y, width, height };
    const bare = root.replace(/\s(?:width|height)\s*=\s*"[^"]*"/g, '');
    const attributes = Object.entries(place).map(([name, value]) => ` ${name}="${figure(value)}"`);
    return bare.replace('<svg', `<svg${attributes.join('')}`);
  });
