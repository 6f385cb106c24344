import type { Pose } from '#core/geometry';
import type { ArenaCone, ArenaRobot, PlacedBlock } from './arena-model';
import type { Arranged } from './arranged';
import { drawMovableBlock } from './draw-blocks';
import { drawCone, drawHit } from './draw-cone';
import { floorPx, sightPx, type FloorPx } from './draw-floor';
import { drawHeldPose, drawRing, type Ring } from './draw-hand';
import { drawRobot, type RobotPainting } from './draw-robot';
import { ringRadiusPx, type Hand } from './hand';
import type { Palette } from './palette';
import type { ArenaSize, CanvasSize, View } from './view-transform';

/** Everything on the moving layer at one moment. */
export interface MovingScene {
  readonly arena: ArenaSize;
  readonly blocks: readonly PlacedBlock[];
  /** Id of the block in the hand. */
  readonly heldBlock: string | null;
  readonly robot: { readonly now: ArenaRobot; readonly painting: RobotPainting; readonly scale: number } | null;
  readonly robotHeld: boolean;
  readonly display: ArrayLike<number>;
  readonly cone: ArenaCone | null;
  /** Simulated time for the cone's arcs, or `null` to keep them still. */
  readonly breathUs: number | null;
  readonly ring: Ring | null;
  /** What the hand holds, with a label `distancePx` away from it. */
  readonly label: { readonly pose: Pose; readonly turning: boolean; readonly distancePx: number } | null;
}

/** What a moving scene is put together from. */
export interface MovingParts {
  readonly arena: ArenaSize;
  readonly now: Arranged;
  readonly hand: Hand;
  /** `null` draws no robot. */
  readonly painting: RobotPainting | null;
  /** Size of the robot relative to the real one. */
  readonly scale: number;
  readonly display: ArrayLike<number>;
  readonly showCone: boolean;
  readonly breathUs: number | null;
}

/** Puts together what is to be drawn: the run's state, with what the hand holds where the hand is. */
export function movingScene(parts: MovingParts, view: View): MovingScene {
  const { hand, painting, scale } = parts;
  const blocks = parts.now.blocks.map((block) => {
    return { ...block, pose: hand.poseOf({ kind: 'block', id: block.id }, block.pose) };
  });
  const actual = painting === null ? null : parts.now.robot;
  const robot = actual === null ? null : { ...actual, pose: hand.poseOf({ kind: 'robot' }, actual.pose) };
  const held = hand.held;
  const heldBlock = held?.thing.kind === 'block' ? held.thing.id : null;
  const robotHeld = held?.thing.kind === 'robot';
  const heldPose = robotHeld ? robot?.pose : blocks.find(({ id }) => id === heldBlock)?.pose;
  const turning = held?.turning ?? false;
  const knobPx = hand.knobPx();
  const outlineMm = painting?.look.body.outlineMm ?? [];
  const radiusPx = ringRadiusPx(view, { outlineMm, scale });
  return {
    arena: parts.arena,
    blocks,
    heldBlock,
    robot: robot === null || painting === null ? null : { now: robot, painting, scale },
    robotHeld,
    display: parts.display,
    cone: parts.showCone && !robotHeld ? (robot?.state.ultrasonic ?? null) : null,
    breathUs: parts.breathUs,
    ring: robot === null || knobPx === null ? null : { pose: robot.pose, radiusPx, knobPx, turning },
    label: heldPose === undefined ? null : { pose: heldPose, turning, distancePx: robotHeld ? radiusPx + 28 : 60 },
  };
}

/**
 * Draws the layer above the floor: blocks, cone, robot, hand. Called for every frame.
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
  context.clearRect(0, 0, canvas.widthPx, canvas.heightPx);
  context.save();
  clipTo(context, sightPx(view, scene.arena, canvas));
  for (const block of scene.blocks)
    if (block.id !== scene.heldBlock) drawMovableBlock(context, view, block, false, palette);
  if (scene.cone !== null) {
    context.save();
    clipTo(context, floorPx(view, scene.arena));
    drawCone(context, view, scene.cone, scene.breathUs, palette);
    context.restore();
  }
  const { robot } = scene;
  if (robot !== null)
    drawRobot(
      context,
      view,
      ratio,
      robot.now,
      robot.painting,
      { display: scene.display, scale: robot.scale, held: scene.robotHeld },
      palette,
    );
  for (const block of scene.blocks)
    if (block.id === scene.heldBlock) drawMovableBlock(context, view, block, true, palette);
  if (scene.cone !== null) drawHit(context, view, scene.cone, canvas, palette);
  if (scene.ring !== null) drawRing(context, view, scene.ring, palette);
  context.restore();
  if (scene.label !== null) {
    const { pose, turning, distancePx } = scene.label;
    drawHeldPose(context, view, pose, turning, distancePx, canvas, palette);
  }
}

function clipTo(context: CanvasRenderingContext2D, box: FloorPx): void {
  context.beginPath();
  context.rect(box.left, box.top, box.width, box.height);
  context.clip();
}
