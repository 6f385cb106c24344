import type { Pose, Vec } from '#core/geometry';
import type { ArenaRobot, PlacedBlock } from '../model/arena-model';
import type { Arranged } from '../picture/arranged';
import { drawMovableBlock } from '../picture/draw-bodies';
import { attachmentFrontMm, attachmentPainter, attachmentReachMm } from '../robot/draw-attachments';
import { sightPx } from '../picture/draw-floor';
import type { HandMarks } from '../hand/hand-marks';
import type { LateHand } from '../hand/late-hand';
import { drawRobot, paintedRadiusMm } from '../robot/draw-robot';
import type { OverlayPicture } from './overlays';
import { clipTo } from '../view/clip-to';
import { boxAround, unionOf, type PxBox } from '../view/moving-window';
import { shiftToWholePixels } from '../view/whole-pixels';
import type { Palette } from '../model/palette';
import type { RobotPainting } from '../robot/robot-painting';
import { toPx, type ArenaSize, type CanvasSize, type View } from '../view/view-transform';

/** Everything on the moving layer at one moment. */
export interface MovingScene {
  readonly arena: ArenaSize;
  readonly blocks: readonly PlacedBlock[];
  /** Id of the block in the hand. */
  readonly heldBlock: string | null;
  readonly robot: { readonly now: ArenaRobot; readonly painting: RobotPainting; readonly scale: number } | null;
  readonly robotHeld: boolean;
  readonly display: ArrayLike<number>;
  /** Overlays that are shown with the things themselves. */
  readonly overlay: OverlayPicture | null;
  /** The ring of the robot, and the label of the held thing; `null`: neither shows. */
  readonly marks: HandMarks | null;
}

/** The sources of a moving scene. */
export interface MovingParts {
  readonly arena: ArenaSize;
  readonly now: Arranged;
  readonly hand: Pick<LateHand, 'poseOf' | 'held' | 'marks'>;
  /** `null` draws no robot. */
  readonly painting: RobotPainting | null;
  /** Size of the robot relative to the real one. */
  readonly scale: number;
  readonly display: ArrayLike<number>;
}

/** Puts together the moving scene: the run's state, with the held thing under the hand. */
export function movingScene(parts: MovingParts, view: View): MovingScene {
  const { hand, painting, scale } = parts;
  const blocks = parts.now.blocks.map((block) => {
    const pose = hand.poseOf({ kind: 'block', id: block.id }, block.pose);
    return pose === block.pose ? block : { ...block, pose };
  });
  const actual = painting === null ? null : parts.now.robot;
  const robot = actual === null ? null : { ...actual, pose: hand.poseOf({ kind: 'robot' }, actual.pose) };
  const held = hand.held;
  const heldBlock = held?.thing.kind === 'block' ? held.thing.id : null;
  const robotHeld = held?.thing.kind === 'robot';
  const heldPose = robotHeld ? robot?.pose : blocks.find(({ id }) => id === heldBlock)?.pose;
  const shape = robot && painting && { pose: robot.pose, outlineMm: painting.look.body.outlineMm, scale };
  const frontMm = attachmentFrontMm(robot?.state.attachments);
  return {
    arena: parts.arena,
    blocks,
    heldBlock,
    robot: robot === null || painting === null ? null : { now: robot, painting, scale },
    robotHeld,
    display: parts.display,
    overlay: null,
    marks: hand.marks(view, shape && { ...shape, frontMm }, heldPose ?? null),
  };
}

/** Draws blocks that nothing holds. They are redrawn only when one of them has moved. */
export function drawBlocks(
  context: CanvasRenderingContext2D,
  view: View,
  blocks: readonly PlacedBlock[],
  palette: Palette,
): void {
  for (const block of blocks) drawMovableBlock(context, view, block, false, palette);
}

/**
 * Draws everything that moves all the time: robot, overlays, held thing, ring. Called for every frame.
 *
 * @param context draws in CSS px
 * @param ratio canvas pixels per CSS px
 */
export function drawMoving(
  context: CanvasRenderingContext2D,
  view: View,
  canvas: CanvasSize,
  ratio: number,
  scene: MovingScene,
  palette: Palette,
): void {
  const { robot, marks } = scene;
  context.save();
  clipTo(context, sightPx(view, scene.arena, canvas));
  if (robot !== null) shiftToWholePixels(context, toPx(view, { x: robot.now.pose.xMm, y: robot.now.pose.yMm }));
  scene.overlay?.under(context);
  if (robot !== null) {
    const appearance = { display: scene.display, scale: robot.scale, held: scene.robotHeld };
    const painted = { robot: robot.now, painting: robot.painting, ...appearance };
    const loose = scene.blocks.filter(({ id }) => id !== scene.heldBlock);
    attachmentPainter(robot.now.state, robot.painting)?.drawForks(context, view, ratio, painted, loose, palette);
    drawRobot(context, view, ratio, robot.now, robot.painting, appearance, palette);
  }
  for (const block of scene.blocks)
    if (block.id === scene.heldBlock) drawMovableBlock(context, view, block, true, palette);
  scene.overlay?.over(context);
  marks?.drawRing(context, palette);
  context.restore();
  marks?.drawLabel(context, canvas, palette);
}

/** The area in which `drawMoving` draws, in CSS px; too large rather than too small. */
export function movingBox(scene: MovingScene, view: View): PxBox {
  const boxes: PxBox[] = [...(scene.overlay?.boxes ?? []), ...(scene.marks?.boxes ?? [])];
  const at = (pose: Pose): Vec => toPx(view, { x: pose.xMm, y: pose.yMm });
  const { robot } = scene;
  if (robot !== null) {
    const bodyMm = paintedRadiusMm(robot.painting.drawing);
    const reachMm = Math.max(bodyMm, attachmentReachMm(robot.now.state)) * robot.scale;
    boxes.push(boxAround(at(robot.now.pose), reachMm * view.pxPerMm + 12));
  }
  const held = scene.blocks.find(({ id }) => id === scene.heldBlock);
  if (held !== undefined)
    boxes.push(boxAround(at(held.pose), Math.hypot(held.sizeMm.x, held.sizeMm.y) * 0.55 * view.pxPerMm + 12));
  return unionOf(boxes);
}
