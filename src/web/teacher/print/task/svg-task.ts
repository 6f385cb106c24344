import type { Point } from '#scene/scene';

import { lightPalette as colors } from '../../../pupil/arena/model/palette';
import { SVG_FONT } from '#picture/svg';
import { breakPages, setRows } from './set-rows';
import { rowSvg } from './svg-rows';
import { textBlocks, titleBlock } from './task-blocks';

/** The task's part of a picture. */
export interface PictureTask {
  readonly title: string;
  /** In the small markup of tasks. */
  readonly text: string;
}

/** The task in a picture, and the extent of both. */
interface TaskPicture {
  readonly svg: string;
  readonly size: Point;
}

/** Type size in parts of the picture's width: 10 pt on a worksheet of A4. */
const TYPE_SHARE = 1 / 48;

/** An arena this much higher than wide has its task beside it. */
const HIGH = 1.2;

/** Share of the width for which rows are set: fonts of viewers may be that much wider than ours. */
const SLACK = 0.96;

const LOOK = { 'font-family': SVG_FONT, fill: colors.label };

/**
 * Writes title and text of a task below an arena, or beside a high one.
 *
 * @param corner the arena's upper left corner in the picture
 * @param size the picture without the task
 */
export function taskSvg({ title, text }: PictureTask, arena: Point, corner: Point, size: Point): TaskPicture {
  const isBeside = arena[1] > HIGH * arena[0];
  const width = isBeside ? Math.max(arena[0], 0.6 * arena[1]) : arena[0];
  const em = (isBeside ? size[0] + width : size[0]) * TYPE_SHARE;
  const gap = 1.5 * em;
  const [left, top] = isBeside ? [size[0] + gap, corner[1]] : [corner[0], size[1] + gap];
  const [rows = []] = breakPages(
    setRows([...titleBlock(title, em), ...textBlocks(text, em, null)], SLACK * width),
    Infinity,
  );
  const last = rows.at(-1);
  const bottom = top + (last === undefined ? 0 : last.topMm + last.row.heightMm) + 0.5 * em;
  return {
    svg: rows.map((row) => rowSvg(row, [left, top], LOOK)).join('\n'),
    size: isBeside ? [left + width + gap, Math.max(size[1], bottom)] : [size[0], bottom],
  };
}
