import type { Vec } from '#core/geometry';
import { isSame } from '#core/same';
import type { Barrier, Scene, Wall } from '#scene/scene';
import { distanceMm, middleBetween, minus, toVec } from '../plane';
import { otherWalls, snappedTo } from '../snap';
import type { Drag } from '../tools/tool';
import { mirroredPoint, scaledPoint, shifted, type Axis } from './kind';
import { lineHandles, turnedEnds } from './line';

type Straight = Wall | Barrier;

/** Shared by what runs straight from one end to another; no edit leaves it without length. */
export const straight = {
  place: ({ from }: Straight) => from,
  span: ({ from, to }: Straight) => minus(toVec(to), toVec(from)),
  middle: ({ from, to }: Straight) => middleBetween(toVec(from), toVec(to)),
  extentMm: ({ from, to }: Straight) => distanceMm(toVec(from), toVec(to)),
  moved: <O extends Straight>(line: O, dx: number, dy: number): O => ({
    ...line,
    from: shifted(line.from, dx, dy),
    to: shifted(line.to, dx, dy),
  }),
  // At the very end of what a course may hold a turn could press the ends together.
  turned: <O extends Straight>(line: O, pivot: Vec, angleDeg: number): O =>
    withEnds(line, ...turnedEnds(line.from, line.to, pivot, angleDeg)) ?? line,
  mirrored: <O extends Straight>(line: O, axis: Axis, atMm: number): O => ({
    ...line,
    from: mirroredPoint(line.from, axis, atMm),
    to: mirroredPoint(line.to, axis, atMm),
  }),
  scaled: <O extends Straight>(line: O, about: Vec, factor: Vec): O | null =>
    withEnds(line, scaledPoint(line.from, about, factor), scaledPoint(line.to, about, factor)),
  handles: ({ id, from, to, thickness }: Straight, reachMm: number) => lineHandles(id, [from, to], thickness, reachMm),
  endMoved<O extends Straight>(
    line: O,
    end: 'from' | 'to',
    place: Vec,
    { reachMm, free, lure }: Drag,
    scene: Scene,
  ): O | null {
    const stays = end === 'from' ? line.to : line.from;
    const to = snappedTo(stays, place, otherWalls(scene, line), { size: scene.size, reachMm, free, lure });
    return isSame(stays, to) ? null : { ...line, [end]: to };
  },
};

/** A line with other ends; `null`: it would have no length. */
export const withEnds = <O extends Straight>(line: O, from: O['from'], to: O['to']): O | null =>
  isSame(from, to) ? null : { ...line, from, to };
