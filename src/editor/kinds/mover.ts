import { isSame } from '#core/same';
import { heightProperty } from '#scene/kinds/heights';
import { moverWays, stopsOf, wayOf, withPlaces, withStops, type MoverWay } from '#scene/kinds/mover-way';
import { sceneLimits, type Mover, type Point } from '#scene/scene';
import { endOf } from '../drag';
import { heightField, type Field } from '../object-fields';
import { distanceMm, toPoint } from '../plane';
import type { Handle } from '../tools/tool';
import { boxed, boxFields } from './box';
import { mirroredPoint, scaledPoint, shifted, type EditorKind } from './kind';
import { turnedExtent } from './line';
import { travels, withWay } from './mover-does';
import { stopDragged, stopHandles, stopPlace, withoutStop } from './mover-stops';
import type { ShapeName } from '#scene/shape/shape';
import { shapeField } from './shapes';

/** Boxes that move by themselves: moved, sized and turned together with their way. */
export const mover: EditorKind<Mover> = {
  layer: 3,
  ...boxed,
  moved,
  turned(mover, pivot, angleDeg) {
    const turned = boxed.turned(mover, pivot, angleDeg);
    return withPlaces({ ...turned, at: mover.at }, (at) => {
      const [x, y] = turnedExtent(mover.at, at, angleDeg);
      return toPoint({ x: turned.at[0] + x, y: turned.at[1] + y });
    });
  },
  handles(mover, reachMm) {
    const handles = [...boxed.handles(mover, reachMm), ...stopHandles(mover, reachMm)];
    const isCovered = ({ at }: Handle): boolean =>
      handles.some((other) => other.kind !== 'add' && distanceMm(at, other.at) < 1.6 * reachMm);
    return handles.filter((handle) => handle.kind !== 'add' || !isCovered(handle));
  },
  mirrored: (mover, axis, atMm) => ({
    ...boxed.mirrored(mover, axis, atMm),
    ...placesOf(mover, (at) => mirroredPoint(at, axis, atMm)),
  }),
  scaled(mover, about, factor) {
    const scaled = boxed.scaled(mover, about, factor);
    return scaled && { ...scaled, ...placesOf(mover, (at) => scaledPoint(at, about, factor)) };
  },
  sized(mover, side, place, drag) {
    const sized = boxed.sized(mover, side, place, drag);
    return sized && { ...moved(mover, sized.at[0] - mover.at[0], sized.at[1] - mover.at[1]), size: sized.size };
  },
  pointMoved(mover, handle, place, drag, scene) {
    const changed = stopDragged(mover, handle, place, drag, scene.size);
    return isSame(changed, mover) ? null : changed;
  },
  withoutPoint: withoutStop,
  fields: (mover) => [
    ...boxFields(mover, moved),
    heightField(mover),
    {
      ...{ kind: 'choice', name: 'way', value: wayOf(mover), choices: moverWays },
      with: (way: MoverWay, scene) => withWay(mover, way, scene),
    },
    shapeField<Mover>(mover, ['rectangle', 'round'], (bare, shape) => ({ ...bare, ...roundOf(shape) })),
    {
      ...{ kind: 'number', name: 'speed', value: mover.speed, ...sceneLimits.speedMmS, step: 5, unit: 'mm/s' },
      with: (speed: number) => ({ ...mover, speed }),
    },
    ...wayFields(mover),
    {
      ...{ kind: 'number', name: 'spin', value: mover.spin ?? 0, ...sceneLimits.spinDegS, step: 15, unit: 'deg/s' },
      with: (spin: number) => withSpin(mover, spin),
    },
    { kind: 'switch', name: 'spiked', value: mover.spiked, with: (spiked: boolean) => ({ ...mover, spiked }) },
  ],
  made(id, at, scene, options) {
    const { blockSize, blockShape, blockHeight, moverSpeed, moverSpiked, moverWay, moverWait, moverSpin } = options;
    const plain: Mover = {
      ...{ type: 'mover', id, at, to: at, size: blockSize, angle: 0, speed: moverSpeed, spiked: moverSpiked },
      ...roundOf(blockShape),
      ...heightProperty('mover', blockHeight),
    };
    const mover = withWay(withSpin(plain, moverSpin), moverWay, scene);
    return travels(mover) ? withStops(mover, stopsOf(mover).map((stop) => ({ ...stop, wait: moverWait }))) : mover; // prettier-ignore
  },
  dragged(mover, drag, arena) {
    if (!travels(mover)) return boxed.dragged(mover, drag, arena);
    const to = stopPlace(endOf(drag), mover.at, arena, drag);
    const [dx, dy] = [to[0] - mover.to[0], to[1] - mover.to[1]];
    return { ...mover, to, ...(mover.stops ? { stops: mover.stops.map((stop) => shifted(stop, dx, dy)) } : {}) };
  },
};

/** All places of a mover, each at another. */
function placesOf(mover: Mover, place: (at: Point) => Point): Pick<Mover, 'at' | 'to' | 'stops'> {
  const { at, to, stops } = withPlaces(mover, place);
  return { at, to, ...(stops ? { stops } : {}) };
}

/** Movers are rectangles or round. */
const roundOf = (shape: ShapeName): { readonly round?: true } => (shape === 'round' ? { round: true } : {});

function moved(mover: Mover, dx: number, dy: number): Mover {
  return withPlaces(mover, (at) => shifted(at, dx, dy));
}

/** The fields of a path, and of a chase. */
function wayFields(mover: Mover): readonly Field<Mover>[] {
  const { chases, phase: _phase, ...rest } = mover;
  if (chases)
    return [
      {
        ...{ kind: 'number', name: 'reach', value: chases.reach ?? 0, min: 0, max: sceneLimits.reachMm.max },
        ...{ step: 50, unit: 'mm' },
        with: (mm: number) => withReach(mover, mm),
      },
    ];
  if (!travels(mover)) return [];
  return [
    {
      ...{ kind: 'number', name: 'phase', value: mover.phase ?? 0, ...sceneLimits.phaseSeconds, step: 0.5, unit: 's' },
      with: (phase: number) => (phase === 0 ? rest : { ...rest, phase }),
    },
  ];
}

/** A mover that notices robots as far as this; with less than the least reach, at any distance. */
function withReach(mover: Mover, mm: number): Mover {
  const { reach: _reach, ...chases } = mover.chases ?? {};
  return { ...mover, chases: mm < sceneLimits.reachMm.min ? chases : { ...chases, reach: mm } };
}

/** A mover with another spin, in degrees per second; 0 is left out. */
function withSpin(mover: Mover, spin: number): Mover {
  const { spin: _spin, ...rest } = mover;
  return spin === 0 ? rest : { ...rest, spin };
}
