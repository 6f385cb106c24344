import { fixedBlock } from '#picture/kinds/block';
import type { Scene, SceneObject, Wall } from '#scene/scene';
import type { Verdict } from '#simulation/task/verdict';
import { drawStanding, drawWalls } from './draw-bodies';
import { drawFloor, drawFloorGrid, drawRim, floorPx } from './draw-floor';
import { drawRulers } from './draw-rulers';
import { drawStroke } from './draw-stroke';
import type { Palette } from '../model/palette';
import type * as Zones from './draw-zones';
import type { SceneKinds } from './scene-kinds';
import type * as Sheets from './sheets';
import type { PaintList } from './still-cache';
import type { CanvasSize, View } from '../view/view-transform';

/** The still things, at one moment. */
export interface StillScene {
  /** Drawn from it: size, background, and all objects but those that can be pushed or move by themselves. */
  readonly scene: Scene;
  /** The drawing of zones; `null` until it has come, or is not needed. */
  readonly zones: typeof Zones | null;
  /** The drawing of coloured sheets, likewise. */
  readonly sheets: typeof Sheets | null;
  /** The drawing of obstacles, words and the background, likewise. */
  readonly kinds: SceneKinds | null;
  readonly verdict: Verdict | null;
}

/** Paints a layer of what stands still, or its cached picture. */
export type PaintObjects = (
  context: CanvasRenderingContext2D,
  paint: PaintList<SceneObject>,
  layer: 'lines' | 'standing',
) => void;

/**
 * Draws everything in a course that does not move: floor, background, grid, zones, lines, words, walls, fixed blocks,
 * spikes, rulers. Drawn again only when the course, the view or the theme changes.
 *
 * @param context draws in CSS px
 * @param keep paints lines and walls, which may be many, from a cache
 */
export function drawScene(
  context: CanvasRenderingContext2D,
  view: View,
  still: StillScene,
  canvas: CanvasSize,
  palette: Palette,
  keep?: PaintObjects,
): void {
  const { scene, zones, kinds } = still;
  const paint: PaintObjects = keep ?? ((on, paintObjects) => paintObjects(on, scene.objects, scene.objects));
  drawFloor(context, view, scene.size, canvas, palette);
  const floor = floorPx(view, scene.size);
  context.save();
  context.beginPath();
  context.rect(floor.left, floor.top, floor.width, floor.height);
  context.clip();
  if (scene.background !== null) kinds?.background(context, view, scene.background);
  // On a background the grid only darkens: light lines across black would look printed.
  if (scene.background !== null) context.globalCompositeOperation = 'multiply';
  drawFloorGrid(context, view, scene.size, canvas, palette);
  context.globalCompositeOperation = 'source-over';
  zones?.drawZones(context, view, scene, palette, still.sheets);
  paint(context, (on, objects) => drawLines(on, view, objects, palette), 'lines');
  zones?.drawZoneSigns(context, view, scene, still.verdict, palette);
  paint(context, (on, ...objects) => drawWhatStands(on, view, objects, palette, kinds), 'standing');
  context.restore();
  drawRim(context, view, scene.size, palette);
  drawRulers(context, view, scene.size, canvas, palette);
}

function drawLines(
  context: CanvasRenderingContext2D,
  view: View,
  objects: readonly SceneObject[],
  palette: Palette,
): void {
  for (const object of objects) if (object.type === 'stroke') drawStroke(context, view, object, palette);
}

/** Draws words and ways on the floor, then what stands on it and never moves: walls, fixed blocks, spikes. */
function drawWhatStands(
  context: CanvasRenderingContext2D,
  view: View,
  [objects, all]: readonly [readonly SceneObject[], readonly SceneObject[]],
  palette: Palette,
  kinds: SceneKinds | null,
): void {
  kinds?.signs(context, view, objects, palette);
  drawWalls(context, view, objects.filter(isWall), palette, all.filter(isWall));
  for (const object of objects)
    if (object.type === 'fixed-block') drawStanding(context, view, fixedBlock, object, palette);
  kinds?.spikes(context, view, objects, palette);
}

const isWall = (object: SceneObject): object is Wall => object.type === 'wall';
