import { radOf } from '#core/angle';
import type { Pose, Vec } from '#core/geometry';
import { memoOf } from '#core/memo';
import { fanOf, type FanRay } from '#robots/lidar-fan';
import type { LidarState } from '#robots/robot';
import type { Scene, SceneObject } from '#scene/scene';
import { t } from '../../../kit/i18n';
import type { Palette } from '../model/palette';
import type { PlacedBlock } from '../model/arena-model';
import { drawPill } from '../picture/draw-pill';
import { boxAround, type PxBox } from '../view/moving-window';
import { toPx, type CanvasSize, type View } from '../view/view-transform';
import words from '../words';
import { OPEN_REACH_MM } from './draw-fan';

/** Things that end below this lie under the rays at eye level, in mm. Chosen: a lens is 104 mm high. */
const LOW_MM = 100;

/** A thing that is lower than a lidar's lens, and says so in its course. */
export interface LowThing {
  readonly id: string;
  readonly atMm: Vec;
  /** How far it reaches upwards on the screen from there. */
  readonly upMm: number;
  readonly heightMm: number;
}

/** The height that the course gives a thing, in mm; `null`: it gives none. */
function givenHeightOf(object: SceneObject): number | null {
  const height: unknown = 'height' in object ? object.height : undefined;
  return typeof height === 'number' ? height : null;
}

/** The low things of a course where they start, in its order. */
export const lowThingsOf = memoOf((objects: Scene['objects']): readonly LowThing[] =>
  objects.flatMap((object) => {
    const heightMm = givenHeightOf(object);
    const place = heightMm === null || heightMm >= LOW_MM ? null : placeOf(object);
    return place === null || heightMm === null ? [] : [{ id: object.id, heightMm, ...place }];
  }),
);

function placeOf(object: SceneObject): Pick<LowThing, 'atMm' | 'upMm'> | null {
  if (object.type === 'wall') {
    const [from, to] = [object.from, object.to];
    return { atMm: { x: (from[0] + to[0]) / 2, y: (from[1] + to[1]) / 2 }, upMm: object.thickness / 2 };
  }
  if (object.type !== 'block' && object.type !== 'fixed-block' && object.type !== 'spikes') return null;
  const [x, y] = object.at;
  const rad = radOf(object.angle);
  return { atMm: { x, y }, upMm: upOf({ x: object.size[0], y: object.size[1] }, rad) };
}

const upOf = (sizeMm: Vec, rad: number): number =>
  (Math.abs(Math.sin(rad)) * sizeMm.x + Math.abs(Math.cos(rad)) * sizeMm.y) / 2;

/** The low things that lie under the rays of a lidar, the blocks among them where they are now. */
export function lowUnder(
  lidar: LidarState,
  things: readonly LowThing[],
  blocks: readonly PlacedBlock[],
): readonly LowThing[] {
  if (things.length === 0) return things;
  const rays = fanOf(lidar);
  return things.map((thing) => whereNow(thing, blocks)).filter(({ atMm }) => isUnder(atMm, lidar, rays));
}

function whereNow(thing: LowThing, blocks: readonly PlacedBlock[]): LowThing {
  const block = blocks.find(({ id }) => id === thing.id);
  if (block === undefined) return thing;
  const { xMm, yMm, headingRad }: Pose = block.pose;
  return { ...thing, atMm: { x: xMm, y: yMm }, upMm: upOf(block.sizeMm, headingRad) };
}

/** True if a place is nearer than what the ray beside it meets. */
function isUnder({ x, y }: Vec, lidar: LidarState, rays: readonly FanRay[]): boolean {
  const [cos, sin] = [Math.cos(lidar.headingRad), Math.sin(lidar.headingRad)];
  const [dx, dy] = [x - lidar.fromMm.x, y - lidar.fromMm.y];
  const [depthMm, leftMm] = [dx * cos + dy * sin, dy * cos - dx * sin];
  if (depthMm <= 0) return false;
  const angle = Math.atan2(leftMm, depthMm);
  if (Math.abs(angle) > lidar.openingRad / 2) return false;
  const column = Math.min(rays.length - 1, Math.floor((0.5 - angle / lidar.openingRad) * rays.length));
  return depthMm < (rays[column]?.depthMm ?? OPEN_REACH_MM);
}

/** Distance of the word from the thing, in px. */
const WORD_PX = 11;

/** The areas of the words on low things, in CSS px. */
export const lowBoxes = (things: readonly LowThing[], view: View): readonly PxBox[] =>
  things.map(({ atMm, upMm }) => boxAround(toPx(view, atMm), Math.max(60, upMm * view.pxPerMm + 2 * WORD_PX)));

/** Says of each thing that it is low, and how high it is. */
export function drawLow(
  context: CanvasRenderingContext2D,
  view: View,
  things: readonly LowThing[],
  canvas: CanvasSize,
  palette: Palette,
): void {
  const look = { ground: palette.movable, ink: palette.movableInk, height: 18, fontPx: 12 };
  for (const { atMm, upMm, heightMm } of things) {
    const at = toPx(view, atMm);
    drawPill(context, t(words.lidar.cm, { cm: Math.round(heightMm) / 10 }), at, canvas, palette, look);
    const above = { x: at.x, y: at.y - Math.max(upMm * view.pxPerMm + WORD_PX, 20) };
    drawPill(context, t(words.lidar.low), above, canvas, palette, { ...look, ground: palette.floor });
  }
}
