import type { OptionValues } from '#core/option';
import { fetchDrawing } from '#robots/drawings';
import type { Mover, Scene } from '#scene/scene';
import type { DeviceSnapshot, Snapshot } from '#simulation/snapshot';
import { drawBlocks, drawMoving, type MovingScene } from '../../../pupil/arena/layers/draw-moving';
import type { RobotLook } from '../../../pupil/arena/model/arena-model';
import { deviceColor } from '#picture/device-colors';
import { lightPalette as palette } from '../../../pupil/arena/model/palette';
import { arranged } from '../../../pupil/arena/picture/arranged';
import { drawPill } from '../../../pupil/arena/picture/draw-pill';
import { drawScene } from '../../../pupil/arena/picture/draw-scene';
import * as zones from '../../../pupil/arena/picture/draw-zones';
import * as sheets from '../../../pupil/arena/picture/sheets';
import { createSceneKinds, type SceneKinds } from '../../../pupil/arena/picture/scene-kinds';
import { drawTrail } from '../../../pupil/arena/robot/draw-trail';
import { readRobotDrawing } from '../../../pupil/arena/robot/robot-drawing';
import type { RobotPainting } from '../../../pupil/arena/robot/robot-painting';
import { createSpriteShelf, emptyCanvas } from '../../../pupil/arena/robot/robot-sprite';
import { TreadShelf } from '../../../pupil/arena/robot/tread-sprite';
import { TurnedBody } from '../../../pupil/arena/robot/turned-body';
import { toPx, type View } from '../../../pupil/arena/view/view-transform';
import type { Trails } from '../../../session/run/trails';

/** A robot with what is plugged into it; `null`: a board alone. */
interface PaintedRobot {
  readonly robot: RobotLook | null;
  readonly options: OptionValues;
}

/** The parts of a run that are painted, besides its moments. */
export interface PaintedRun {
  /** The course as the run had it. */
  readonly scene: Scene;
  /** Its robots, by the place of their device; `null`: a board alone. */
  readonly robots: readonly (PaintedRobot | null)[];
  /** Their colours, as `deviceColor` takes them. */
  readonly colors: readonly number[];
  /** `null`: none is drawn. */
  readonly trails: Trails | null;
  /** Marks in place of the trails and of the numbers on several robots; left out: those. */
  readonly marks?: RunMarks;
}

/** Marks of robots below and above all of them, on a canvas in its own px. */
export interface RunMarks {
  under(context: CanvasRenderingContext2D, view: View, moment: Snapshot): void;
  over(context: CanvasRenderingContext2D, view: View, moment: Snapshot): void;
}

/** Paints moments of a run, all at the same size. */
export interface RunPainter {
  readonly widthPx: number;
  readonly heightPx: number;
  /** The arena at this moment, on a canvas of that size that the next call paints anew. */
  paint(moment: Snapshot): HTMLCanvasElement;
}

/** Room around the arena while it is painted, for what belongs to an arena on the screen: rulers and shadows. It is cut off. */
const RIM_PX = 64;

/** Longest wait for drawings and pictures, in ms. Chosen: those that cannot be read by then never come. */
const PATIENCE_MS = 3000;
/** Time without anything loaded after which all is taken to be there, in ms. */
const QUIET_MS = 120;

/**
 * Makes a painter, and waits until it has all that it needs: drawings of robots, pictures of the floor.
 *
 * @param longestPx the longer side of its pictures
 * @param first a moment of the run
 */
export async function runPainter(run: PaintedRun, longestPx: number, first: Snapshot): Promise<RunPainter> {
  let cameMs = performance.now();
  const came = (): void => void (cameMs = performance.now());
  const robots = await Promise.all(
    run.robots.map((one) => (one?.robot ? paintingOf(one.robot, one.options, came) : Promise.resolve(null))),
  );
  const painter = createPainter(run, robots, longestPx, came);
  const startMs = performance.now();
  came();
  while (performance.now() - cameMs < QUIET_MS && performance.now() - startMs < PATIENCE_MS) {
    painter.paint(first); // asks for what it needs
    await new Promise((resolve) => setTimeout(resolve, QUIET_MS / 3));
  }
  painter.forget();
  return painter;
}

async function paintingOf(look: RobotLook, options: OptionValues, redraw: () => void): Promise<RobotPainting> {
  const drawing = readRobotDrawing(await fetchDrawing(look.id, options));
  return {
    look,
    drawing,
    sprites: createSpriteShelf(drawing, redraw),
    turned: new TurnedBody(),
    treads: new TreadShelf(),
    redraw,
  };
}

function createPainter(
  { scene, trails, colors, marks }: PaintedRun,
  robots: readonly (RobotPainting | null)[],
  longestPx: number,
  came: () => void,
): RunPainter & { forget(): void } {
  const [widthMm, heightMm] = scene.size;
  const pxPerMm = longestPx / Math.max(widthMm, heightMm);
  const seen = { widthPx: Math.round(widthMm * pxPerMm), heightPx: Math.round(heightMm * pxPerMm) };
  const size = { widthPx: seen.widthPx + 2 * RIM_PX, heightPx: seen.heightPx + 2 * RIM_PX };
  const view: View = { pxPerMm, leftPx: RIM_PX, bottomPx: RIM_PX + seen.heightPx };
  const canvas = emptyCanvas(seen.widthPx, seen.heightPx);
  const context = contextOf(emptyCanvas(size.widthPx, size.heightPx));
  const paintTrail = trailPainter(size.widthPx, size.heightPx);
  const kinds = createSceneKinds(came);
  let still: { readonly look: string; readonly shown: Scene; readonly canvas: HTMLCanvasElement } | null = null;

  /** The still layer, painted once for each step of the task and each switching of a lamp or a barrier. */
  function stillAt({ verdict, ...moment }: Snapshot): HTMLCanvasElement {
    const { checkpoints, targets, blocks } = verdict ?? {};
    const shown = kinds.inRun(scene, moment);
    const look = [checkpoints?.passed, targets?.reached, blocks?.delivered].join();
    if (still?.look === look && still.shown === shown) return still.canvas;
    const painted = emptyCanvas(size.widthPx, size.heightPx);
    drawScene(contextOf(painted), view, { scene: shown, zones, sheets, kinds, verdict }, size, palette);
    still = { look, shown, canvas: painted };
    return painted;
  }
  function drawRobotOf(device: DeviceSnapshot, place: number, blocks: MovingScene['blocks']): void {
    const painting = robots[place];
    const { robot: now, display } = device;
    if (!painting || now === null) return;
    const nothing = { heldBlock: null, robotHeld: false, overlay: null, marks: null };
    const moving = { ...nothing, arena: scene.size, blocks, robot: { now, painting, scale: now.scale }, display };
    drawMoving(context, view, size, 1, moving, palette);
    if (robots.length < 2 || marks !== undefined) return;
    const at = toPx(view, { x: now.pose.xMm, y: now.pose.yMm });
    const look = { ground: deviceColor(colors[place] ?? place), height: 18, fontPx: 12 };
    drawPill(context, String(place + 1), at, size, palette, look);
  }
  return {
    ...seen,
    forget: () => (still = null),
    paint(moment) {
      const { blocks } = arranged(scene, moment);
      context.drawImage(stillAt(moment), 0, 0);
      trails?.lookAt(moment.timeUs);
      if (trails !== null)
        for (const place of robots.keys())
          paintTrail(context, (on) => drawTrail(on, view, trails.of(place), 0, traceOf(colors, place)));
      drawMovers(context, view, kinds, scene, moment);
      drawBlocks(context, view, blocks, palette);
      marks?.under(context, view, moment);
      for (const [place, device] of [moment, ...moment.others].entries()) drawRobotOf(device, place, blocks);
      marks?.over(context, view, moment);
      contextOf(canvas).drawImage(context.canvas, -RIM_PX, -RIM_PX);
      return canvas;
    },
  };
}

/** Draws the moving obstacles, and the tags on them and on blocks. */
function drawMovers(
  context: CanvasRenderingContext2D,
  view: View,
  kinds: SceneKinds,
  scene: Scene,
  { movers, blocks }: Snapshot,
): void {
  for (const mover of moversOf(scene)) kinds.mover(context, view, mover, movers[mover.id] ?? null, palette);
  for (const one of kinds.carried(scene.objects))
    kinds.carriedTag(context, view, one, movers[one.carrier.id] ?? blocks[one.carrier.id] ?? null, palette);
}

const moversOf = ({ objects }: Scene): readonly Mover[] =>
  objects.filter((object): object is Mover => object.type === 'mover');

/** One robot's trail is blue, those of several are in their colours. */
const traceOf = (colors: readonly number[], place: number) =>
  colors.length < 2 ? palette : { ...palette, trace: deviceColor(colors[place] ?? place) };

type Draw = (on: CanvasRenderingContext2D) => void;

/** A trail draws its rim under what is there: it gets a canvas of its own, one for all of them. */
function trailPainter(widthPx: number, heightPx: number): (context: CanvasRenderingContext2D, draw: Draw) => void {
  const own = contextOf(emptyCanvas(widthPx, heightPx));
  return (context, draw) => {
    own.clearRect(0, 0, widthPx, heightPx);
    draw(own);
    context.drawImage(own.canvas, 0, 0);
  };
}

/** The context of a canvas that is read often, and so is not held by a graphics card. @throws Error without one */
function contextOf(canvas: HTMLCanvasElement): CanvasRenderingContext2D {
  const context = canvas.getContext('2d', { willReadFrequently: true });
  if (context === null) throw new Error('no canvas');
  return context;
}
