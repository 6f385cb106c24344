/**
 * Draws the attachments on a robot's servos, from the drawings of `#attachments/drawings`. Loaded on demand.
 *
 * Forks and shovels go under blocks, so they are drawn before the robot, and the blocks on them once more; everything
 * else is drawn over the robot's front. The shadow shows height: it moves away from the lifted thing, which itself is
 * drawn a little larger.
 */
import type { AttachmentState } from '#attachments/attachment';
import { attachmentDrawings } from '#attachments/drawings';
import type { Vec } from '#core/geometry';
import { memoOf } from '#core/memo';
import type { ArenaRobot, PlacedBlock } from '../model/arena-model';
import { geometryOf } from '#picture/form';
import { pathOf } from '../picture/draw-shapes';
import { partsOf, sonarOf, type AttachmentPart } from './attachment-parts';
import { drawMovableBlock } from '../picture/draw-bodies';
import type { Palette } from '../model/palette';
import { HELD_SIZE, type RobotPainting } from './robot-painting';
import { createSpriteShelf, type SpriteShelf } from './robot-sprite';
import { toPx, type View } from '../view/view-transform';

/** A robot in the picture. */
export interface PaintedRobot {
  readonly robot: ArenaRobot;
  readonly painting: RobotPainting;
  /** Relative to the real robot. */
  readonly scale: number;
  /** In the hand. */
  readonly held: boolean;
}

/** The canvas to draw on, and its view. */
interface Canvas {
  readonly context: CanvasRenderingContext2D;
  readonly view: View;
  /** Canvas pixels per px. */
  readonly ratio: number;
}

/** The part that goes under blocks. */
const FORK = 'fork';

/** A fork below this height has blocks that it does not carry on top of it, not under it. */
const LOW_MM = 12;

/**
 * Distance of a shadow from the thing that casts it, per mm of height, down and (less) to the right; as for the robot
 * itself.
 */
const SHADOW_PER_MM = 0.4;
const SHADOW_RIGHT = 0.4;
const RESTING_HEIGHT_MM = 5;
const SHADOW_ALPHA = 0.3;

/** Something lifted by this many mm looks twice as large. */
const DOUBLE_SIZE_MM = 700;

interface DrawnPart {
  readonly part: AttachmentPart;
  readonly sprites: SpriteShelf;
}

interface Workshop {
  readonly parts: ReadonlyMap<string, readonly DrawnPart[]>;
  /** The robot's own distance sensor as a part, and the robot without it; `null` when it has none. */
  readonly sonar: { readonly head: DrawnPart; readonly body: SpriteShelf } | null;
}

/** The sprites for one kind of robot, made once. */
const workshopOf = memoOf((painting: RobotPainting): Workshop => {
  const spritesOf = ({ svg, viewBox }: Pick<AttachmentPart, 'svg' | 'viewBox'>): SpriteShelf =>
    createSpriteShelf({ svg, viewBox }, painting.redraw);
  const drawn = (part: AttachmentPart): DrawnPart => ({ part, sprites: spritesOf(part) });
  const parts = Object.entries(attachmentDrawings).map(([id, svg]) => [id, partsOf(svg).map(drawn)] as const);
  const sonar = sonarOf(painting.drawing);
  return {
    parts: new Map(parts),
    sonar: sonar === null ? null : { head: drawn(sonar.head), body: spritesOf(sonar.body) },
  };
});

/** The sprites of the robot's body: without the distance sensor where a servo turns it, which is drawn apart. */
export function bodySprites({ state }: ArenaRobot, painting: RobotPainting): SpriteShelf {
  const turned = state.attachments.some(({ type }) => turnsSonar(type, painting));
  return (turned ? workshopOf(painting).sonar?.body : null) ?? painting.sprites;
}

/** Draws forks and shovels, and the blocks on them. Call it before the robot is drawn. */
export function drawForks(
  context: CanvasRenderingContext2D,
  view: View,
  ratio: number,
  painted: PaintedRobot,
  blocks: readonly PlacedBlock[],
  palette: Palette,
): void {
  const canvas = { context, view, ratio };
  const attachments = painted.robot.state.attachments;
  // A block held by a claw beside a lift is on the lift as well.
  const isHolding = attachments.some((attachment) => attachment.isHolding);
  for (const { attachment, parts } of frontOf(painted)) {
    if (attachment.heightMm > 0) drawParts(canvas, painted, attachment, parts, ['shadow']);
  }
  for (const attachment of attachments) {
    const forks = partsOfType(painted, attachment).filter(({ part }) => part.id === FORK);
    if (forks.length === 0) continue;
    const isLifted = isHolding && attachment.heightMm > 0;
    const load = blocks.filter((block) => isOver(attachment, isLifted ? CARRIED : NEAR, painted, block));
    for (const block of load) if (isLifted) drawBlockShadow(canvas, painted, attachment, block);
    drawParts(canvas, painted, attachment, forks);
    if (!isLifted && attachment.heightMm > LOW_MM) continue;
    for (const block of load) drawMovableBlock(context, view, block, isLifted, palette);
  }
}

/** Draws all other parts. Call it after the robot was drawn. */
export function drawFront(context: CanvasRenderingContext2D, view: View, ratio: number, painted: PaintedRobot): void {
  const canvas = { context, view, ratio };
  for (const { attachment, parts } of frontOf(painted)) {
    drawParts(canvas, painted, attachment, parts, attachment.heightMm > 0 ? ['body'] : SHADOW_AND_BODY);
  }
  const turning = painted.robot.state.attachments.find(({ type }) => turnsSonar(type, painted.painting));
  const { sonar } = workshopOf(painted.painting);
  if (turning === undefined || sonar === null) return;
  drawParts(canvas, painted, { ...turning, atMm: { x: 0, y: 0 }, heightMm: 0 }, [sonar.head]);
}

/**
 * All parts except forks. A part beside a lift is fixed to it: a claw rides up, and its shadow falls on the floor, not
 * on the block it holds. The lift's own mast stays.
 */
function frontOf(
  painted: PaintedRobot,
): readonly { readonly attachment: AttachmentState; readonly parts: readonly DrawnPart[] }[] {
  const attachments = painted.robot.state.attachments;
  const topMm = Math.max(0, ...attachments.map(({ heightMm }) => heightMm));
  return attachments.map((attachment) => {
    const all = partsOfType(painted, attachment);
    const heightMm = all.some(({ part }) => part.id === FORK) ? 0 : topMm;
    return { attachment: { ...attachment, heightMm }, parts: all.filter(({ part }) => part.id !== FORK) };
  });
}

type Layer = 'shadow' | 'body';
const SHADOW_AND_BODY: readonly Layer[] = ['shadow', 'body'];

const SONAR = 'sonar';

function turnsSonar(type: string, painting: RobotPainting): boolean {
  return (workshopOf(painting).parts.get(type) ?? []).some(({ part }) => part.id === SONAR);
}

/** The parts of an attachment; the distance sensor is the robot's own where it has one. */
function partsOfType({ painting }: PaintedRobot, { type }: AttachmentState): readonly DrawnPart[] {
  const { parts, sonar } = workshopOf(painting);
  return (parts.get(type) ?? []).filter(({ part }) => part.id !== SONAR || sonar === null);
}

/** Draws parts at the attachment's place: all their shadows, then all of them. */
function drawParts(
  { context, view, ratio }: Canvas,
  painted: PaintedRobot,
  { atMm, turnRad, heightMm }: AttachmentState,
  parts: readonly DrawnPart[],
  layers: readonly Layer[] = SHADOW_AND_BODY,
): void {
  const pxPerMm = pxPerMmOf(view, painted);
  const size = 1 + heightMm / DOUBLE_SIZE_MM;
  for (const layer of layers) {
    for (const { part, sprites } of parts) {
      const sprite = sprites.at(pxPerMm * ratio);
      if (sprite === null) continue;
      context.save();
      enterRobot(context, view, painted, layer === 'shadow' ? shadowShift(pxPerMm, heightMm) : { x: 0, y: 0 });
      context.translate(-atMm.y, -atMm.x); // robot frame to drawing: front is up
      context.scale(size, size);
      context.translate(part.pivot.x, part.pivot.y);
      context.rotate(-(turnRad[part.id] ?? part.restRad));
      context.translate(-part.pivot.x, -part.pivot.y);
      if (layer === 'shadow') context.globalAlpha = SHADOW_ALPHA;
      const box = layer === 'shadow' ? sprite.shadowBox : part.viewBox;
      context.drawImage(sprite[layer], box.x, box.y, box.width, box.height);
      context.restore();
    }
  }
}

function pxPerMmOf(view: View, { scale, held }: PaintedRobot): number {
  return view.pxPerMm * scale * (held ? HELD_SIZE : 1);
}

/** From px to the frame of the robot's drawing. */
function enterRobot(context: CanvasRenderingContext2D, view: View, painted: PaintedRobot, shift: Vec): void {
  const { pose } = painted.robot;
  const at = toPx(view, { x: pose.xMm, y: pose.yMm });
  const size = pxPerMmOf(view, painted);
  context.translate(at.x + shift.x, at.y + shift.y);
  context.rotate(Math.PI / 2 - pose.headingRad);
  context.scale(size, size);
}

function shadowShift(pxPerMm: number, heightMm: number): Vec {
  const y = SHADOW_PER_MM * (RESTING_HEIGHT_MM + heightMm) * pxPerMm;
  return { x: SHADOW_RIGHT * y, y };
}

/** The shadow on the floor of a block that is carried in the air. */
function drawBlockShadow(
  { context, view }: Canvas,
  painted: PaintedRobot,
  { heightMm }: AttachmentState,
  block: PlacedBlock,
): void {
  const { pose, sizeMm } = block;
  const at = toPx(view, { x: pose.xMm, y: pose.yMm });
  const shift = shadowShift(pxPerMmOf(view, painted), heightMm);
  context.save();
  context.translate(at.x + shift.x, at.y + shift.y);
  context.rotate(-pose.headingRad);
  context.scale(view.pxPerMm, view.pxPerMm);
  context.fillStyle = 'rgba(0, 0, 0, 0.22)';
  pathOf(context, geometryOf(block, 0, Math.min(sizeMm.x, sizeMm.y) / 6));
  context.fill();
  context.restore();
}

/** Ahead of the mount and to both sides, in mm of the real robot. */
interface Area {
  readonly fromX: number;
  readonly toX: number;
  readonly aside: number;
}

/** The area in which the middle of a block on a fork can be. */
const CARRIED: Area = { fromX: 0, toX: 62, aside: 36 };
/** The area in which it may overlap the fork's edge. */
const NEAR: Area = { fromX: -20, toX: 120, aside: 80 };

/** True if the middle of a block is in an area ahead of an attachment. */
function isOver({ atMm }: AttachmentState, area: Area, { robot, scale }: PaintedRobot, { pose }: PlacedBlock): boolean {
  const { xMm, yMm, headingRad } = robot.pose;
  const dx = (pose.xMm - xMm) / scale;
  const dy = (pose.yMm - yMm) / scale;
  const cos = Math.cos(headingRad);
  const sin = Math.sin(headingRad);
  const ahead = dx * cos + dy * sin - atMm.x;
  const aside = Math.abs(dy * cos - dx * sin - atMm.y);
  return ahead >= area.fromX && ahead <= area.toX && aside <= area.aside;
}
