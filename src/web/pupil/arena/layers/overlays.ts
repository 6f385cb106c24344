/**
 * Overlays of the arena: the robot's trail, the cone of its distance sensor or the fan of its lidar, the readings of its line
 * sensors, its centre of rotation, and chains of lights on it. Loaded when the first of these is wanted.
 */
import type { Pose, Vec } from '#core/geometry';
import type { Rgb } from '#core/rgb';
import { createCache } from '../../../kit/drawing/shelf';
import { drawLightBoard, drawLights, RIM, type LightBoard } from '../../board/lights/draw-lights';
import { layOut } from '../../board/lights/light-form';
import type { LightForm } from '../../../session/work/settings/light-wish';
import type { ArenaOptions, ArenaRobot, RobotLook } from '../model/arena-model';
import { centreBox, drawCentre } from '../robot/draw-centre';
import { colourBoxes, drawColours } from '../robot/draw-colour';
import { drawSight, sightBox } from '../robot/draw-camera';
import { coneBox, drawCone, drawHit } from '../robot/draw-cone';
import { attachmentFrontMm } from '../robot/draw-attachments';
import { floorPx, sightPx } from '../picture/draw-floor';
import { drawFan, drawFanHits, fanBoxes, placeFan } from '../robot/draw-fan';
import { drawSpots, spotLabels, spotsBoxes, type LabelRow } from '../robot/draw-spots';
import { createTrailLayer, drawTail } from '../robot/draw-trail';
import { clipTo } from '../view/clip-to';
import { boxAround, unionOf, type PxBox } from '../view/moving-window';
import type { Palette } from '../model/palette';
import { resolutionStep } from '../robot/robot-sprite';
import { createTurnWatch } from '../robot/rotation-centre';
import type { Trail } from '../../../session/run/trail';
import { toPx, type ArenaSize, type CanvasSize, type View } from '../view/view-transform';

/** A robot as it is shown now. */
export interface ShownRobot {
  readonly now: ArenaRobot;
  readonly look: RobotLook;
  /** Size relative to the real robot. */
  readonly scale: number;
  readonly held: boolean;
}

/** Everything the overlays are drawn from. */
export interface OverlayParts {
  readonly options: ArenaOptions;
  readonly robot: ShownRobot | null;
  /** Simulated time, `null` before a run. */
  readonly timeUs: number | null;
  /** Simulated time for the cone's arcs, or `null` to freeze them. */
  readonly breathUs: number | null;
  readonly lights: readonly LightsOnRobot[];
  readonly trail: Trail;
  readonly trailCanvas: HTMLCanvasElement | null;
  readonly arena: ArenaSize;
  readonly view: View;
  readonly canvas: CanvasSize;
  /** Canvas pixels per CSS px. */
  readonly ratio: number;
  readonly palette: Palette;
}

/** A chain of lights on the robot. */
export interface LightsOnRobot {
  readonly form: LightForm;
  readonly colors: readonly Rgb[];
}

/** The parts of the picture under and over the robot, in CSS px. */
export interface OverlayPicture {
  /** The areas in which it draws. */
  readonly boxes: readonly PxBox[];
  under(context: CanvasRenderingContext2D): void;
  over(context: CanvasRenderingContext2D): void;
}

/** Makes the pictures of one arena, each from the newest state. */
export interface Overlays {
  picture(parts: OverlayParts, nowMs: number): OverlayPicture;
}

/** Begins without a past: the centre of rotation shows after the next movement. */
export function createOverlays(): Overlays {
  const turns = createTurnWatch();
  const layer = createTrailLayer();
  const boards = createBoardShelf();
  return {
    picture(parts, nowMs) {
      const { options, robot, view, palette, canvas, trail, trailCanvas } = parts;
      turns.note(parts.timeUs === null || robot === null ? null : { ...robot.now, timeUs: parts.timeUs });
      if (trailCanvas !== null) {
        const { arena, ratio } = parts;
        layer.paint([{ trail, palette }], { canvas: trailCanvas, ...canvas, ratio, view, arena }, nowMs);
      }
      if (robot === null) return NOTHING;
      const { pose } = robot.now;
      const tail = trailCanvas === null ? [] : tailOf(layer.tail(trail, view), robot, view);
      const centre = options.centre && !robot.held ? turns.centre() : null;
      const spots = options.spots ? robot.now.state.lineSensors : [];
      const hitMm = options.cone ? robot.now.state.ultrasonic?.hitMm : null;
      const colours = options.cone && !robot.held ? (robot.now.state.colours ?? []) : [];
      const sight = sightPx(view, parts.arena, canvas);
      const fan = fanPicture(parts, robot, sight);
      const sights = [fan, conePicture(parts, robot), cameraPicture(parts, robot)].filter((one) => one !== null);
      const hit = fan?.nearest ?? (hitMm ? toPx(view, hitMm) : null);
      const row: LabelRow = { ...lengthOf(robot), sight, hit };
      const labels = spotLabels(view, pose, robot.scale, row, spots);
      const chains = parts.lights.map(({ form, colors }) => ({
        ...placeOf(form, colors.length, robot),
        colors,
        form,
      }));
      return {
        boxes: [
          ...(tail.length === 0 ? [] : [unionOf(tail.map((point) => boxAround(point, 4)))]),
          ...sights.flatMap(({ boxes }) => boxes),
          ...colourBoxes(colours, view),
          ...(centre === null ? [] : [centreBox(centre, pose, view)]),
          ...(spots.length === 0 ? [] : spotsBoxes(view, pose, robot.scale, spots, labels)),
          ...chains.map(({ atMm, reachMm }) => boxAround(toPx(view, atMm), reachMm * view.pxPerMm)),
        ],
        under(context) {
          drawTail(context, tail, palette);
          for (const one of sights) one.under(context);
        },
        over(context) {
          for (const { atMm, unitMm, colors, form } of chains) {
            const board = boards.at(form, colors.length, unitMm * view.pxPerMm * parts.ratio);
            drawChain(context, view, pose, atMm, unitMm, board, colors);
          }
          if (spots.length > 0) drawSpots(context, view, pose, robot.scale, spots, labels, palette);
          if (centre !== null) drawCentre(context, view, centre, pose, canvas, palette);
          for (const one of sights) one.over(context);
          drawColours(context, colours, view, canvas, palette);
        },
      };
    },
  };
}

const NOTHING: OverlayPicture = { boxes: [], under: () => undefined, over: () => undefined };

/** The fan of a lidar, and the place of its nearest hit, px; `null`: none is shown. */
function fanPicture(
  { options, view, arena, canvas, palette }: OverlayParts,
  { now, held }: ShownRobot,
  sight: PxBox,
): (OverlayPicture & { readonly nearest: Vec | null }) | null {
  const { lidar } = now.state;
  if (lidar === null || !options.cone || held) return null;
  const fan = placeFan(lidar, view, sight);
  return {
    nearest: fan.nearest,
    boxes: fanBoxes(fan),
    under(context) {
      context.save();
      clipTo(context, floorPx(view, arena));
      drawFan(context, fan, palette);
      context.restore();
    },
    over: (context) => drawFanHits(context, fan, canvas, palette),
  };
}

/** Room around the label of the distance, in px. */
const LABEL_PX = 80;

/** The cone of the distance sensor; `null`: none is shown. */
function conePicture(
  { options, view, arena, canvas, palette, breathUs }: OverlayParts,
  { now, held }: ShownRobot,
): OverlayPicture | null {
  const cone = now.state.ultrasonic;
  if (cone === null || !options.cone || held) return null;
  return {
    boxes: [coneBox(cone, view), ...(cone.hitMm ? [boxAround(toPx(view, cone.hitMm), LABEL_PX)] : [])],
    under(context) {
      context.save();
      clipTo(context, floorPx(view, arena));
      drawCone(context, view, cone, breathUs, palette);
      context.restore();
    },
    over: (context) => drawHit(context, view, cone, canvas, palette),
  };
}

/** The part of the floor that the camera sees; `null`: none is shown. */
function cameraPicture(
  { options, view, arena, palette }: OverlayParts,
  { now, held }: ShownRobot,
): OverlayPicture | null {
  const { camera } = now.state;
  if (camera === undefined || !options.cone || held) return null;
  return {
    boxes: [sightBox(camera, view)],
    under(context) {
      context.save();
      clipTo(context, floorPx(view, arena));
      drawSight(context, camera, view, palette);
      context.restore();
    },
    over: () => undefined,
  };
}

/** Extent of the robot ahead of and behind its axle, with its attachments, in mm. */
function lengthOf({ now, look, scale }: ShownRobot): Pick<LabelRow, 'frontMm' | 'backMm'> {
  const xs = look.body.outlineMm.flat().map(({ x }) => x);
  const frontMm = Math.max(...xs, attachmentFrontMm(now.state.attachments));
  return { frontMm: frontMm * scale, backMm: -Math.min(...xs) * scale };
}

/** The points up to the robot, unless the hand has it. */
function tailOf(points: Vec[], { now, held }: ShownRobot, view: View): Vec[] {
  return points.length === 0 || held ? points : [...points, toPx(view, { x: now.pose.xMm, y: now.pose.yMm })];
}

/** Distance between lights on rings and sticks by Adafruit, in mm; a chain too long for the robot is drawn smaller. */
const UNIT_MM = 7.7;
const WIDEST_MM = 92;

/** Place of a chain on the robot, in the world, and its size in mm. */
export function placeOf(form: LightForm, count: number, { now, look, scale }: Omit<ShownRobot, 'held'>) {
  const xs = look.body.outlineMm.flat().map(({ x }) => x);
  const middle = ((Math.min(...xs) + Math.max(...xs)) / 2) * scale;
  const { halfWidth, halfHeight } = layOut(form, count);
  const unitMm = Math.min(UNIT_MM, WIDEST_MM / 2 / Math.max(halfWidth, halfHeight)) * scale;
  const { xMm, yMm, headingRad } = now.pose;
  return {
    atMm: { x: xMm + Math.cos(headingRad) * middle, y: yMm + Math.sin(headingRad) * middle },
    unitMm,
    reachMm: Math.hypot(halfWidth + RIM, halfHeight + RIM) * unitMm,
  };
}

function drawChain(
  context: CanvasRenderingContext2D,
  view: View,
  pose: Pose,
  atMm: Vec,
  unitMm: number,
  board: LightBoard,
  colors: LightsOnRobot['colors'],
): void {
  const at = toPx(view, atMm);
  const unitPx = unitMm * view.pxPerMm;
  context.save();
  context.translate(at.x, at.y);
  context.rotate(Math.PI / 2 - pose.headingRad);
  context.scale(unitPx, unitPx);
  drawLights(context, board, colors);
  context.restore();
}

/** Cache of drawn boards of chains: zooming and driving request the same ones again and again. */
function createBoardShelf() {
  const made = createCache<LightBoard>(12);
  return {
    /** A board with at least this many canvas pixels per distance between lights. */
    at(form: LightForm, count: number, unit: number): LightBoard {
      const fine = Math.SQRT2 ** resolutionStep(unit);
      return made([form, count, fine], () => drawLightBoard(layOut(form, count), fine));
    },
  };
}
