import type { Vec } from '#core/geometry';
import { sceneLimits, type Block, type Mover, type Point, type Scene, type Spikes } from '#scene/scene';
import { draggedBox, tappedMiddle } from '../box';
import { endOf, isTap, startOf } from '../drag';
import { addingOnce } from '../edits';
import { freeIds } from '../ids';
import { distanceMm, toPoint, toVec } from '../plane';
import { alongEighths, isInArena, shortenedInto, wholeCentimetres } from '../snap';
import type { Drag, Tool, ToolOptions } from './tool';

/** How far a mover goes that was put by a tap, in mm. Chosen: two cells of the arena's grid. */
const USUAL_TRACK_MM = 200;

/** Puts a block, fixed block, spikes or mover: a tap in the size of the options, a drag in its own size or track. */
export const blockTool: Tool = {
  id: 'block',
  cursor: 'crosshair',
  edit(drag, { scene, options }) {
    if (!isInArena(startOf(drag), scene.size, drag.reachMm)) return null;
    const object =
      options.block === 'mover' ? moverOf(drag, scene, options) : boxOf(drag, scene, options, options.block);
    return addingOnce(scene, object);
  },
};

function boxOf(
  drag: Drag,
  scene: Scene,
  { blockSize }: ToolOptions,
  type: 'block' | 'fixed-block' | 'spikes',
): Block | Spikes {
  const { at, size } = isTap(drag)
    ? { at: tappedMiddle(drag, scene.size), size: blockSize }
    : draggedBox(drag, scene.size);
  return { type, id: freeIds(scene)(type), at, size, turn: 0 };
}

function moverOf(drag: Drag, scene: Scene, { blockSize, moverSpeed, moverSpiked }: ToolOptions): Mover {
  const at = tappedMiddle(drag, scene.size);
  return {
    type: 'mover',
    id: freeIds(scene)('mover'),
    at,
    to: isTap(drag) ? usualTurningPoint(at, scene.size) : turningPoint(endOf(drag), at, scene.size, drag),
    size: blockSize,
    turn: 0,
    speed: moverSpeed,
    spiked: moverSpiked,
  };
}

/** Where a mover turns whose turning point is dragged: in one of the eight directions, unless free; never where it starts. */
export function turningPoint(place: Vec, at: Point, arena: Point, { free, reachMm }: Drag): Point {
  const start = toVec(at);
  const way = shortenedInto(start, free ? place : alongEighths(start, place), arena);
  const to = toPoint(free ? way : wholeCentimetres(start, way, reachMm));
  return distanceMm(start, toVec(to)) < sceneLimits.blockMm.min ? usualTurningPoint(at, arena) : to;
}

/** To the right, or to the left where there is more room. */
export function usualTurningPoint([x, y]: Point, [width]: Point): Point {
  const way = Math.min(USUAL_TRACK_MM, Math.max(width - x, x));
  return x + way <= width ? [x + way, y] : [x - way, y];
}
