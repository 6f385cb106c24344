import type { Vec } from '#core/geometry';
import { sceneLimits, type Mover, type Point } from '#scene/scene';
import { endOf } from '../drag';
import { pointFields } from '../object-fields';
import { distanceMm, toPoint, toVec } from '../plane';
import { alongEighths, shortenedInto, wholeCentimetres } from '../snap';
import type { Drag } from '../tools/tool';
import { boxed, boxFields } from './box';
import { mirroredPoint, scaledPoint, shifted, type EditorKind } from './kind';
import { turnedExtent } from './line';

/** Length of the path of a mover that was put by a tap, in mm. Chosen: two cells of the arena's grid. */
const USUAL_TRACK_MM = 200;

/** Boxes that go to and fro: moved, sized and turned together with their track. */
export const mover: EditorKind<Mover> = {
  layer: 3,
  ...boxed,
  moved,
  turned(mover, pivot, angleDeg) {
    const turned = boxed.turned(mover, pivot, angleDeg);
    const [x, y] = turnedExtent(mover.at, mover.to, angleDeg);
    return { ...turned, to: toPoint({ x: turned.at[0] + x, y: turned.at[1] + y }) };
  },
  mirrored: (mover, axis, atMm) => ({
    ...boxed.mirrored(mover, axis, atMm),
    to: mirroredPoint(mover.to, axis, atMm),
  }),
  scaled(mover, about, factor) {
    const scaled = boxed.scaled(mover, about, factor);
    return scaled && { ...scaled, to: scaledPoint(mover.to, about, factor) };
  },
  handles: (mover, reachMm) => [...boxed.handles(mover, reachMm), { kind: 'to', at: toVec(mover.to), id: mover.id }],
  sized(mover, side, place, drag) {
    const { at, to } = mover;
    const sized = boxed.sized(mover, side, place, drag);
    return sized && { ...sized, to: toPoint({ x: to[0] + sized.at[0] - at[0], y: to[1] + sized.at[1] - at[1] }) };
  },
  endMoved: (mover, _end, place, drag, scene) => ({ ...mover, to: turningPoint(place, mover.at, scene.size, drag) }),
  fields: (mover) => [
    ...boxFields(mover, moved),
    ...pointFields(mover.to, (to) => ({ ...mover, to }), ['endX', 'endY']),
    {
      ...{ kind: 'number', name: 'speed', value: mover.speed, ...sceneLimits.speedMmS, step: 5, unit: 'mm/s' },
      with: (speed: number) => ({ ...mover, speed }),
    },
    { kind: 'switch', name: 'spiked', value: mover.spiked, with: (spiked: boolean) => ({ ...mover, spiked }) },
  ],
  made: (id, at, { size }, { blockSize, moverSpeed, moverSpiked }) => ({
    type: 'mover',
    id,
    at,
    to: usualTurningPoint(at, size),
    size: blockSize,
    angle: 0,
    speed: moverSpeed,
    spiked: moverSpiked,
  }),
  dragged: (mover, drag, arena) => ({ ...mover, to: turningPoint(endOf(drag), mover.at, arena, drag) }),
};

function moved(mover: Mover, dx: number, dy: number): Mover {
  return { ...mover, at: shifted(mover.at, dx, dy), to: shifted(mover.to, dx, dy) };
}

/** The turning point of a mover during its drag: in one of the eight directions, unless free; never at its start. */
function turningPoint(place: Vec, at: Point, arena: Point, { free, reachMm, lure }: Drag): Point {
  const start = toVec(at);
  const way = shortenedInto(start, free ? place : alongEighths(start, place), arena);
  const to = toPoint(free ? way : wholeCentimetres(start, way, reachMm, lure));
  return distanceMm(start, toVec(to)) < sceneLimits.blockMm.min ? usualTurningPoint(at, arena) : to;
}

/** To the right, or to the left where there is more room. */
function usualTurningPoint([x, y]: Point, [width]: Point): Point {
  const way = Math.min(USUAL_TRACK_MM, Math.max(width - x, x));
  return x + way <= width ? [x + way, y] : [x - way, y];
}
