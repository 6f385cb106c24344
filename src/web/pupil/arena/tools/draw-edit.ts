import type { Vec } from '#core/geometry';
import type { Handle, Mark, ToolId } from '#editor/tools/tool';
import type { RobotStart, Scene, SceneObject } from '#scene/scene';
import { memo } from '#core/memo';
import { drawCrosshair, drawHandle, drawMark, drawSelected } from './draw-marks';
import type { MarkFrame } from './mark-frame';
import { drawObject } from '../picture/draw-object';
import { thingBox, type CarriedThings } from './carried-things';
import { areMany } from '../picture/still-cache';
import { guideBox, readingBox } from './draw-guides';
import { drawPill } from '../picture/draw-pill';
import { drawRobotOutline, robotOutlinePx } from '../picture/draw-outline';
import { drawInk, inkBox, type InkFrame } from './ink-layer';
import { boxAround, unionOf, wholeCanvas, type PxBox } from '../view/moving-window';
import { toolSigns } from './tool-cursors';
import type { Ink } from './gesture';
import { toPx, type View } from '../view/view-transform';

/** The picture of the editor over the arena at one moment. */
export interface EditPicture {
  /** Objects as they would be. */
  readonly ghost: readonly SceneObject[];
  readonly selected: readonly SceneObject[];
  /** Start of the robot, current or proposed, if it is visible. */
  readonly start: RobotStart | null;
  readonly isStartSelected: boolean;
  readonly handles: readonly Handle[];
  readonly marks: readonly Mark[];
  /** The newest piece of the line that is drawn, from one of its places on. */
  readonly ink: { readonly ink: Ink; readonly from: number } | null;
  /** The pen's tip, under a pointer that is not pressed. */
  readonly tip: { readonly at: Vec; readonly width: number; readonly color: string } | null;
  readonly crosshair: { readonly at: Vec; readonly isDown: boolean } | null;
  /** Figures, or the field in which they are typed, and their place in CSS px. */
  readonly reading: { readonly text: string; readonly isField: boolean; readonly at: Vec } | null;
  /** The current use of the keyboard and how to end it, with its place in CSS px. */
  readonly hint: { readonly text: string; readonly at: Vec } | null;
  /** A finger that is using a tool. */
  readonly finger: { readonly at: Vec; readonly tool: ToolId } | null;
}

/** The frame in which the editor's picture is drawn. */
export interface EditFrame extends MarkFrame, InkFrame {
  /** Convex parts of the robot at scale 1 in its own frame, mm. */
  readonly footprint: readonly (readonly Vec[])[];
  /** Painters of the changes of a gesture, and of the frames around the selection. */
  readonly carried: { readonly ghost: CarriedThings; readonly selected: CarriedThings };
}

/** Draws the editor's picture, in CSS px. */
export function drawEdit(context: CanvasRenderingContext2D, frame: EditFrame, picture: EditPicture): void {
  const { view, palette } = frame;
  frame.carried.ghost(context, frame, picture.ghost, (on, object) => drawObject(on, view, object, palette));
  if (picture.ink !== null) drawInk(context, picture.ink.ink, picture.ink.from, frame);
  if (picture.start !== null) {
    const parts = robotOutlinePx(view, picture.start, frame.footprint);
    drawRobotOutline(context, parts, frame.ratio, picture.isStartSelected ? palette.hand : palette.trace);
  }
  frame.carried.selected(context, frame, picture.selected, (on, object) => drawSelected(on, frame, object));
  for (const mark of picture.marks) drawMark(context, frame, mark);
  for (const handle of picture.handles) drawHandle(context, frame, handle);
  if (picture.tip !== null) drawTip(context, frame, picture.tip);
  if (picture.crosshair !== null) drawCrosshair(context, frame, picture.crosshair.at, picture.crosshair.isDown);
  if (picture.reading !== null) drawReading(context, frame, picture.reading);
  if (picture.hint !== null) drawPill(context, picture.hint.text, picture.hint.at, frame.canvas, palette);
  if (picture.finger !== null) drawFinger(context, frame, picture.finger.at, picture.finger.tool);
}

/** Area of the picture, in CSS px; too large rather than too small. `null`: nothing is shown. */
export function editBox(frame: EditFrame, picture: EditPicture): PxBox | null {
  const { view, canvas } = frame;
  const isWide = picture.marks.some(({ type }) => type === 'measure' || type === 'grid');
  if (isWide || areMany(picture.ghost) || areMany(picture.selected)) return wholeCanvas(canvas);
  const boxes: PxBox[] = [];
  for (const object of [...picture.ghost, ...picture.selected]) boxes.push(thingBox(view, object));
  for (const mark of picture.marks) boxes.push(markBox(view, mark));
  for (const { at } of picture.handles) boxes.push(boxAround(toPx(view, at), 20));
  if (picture.ink !== null) boxes.push(inkBox(picture.ink.ink, picture.ink.from, view));
  if (picture.start !== null) {
    const corners = robotOutlinePx(view, picture.start, frame.footprint).flat();
    if (corners.length > 0) boxes.push(unionOf(corners.map((corner) => boxAround(corner, 8))));
  }
  if (picture.tip !== null)
    boxes.push(boxAround(toPx(view, picture.tip.at), (picture.tip.width / 2) * view.pxPerMm + 6));
  if (picture.crosshair !== null) boxes.push(boxAround(toPx(view, picture.crosshair.at), 26));
  if (picture.reading !== null) boxes.push(readingBox(picture.reading.at));
  if (picture.hint !== null) boxes.push(readingBox(picture.hint.at));
  if (picture.finger !== null) boxes.push(boxAround(toPx(view, picture.finger.at), FINGER_PX + 24));
  return boxes.length === 0 ? null : unionOf(boxes);
}

function markBox(view: View, mark: Mark): PxBox {
  if (mark.type === 'frame') return unionOf([mark.from, mark.to].map((at) => boxAround(toPx(view, at), 4)));
  if (mark.type === 'lasso') return unionOf(mark.path.map((at) => boxAround(toPx(view, at), 4)));
  if (mark.type === 'snap' || mark.type === 'point') return boxAround(toPx(view, mark.at), 16);
  if (mark.type === 'goes') return thingBox(view, mark.object);
  if (mark.type === 'eraser') return boxAround(toPx(view, mark.at), mark.radiusMm * view.pxPerMm + 6);
  if (mark.type === 'guide' || mark.type === 'distance') return guideBox(view, mark);
  return { left: 0, top: 0, width: 0, height: 0 };
}

/** Draws the figures on a pill; typed ones are larger, on blue. */
function drawReading(
  context: CanvasRenderingContext2D,
  { canvas, palette }: EditFrame,
  { text, isField, at }: NonNullable<EditPicture['reading']>,
): void {
  if (isField) drawPill(context, text, at, canvas, palette, { ground: palette.target, height: 30, fontPx: 16 });
  else drawPill(context, text, at, canvas, palette);
}

/** Draws the tip of the pen. */
function drawTip(context: CanvasRenderingContext2D, { view }: EditFrame, tip: NonNullable<EditPicture['tip']>): void {
  const at = toPx(view, tip.at);
  context.save();
  context.beginPath();
  context.arc(at.x, at.y, Math.max(1.5, (tip.width / 2) * view.pxPerMm), 0, 2 * Math.PI);
  context.globalAlpha = 0.4;
  context.fillStyle = tip.color;
  context.fill();
  context.globalAlpha = 1;
  context.strokeStyle = 'rgba(255, 255, 255, 0.9)';
  context.lineWidth = 3;
  context.stroke();
  context.strokeStyle = '#48515C';
  context.lineWidth = 1.25;
  context.stroke();
  context.restore();
}

/** Distance of the tool's sign above the finger that covers its work, in px. */
const FINGER_PX = 62;

function drawFinger(context: CanvasRenderingContext2D, { view, palette }: EditFrame, atMm: Vec, tool: ToolId): void {
  const finger = toPx(view, atMm);
  const at = { x: finger.x, y: finger.y > FINGER_PX + 24 ? finger.y - FINGER_PX : finger.y + FINGER_PX };
  context.save();
  context.fillStyle = palette.handGround;
  context.strokeStyle = palette.hand;
  context.lineWidth = 2;
  context.beginPath();
  context.arc(at.x, at.y, 17, 0, 2 * Math.PI);
  context.fill();
  context.stroke();
  context.translate(at.x, at.y);
  context.scale(0.8, 0.8);
  context.translate(-12, -12);
  context.fillStyle = palette.hand;
  context.fill(signOf(tool));
  context.restore();
}

const signOf = memo((tool: ToolId) => new Path2D(toolSigns[tool]));

/** The objects of a course with these ids. */
export function objectsById(scene: Scene, ids: readonly string[]): readonly SceneObject[] {
  if (ids.length === 0) return [];
  const wanted = new Set(ids);
  return scene.objects.filter(({ id }) => wanted.has(id));
}
