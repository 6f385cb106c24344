import { degOf } from '#core/angle';
import { stopsOf } from '#scene/kinds/mover-way';
import { isZone } from '#scene/kinds/zone';
import type { Mover, Point, SceneObject } from '#scene/scene';

import { formOf, geometryOf, type Form } from '../form';
import type { Look } from '../look';
import { circle, group, type Geometry, type Paint, type Shape } from '../shapes';
import { framed, icon } from './block';
import { boxFrame, type PictureKind } from './kind';
import { closedWay, moverSign, moverSignRad } from './mover-sign';
import { toothed, toothedOutline, toothMm } from './teeth';

/** Boxes that move by themselves, with their way. */
export const mover: PictureKind<Mover> = {
  mark: wayShapes,
  body: (mover, look) => [group(mover.at, moverShapes(mover, mover.angle, look), mover.angle)],
  shade: (mover, fill) => group(mover.at, [{ ...moverOutline(mover), fill }], mover.angle),
  frame: boxFrame,
};

/** The outline of a mover, with its teeth. */
export const moverOutline = (mover: Mover): Geometry =>
  mover.spiked ? toothedOutline(formOf(mover)) : geometryOf(formOf(mover), 0, roundOf(mover, formOf(mover)));

const shortOf = ({ spiked }: Mover, form: Form): number =>
  Math.min(form.sizeMm.x, form.sizeMm.y) - (spiked ? 2 * toothMm(form) : 0);

const roundOf = (mover: Mover, form: Form): number => (mover.spiked ? 1.5 : Math.min(5, shortOf(mover, form) / 6));

/** A mover about its middle, as it is turned now: yellow, with the upright sign of what it does; with teeth if it is spiked. */
export function moverShapes(mover: Mover, turnDeg: number, look: Look): readonly Shape[] {
  const { mover: ground, moverLight, moverInk } = look.colors;
  const form = formOf(mover);
  const short = shortOf(mover, form);
  const depth = mover.spiked ? toothMm(form) : 0;
  return [
    ...(mover.spiked ? [toothed(form, look)] : []),
    ...framed(form, roundOf(mover, form), Math.min(3, short * 0.09), [ground, moverLight, moverInk], depth),
    group([0, 0], icon(moverSign(mover), short * 0.72, moverInk, look), degOf(moverSignRad(mover)) - turnDeg),
  ];
}

/**
 * The way of a mover on the floor: dashes from stop to stop, its outline where it turns round, and how long it waits.
 * Of one that chases, how far it notices robots, and a line to the zone that it guards.
 */
function wayShapes(mover: Mover, look: Look, around: readonly SceneObject[] = []): readonly Shape[] {
  const width = Math.max(1.5 * look.px, 2.5);
  const line = { stroke: look.colors.moverInk, opacity: 0.75, width };
  return mover.chases ? watchShapes(mover, around, line) : stopShapes(mover, look, line);
}

type Line = Paint & { readonly width: number };

function stopShapes(mover: Mover, look: Look, line: Line): readonly Shape[] {
  const stops = stopsOf(mover);
  const [last] = stops.slice(-1);
  if (last === undefined || stops.length < 2) return [];
  const { width } = line;
  const way = closedWay(mover, stops.map(({ at }) => at)); // prettier-ignore
  const end = { ...geometryOf(formOf(mover), 0, 4), ...line, dash: [2.4 * width, 2 * width] };
  return [
    { form: 'lines', lines: [way], ...line, dash: [3 * width, 2.4 * width] },
    ...stops
      .map(({ at }, i) => circle((i === 0 ? 1.6 : 2.6) * width, { ...line, fill: look.colors.floor }, at))
      .reverse(),
    ...stops.filter(({ wait }) => wait > 0).map(({ at, wait }) => waitShape(mover, at, wait, look)),
    ...(mover.loops ? [] : [group(last.at, [end], mover.angle)]),
  ];
}

/** How long a mover waits at a stop, written beside the mover, which may cover the stop. */
function waitShape(mover: Mover, at: Point, wait: number, { colors, px, seconds, leastTypeMm = 0 }: Look): Shape {
  const off = Math.min(...mover.size) / 2 + 6 * px;
  const size = Math.max(12 * px, leastTypeMm);
  return group(at, [
    {
      ...{ form: 'words', text: `${seconds(wait)} s`, at: [off, 0.355 * size - off], from: 'start', size },
      ...{ weight: 600, fill: colors.moverInk, rim: { color: colors.floor, width: 4 * px } },
    },
  ]);
}

/** A dotted circle as far as it notices robots, and a dotted line to the zone that it guards. */
function watchShapes({ at, chases }: Mover, around: readonly SceneObject[], line: Line): readonly Shape[] {
  const zone = around.filter(isZone).find(({ id }) => id === chases?.zone);
  const dotted: Paint = { ...line, cap: 'round', dash: [0, 3 * line.width] };
  return [
    ...(chases?.reach === undefined ? [] : [circle(chases.reach, dotted, at)]),
    ...(zone === undefined ? [] : [{ form: 'lines', lines: [[at, zone.at]], ...dotted } as const]),
  ];
}
