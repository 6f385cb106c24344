import { rotationRad } from '#core/angle';
import { STANDING_TAG_MM } from '#scene/kinds/tag';
import { TAG_CELLS, tagSheetMm } from '#scene/kinds/tag-thing';
import type { Tag } from '#scene/scene';

import type { Look } from '../look';
import { group, rect, written, type Shape } from '../shapes';
import { tagPattern } from '../tag-pattern';
import type { PictureKind } from './kind';

const [INK, SHEET] = ['#000000', '#FFFFFF'];
/** Thickness of a standing sheet from above, in mm. */
const THICK = 6;

/** Tags: one that lies shows its pattern, one that stands its edge, where it looks and its number. */
export const tag: PictureKind<Tag> = {
  mark: (tag, look) => (tag.flat ? lying(tag, look) : []),
  body: (tag, look) => (tag.flat ? [] : standing(tag, look)),
  paper: (tag, look) => (tag.flat ? lying(tag, look) : standing(tag, look)),
  frame: ({ at: [x, y], side, angle, flat }) => ({
    at: { x, y },
    angleRad: rotationRad(angle),
    size: { x: flat ? tagSheetMm(side) : STANDING_TAG_MM, y: tagSheetMm(side) },
  }),
};

function lying({ at, number, side, angle }: Tag, { px }: Look): readonly Shape[] {
  const sheet = tagSheetMm(side);
  const edge = rect([sheet, sheet], 0, { fill: SHEET, stroke: '#9AA3AE', width: Math.max(0.2, px / 2) });
  return [group(at, [edge, ...tagShapes(number, side)], angle)];
}

/** The black square of a tag and its white cells, around the origin of a group. */
export function tagShapes(number: number, side: number): readonly Shape[] {
  const cell = side / TAG_CELLS;
  const white = tagPattern(number).flatMap((row, y) =>
    runsOf(row).map(([from, to]): Shape => ({
      ...{ form: 'rect', at: [(from - 3) * cell, (y - 3) * cell], size: [(to - from) * cell, cell], round: 0 },
      fill: SHEET,
    })),
  );
  return [rect([side, side], 0, { fill: INK }), ...white];
}

/** The white cells of a row that lie side by side: from, and up to but without. */
function runsOf(row: readonly boolean[]): readonly (readonly [from: number, to: number])[] {
  const runs: [number, number][] = [];
  for (const [column, isWhite] of row.entries()) {
    const last = runs[runs.length - 1];
    if (!isWhite) continue;
    if (last?.[1] === column) last[1] = column + 1;
    else runs.push([column, column + 1]);
  }
  return runs;
}

function standing({ at, number, side, angle }: Tag, { px }: Look): readonly Shape[] {
  const sheet = tagSheetMm(side);
  const line = Math.max(px, 0.8);
  // Towards the printed side: an arrow, and before it the number.
  const arrow: Shape = {
    ...{ form: 'lines', lines: [[[THICK / 2 + 9, 0], [THICK / 2, 7], [THICK / 2, -7]]], isClosed: true, fill: INK }, // prettier-ignore
  };
  const size = 16;
  const words =
    size < 6 * px
      ? []
      : [group([22, 0], [rect([22, 18], 4, { fill: SHEET, stroke: INK, width: line }), written(String(number), 14, INK)], -angle)]; // prettier-ignore
  return [
    group(
      at,
      [
        rect([THICK, sheet], 0, { fill: SHEET, stroke: INK, width: line }),
        rect([THICK, side], 0, { fill: INK }),
        arrow,
        ...words,
      ],
      angle,
    ),
  ];
}
