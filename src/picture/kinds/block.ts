import { mdiArrowAll, mdiLock } from '@mdi/js';
import type { Block } from '#scene/scene';

import { paints } from '../paints';
import type { PaintColor } from '#scene/paint/paint';
import { formOf, signRoomIn, geometryOf, stripes, type Form } from '../form';
import type { Look } from '../look';
import { circle, group, type Geometry, type Shape } from '../shapes';
import { boxFrame, type PictureKind } from './kind';

/** Blocks that can be pushed. */
export const block: PictureKind<Block> = {
  body: (block, look) => [group(block.at, movableShapes(formOf(block), look), block.angle)],
  shade: (block, fill) => group(block.at, [{ ...movableOutline(formOf(block)), fill }], block.angle),
  frame: boxFrame,
};

/** A block with a colour: its sign and frame are in a dark ink of the same hue. */
const paintedBody = (color: PaintColor) => {
  const { fill, ink } = paints[color];
  return { movable: fill, movableLight: fill, movableInk: ink };
};
const paintedFixed = (color: PaintColor) => {
  const { fill, ink } = paints[color];
  return { fixed: fill, fixedEdge: ink, fixedInk: ink };
};

/** Blocks that stand fast. */
export const fixedBlock: PictureKind<Block> = {
  body: (block, look) => [group(block.at, fixedShapes(formOf(block), look), block.angle)],
  shade: (block, fill) => group(block.at, [{ ...fixedOutline(formOf(block)), fill }], block.angle),
  frame: boxFrame,
};

/** An icon, unless it would be a mere dot. */
export const icon = (path: string, across: number, fill: string, { px }: Look): readonly Shape[] =>
  across < 7 * px ? [] : [{ form: 'icon', path, across, fill }];

/** The outline of a block that can be pushed. */
export const movableOutline = (form: Form): Geometry => geometryOf(form, 0, Math.min(5, signRoomIn(form).acrossMm / 6));

/** A block that can be pushed, about its middle: light, a thick frame, four arrows. */
export function movableShapes(form: Form, look: Look): readonly Shape[] {
  const { movable, movableLight, movableInk } = form.color === undefined ? look.colors : paintedBody(form.color);
  const { at, acrossMm: short } = signRoomIn(form);
  const radius = Math.min(5, short / 6);
  return [
    ...framed(form, radius, Math.min(3, short * 0.09), [movable, movableLight, movableInk]),
    group([at.x, at.y], icon(mdiArrowAll, short * 0.66, movableInk, look)),
  ];
}

/** A ground that is lighter in its middle, in a frame. */
export function framed(
  form: Form,
  radius: number,
  width: number,
  [ground, light, ink]: readonly [string, string, string],
  insetMm = 0,
): readonly Shape[] {
  const outline = geometryOf(form, insetMm + width / 2, radius);
  return [
    { ...outline, fill: ground },
    { ...geometryOf(form, insetMm + width * 1.6, radius * 0.7), fill: light },
    { ...outline, stroke: ink, width },
  ];
}

const fixedOutline = (form: Form): Geometry => geometryOf(form, 0, Math.min(3, signRoomIn(form).acrossMm / 8));

/** Dark, diagonal stripes, a lock. */
function fixedShapes(form: Form, look: Look): readonly Shape[] {
  const { fixed, fixedEdge, fixedInk } = form.color === undefined ? look.colors : paintedFixed(form.color);
  const { at, acrossMm: short } = signRoomIn(form);
  const frame = Math.min(3, short * 0.08);
  const wide = Math.max(9, 5 * look.px);
  const pitch = wide * Math.SQRT2;
  const first = -(form.sizeMm.x + form.sizeMm.y + pitch) / 2;
  const sign = [circle(short * 0.28, { fill: fixed }), ...icon(mdiLock, short * 0.4, fixedInk, look)];
  return [
    { ...fixedOutline(form), fill: fixed },
    { ...stripes(form, { first, pitch, width: wide * 0.36 }), fill: 'rgba(255, 255, 255, 0.4)' },
    { ...geometryOf(form, frame / 2, Math.min(3, short / 8) * 0.7), stroke: fixedEdge, width: frame },
    ...(short < 11 * look.px ? [] : [group([at.x, at.y], sign)]),
  ];
}
