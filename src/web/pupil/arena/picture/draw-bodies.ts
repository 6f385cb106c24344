import { degOf, rotationRad } from '#core/angle';
import type { Pose } from '#core/geometry';
import { formOf } from '#picture/form';
import { movableOutline, movableShapes } from '#picture/kinds/block';
import type { PictureKind } from '#picture/kinds/kind';
import { jointShapes, wall as wallKind } from '#picture/kinds/wall';
import { group, type Geometry, type Shape } from '#picture/shapes';
import type { Block, Mover, SceneObject, Spikes, Wall } from '#scene/scene';
import type { PlacedBlock } from '../model/arena-model';
import type { Palette } from '../model/palette';
import type { View } from '../view/view-transform';
import { drawShapes, lookOf } from './draw-shapes';

/** A block, spikes or a mover of the course as it lies at the start. */
export const placedAtStart = (block: Block | Spikes | Mover): PlacedBlock => ({
  id: block.id,
  pose: { xMm: block.at[0], yMm: block.at[1], headingRad: rotationRad(block.angle) },
  ...formOf(block),
});

/** The pose of a thing; it may be lifted by the hand. */
type Lies = Pose & { readonly held?: boolean };

const SHADE = 'rgba(0, 0, 0, 0.2)';

/** How far a shadow falls, in px to the right and down. */
function shadowPx({ pxPerMm }: View, held = false): readonly [number, number] {
  const lift = (held ? 3 : 1) * Math.min(3, Math.max(1, 2.4 * pxPerMm));
  return [lift * 0.6, lift];
}

const aside = (view: View, [x, y]: readonly [number, number]): View => ({
  ...view,
  leftPx: view.leftPx + x,
  bottomPx: view.bottomPx + y,
});

/** Draws a thing at a pose: its shadow, then itself. */
export function drawBody(
  context: CanvasRenderingContext2D,
  view: View,
  { xMm, yMm, headingRad, held = false }: Lies,
  outline: Geometry,
  shapes: readonly Shape[],
): void {
  const size = held ? 1.03 : 1;
  const placed = { pxPerMm: view.pxPerMm * size, leftPx: view.leftPx + (1 - size) * xMm * view.pxPerMm, bottomPx: view.bottomPx - (1 - size) * yMm * view.pxPerMm }; // prettier-ignore
  const inFrame = (inside: readonly Shape[]): readonly Shape[] => [group([xMm, yMm], inside, degOf(headingRad))];
  drawShapes(context, aside(placed, shadowPx(view, held)), inFrame([{ ...outline, fill: SHADE }]));
  drawShapes(context, placed, inFrame(shapes));
}

/** Draws a block that can be pushed. */
export function drawMovableBlock(
  context: CanvasRenderingContext2D,
  view: View,
  block: PlacedBlock,
  held: boolean,
  palette: Palette,
): void {
  const shapes = movableShapes(block, lookOf(view, palette));
  drawBody(context, view, { ...block.pose, held }, movableOutline(block), shapes);
}

/** Draws a thing that is still at its start: its shadow, then itself. */
export function drawStanding<O extends SceneObject>(
  context: CanvasRenderingContext2D,
  view: View,
  kind: PictureKind<O>,
  object: O,
  palette: Palette,
): void {
  const shade = kind.shade?.(object, SHADE);
  if (shade) drawShapes(context, aside(view, shadowPx(view)), [shade]);
  drawShapes(context, view, kind.body?.(object, lookOf(view, palette)) ?? []);
}

/**
 * Draws walls: first their shadows, so that none falls on a neighbour, then the bricks.
 *
 * @param all the walls that these may meet
 */
export function drawWalls(
  context: CanvasRenderingContext2D,
  view: View,
  walls: readonly Wall[],
  palette: Palette,
  all: readonly Wall[] = walls,
): void {
  const look = lookOf(view, palette);
  const shadows = walls.flatMap((wall) => wallKind.shade?.(wall, SHADE) ?? []);
  drawShapes(context, aside(view, shadowPx(view)), shadows);
  drawShapes(context, view, [...jointShapes(all, look), ...walls.flatMap((wall) => wallKind.body?.(wall, look) ?? [])]);
}
