import type { Vec } from '#core/geometry';
import type { ColourState } from '#robots/robot';
import { colourText } from '../../../course/editor/words/colour-text';
import type { Palette } from '../model/palette';
import { drawPill, type PillLook } from '../picture/draw-pill';
import { boxAround, unionOf, type PxBox } from '../view/moving-window';
import { toPx, type CanvasSize, type View } from '../view/view-transform';

/** Radius of the ring, and length of the line to the words, in px. */
const RING_PX = 9;
const LEADER_PX = 46;
/** Half of the widest words, in px. */
const WORDS_PX = 80;

/** The place of the words: above the ring; those of the sensor that looks ahead below it. */
const wordsAt = (at: Vec, { side }: ColourState): Vec => ({ x: at.x, y: at.y + (side === 'down' ? -LEADER_PX : LEADER_PX) }); // prettier-ignore

/** The areas of the rings and their words, in CSS px. */
export const colourBoxes = (colours: readonly ColourState[], view: View): readonly PxBox[] =>
  colours.map((colour) => {
    const at = toPx(view, colour.atMm);
    return unionOf([boxAround(at, RING_PX + 3), boxAround(wordsAt(at, colour), WORDS_PX)]);
  });

/** Draws a ring that is filled with what each colour sensor sees, and a word for it; over the robot. */
export function drawColours(
  context: CanvasRenderingContext2D,
  colours: readonly ColourState[],
  view: View,
  canvas: CanvasSize,
  palette: Palette,
): void {
  const look: PillLook = { ground: palette.pill, height: 26, fontPx: 14 };
  for (const colour of colours) {
    const at = toPx(view, colour.atMm);
    const words = wordsAt(at, colour);
    context.strokeStyle = palette.pill;
    context.lineWidth = 1.8;
    context.beginPath();
    context.moveTo(at.x, at.y);
    context.lineTo(words.x, words.y);
    context.stroke();
    disc(context, at, RING_PX + 1.5, palette.pill);
    disc(context, at, RING_PX, '#ffffff');
    disc(context, at, RING_PX - 3, `rgb(${colour.color.join(' ')})`);
    drawPill(context, colourText(colour), words, canvas, palette, look);
  }
}

function disc(context: CanvasRenderingContext2D, { x, y }: Vec, radius: number, fill: string): void {
  context.fillStyle = fill;
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fill();
}
