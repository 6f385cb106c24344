import type { Form } from '../../../pupil/arena/model/arena-model';
import { mdiArrowAll, mdiLock } from '@mdi/js';
import type { Block } from '#scene/scene';

import { lightPalette as colors } from '../../../pupil/arena/model/palette';
import { formOf, roomIn } from '../../../pupil/arena/picture/kinds/shape-path';
import { element } from './svg-write';
import type { PrintKind } from './kind';
import { boxFrame, diagonals, formSvg, icon, inRoom } from './svg-parts';

/** Movable blocks. */
export const block: PrintKind<Block> = {
  layer: 3,
  svg: (block, to) => boxFrame(block, to, blockSvg(formOf(block))),
};

/** Blocks that stand fast. */
export const fixedBlock: PrintKind<Block> = {
  layer: 3,
  svg: (block, to) => boxFrame(block, to, fixedBlockSvg(block)),
};

function blockSvg(form: Form): string {
  const room = roomIn(form);
  const short = room.acrossMm;
  const frame = Math.min(3, short * 0.09);
  return (
    formSvg(form, frame / 2, Math.min(5, short / 6), {
      fill: colors.movableLight,
      stroke: colors.movableInk,
      'stroke-width': frame,
    }) + inRoom(room, icon(mdiArrowAll, short * 0.66, colors.movableInk))
  );
}

function fixedBlockSvg(block: Block): string {
  const form = formOf(block);
  const room = roomIn(form);
  const short = room.acrossMm;
  const frame = Math.min(3, short * 0.08);
  return (
    formSvg(form, 0, Math.min(3, short / 8), { fill: colors.fixed }) +
    element('path', {
      d: diagonals(block, Math.max(9, short / 5)),
      stroke: '#fff',
      'stroke-opacity': 0.4,
      'stroke-width': Math.max(9, short / 5) * 0.36,
      fill: 'none',
    }) +
    formSvg(form, frame / 2, Math.min(2, short / 10), {
      fill: 'none',
      stroke: colors.fixedEdge,
      'stroke-width': frame,
    }) +
    inRoom(
      room,
      element('circle', { r: short * 0.28, fill: colors.fixed }) + icon(mdiLock, short * 0.4, colors.fixedInk),
    )
  );
}
