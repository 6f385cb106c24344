import { mdiArrowAll, mdiLock } from '@mdi/js';
import type { Block, Point } from '#scene/scene';

import { lightPalette as colors } from '../../arena/model/palette';
import { element } from './svg-write';
import type { PrintKind } from './kind';
import { boxFrame, diagonals, icon, rect } from './svg-parts';

/** Movable blocks. */
export const block: PrintKind<Block> = {
  layer: 3,
  svg: (block, to) => boxFrame(block, to, blockSvg(block.size)),
};

/** Blocks that stand fast. */
export const fixedBlock: PrintKind<Block> = {
  layer: 3,
  svg: (block, to) => boxFrame(block, to, fixedBlockSvg(block.size)),
};

function blockSvg([width, height]: Point): string {
  const short = Math.min(width, height);
  const frame = Math.min(3, short * 0.09);
  return (
    rect([width - frame, height - frame], Math.min(5, short / 6), {
      fill: colors.movableLight,
      stroke: colors.movableInk,
      'stroke-width': frame,
    }) + icon(mdiArrowAll, short * 0.66, colors.movableInk)
  );
}

function fixedBlockSvg([width, height]: Point): string {
  const short = Math.min(width, height);
  const frame = Math.min(3, short * 0.08);
  return (
    rect([width, height], Math.min(3, short / 8), { fill: colors.fixed }) +
    element('path', {
      d: diagonals([width, height], Math.max(9, short / 5)),
      stroke: '#fff',
      'stroke-opacity': 0.4,
      'stroke-width': Math.max(9, short / 5) * 0.36,
      fill: 'none',
    }) +
    rect([width - frame, height - frame], Math.min(2, short / 10), {
      fill: 'none',
      stroke: colors.fixedEdge,
      'stroke-width': frame,
    }) +
    element('circle', { r: short * 0.28, fill: colors.fixed }) +
    icon(mdiLock, short * 0.4, colors.fixedInk)
  );
}
