import type { Pose } from '#core/geometry';
import { boxAround, type PxBox } from '../view/moving-window';
import type { Palette } from '../model/palette';
import { toPx, type CanvasSize, type View } from '../view/view-transform';
import { drawHeldPose, drawRing } from './draw-hand';
import { ringRadiusPx, type Hand } from './hand';
import { toVec } from './held-thing';
import type { RobotShape } from './hit-test';

/** The ring of the robot, and the label of the held thing, at one moment. */
export interface HandMarks {
  /** The areas in which they are drawn, in CSS px; too large rather than too small. */
  readonly boxes: readonly PxBox[];
  drawRing(context: CanvasRenderingContext2D, palette: Palette): void;
  drawLabel(context: CanvasRenderingContext2D, canvas: CanvasSize, palette: Palette): void;
}

/** Room around a label, in px: half of the widest one, "123.4 | 123.4 cm". */
const LABEL_PX = 80;

/**
 * The marks of the hand; `null`: none shows.
 *
 * @param robot the robot as it is shown; `null`: there is none
 * @param heldPose the pose of the held thing; `null`: nothing is held
 */
export function handMarks(hand: Hand, view: View, robot: RobotShape | null, heldPose: Pose | null): HandMarks | null {
  const knobPx = robot === null ? null : hand.knobPx();
  if (knobPx === null && heldPose === null) return null;
  const turning = hand.held?.turning ?? false;
  const radiusPx = robot === null ? 0 : ringRadiusPx(view, robot);
  const distancePx = hand.held?.thing.kind === 'robot' ? radiusPx + 28 : 60;
  const ring = robot === null || knobPx === null ? null : { pose: robot.pose, radiusPx, knobPx, turning };
  return {
    boxes: [
      ...(ring === null ? [] : [boxAround(toPx(view, toVec(ring.pose)), radiusPx + 22)]),
      ...(heldPose === null ? [] : [boxAround(toPx(view, toVec(heldPose)), Math.max(LABEL_PX, distancePx + 20))]),
    ],
    drawRing(context, palette) {
      if (ring !== null) drawRing(context, view, ring, palette);
    },
    drawLabel(context, canvas, palette) {
      if (heldPose !== null) drawHeldPose(context, view, heldPose, turning, distancePx, canvas, palette);
    },
  };
}
