import type { Kind } from '#editor/describe-edit';
import type { AnyObject } from '#scene/kinds/kind';
import { stopsOf, wayOf } from '#scene/kinds/mover-way';
import type {
  Barrier,
  Label,
  Lamp,
  Mover,
  Point,
  Scene,
  SceneObject,
  Start,
  Stroke,
  Tag,
  Wall,
  Zone,
} from '#scene/scene';

import { shownLanguage, t } from '../../../kit/i18n';
import { numberText } from '../../../kit/i18n/number-text';
import words from '.';
import kindNames from './kinds';
import moverWords from './movers';

const texts = words.where;

/** Converts mm to cm, with at most one decimal. */
export const cm = (mm: number): number => Math.round(mm) / 10;

/** A place in cm: `10 | 20`. */
export function placeText([x, y]: Point): string {
  const language = shownLanguage();
  return `${numberText(cm(x), language)} | ${numberText(cm(y), language)}`;
}

/** A single object by the name of its kind, several with their number: `Wand`, `3 Wände`. */
export const countText = (kind: Kind, count: number): string =>
  count === 1 ? t(kindNames[kind].one) : `${String(count)} ${t(kindNames[kind].many)}`;

/** The name of each object: `Wand 3`. A checkpoint goes by its own number, a label by its text. */
export function namesOf(scene: Scene): ReadonlyMap<string, string> {
  const counts = new Map<string, number>();
  return new Map(
    scene.objects.map((object) => {
      const count = (counts.get(object.type) ?? 0) + 1;
      counts.set(object.type, count);
      return [object.id, nameOf(object, count)];
    }),
  );
}

function nameOf(object: SceneObject, count: number): string {
  const kind = t(kindNames[object.type].one);
  return kindWords[object.type].name?.(object, kind) ?? `${kind} ${String(count)}`;
}

/** How the objects of a kind are named and located. */
interface KindWords<O extends AnyObject = SceneObject> {
  /** An object's name, unless it is numbered among its kind. `kind`: the name of the kind. */
  name?(object: O, kind: string): string | null;
  /** Place of an object in words. */
  where(object: O): string;
}

const box: KindWords<Extract<SceneObject, { readonly size: unknown }>> = {
  where: ({ at, size }) => t(texts.sizeAt, { x: cm(size[0]), y: cm(size[1]), at: placeText(at) }),
};

/** How each kind of object is named and located. */
export const kindWords: Readonly<Record<SceneObject['type'], KindWords>> = {
  wall: { where: ({ from, to }: Wall) => fromTo(from, to) },
  stroke: {
    where({ points }: Stroke) {
      const [first = [0, 0], second] = points;
      if (points.length === 2 && second !== undefined) return fromTo(first, second);
      return t(texts.points, { at: placeText(first), count: points.length });
    },
  },
  mover: { where: whereMoves },
  label: {
    name: ({ text }: Label, kind) => t(texts.label, { kind, text }),
    where: ({ at }: Label) => t(texts.at, { at: placeText(at) }),
  },
  start: {
    name: ({ name }: Start, kind) => (name === '' ? null : t(texts.label, { kind, text: name })),
    where: ({ at }: Start) => t(texts.at, { at: placeText(at) }),
  },
  block: box,
  'fixed-block': box,
  spikes: box,
  target: box,
  checkpoint: { ...box, name: ({ number }: Zone, kind) => `${kind} ${String(number)}` },
  forbidden: box,
  paper: box,
  tunnel: box,
  lamp: { where: ({ at }: Lamp) => t(texts.at, { at: placeText(at) }) },
  tag: {
    name: ({ number }: Tag, kind) => `${kind} ${String(number)}`,
    where: ({ at }: Tag) => t(texts.at, { at: placeText(at) }),
  },
  barrier: { where: ({ from, to }: Barrier) => fromTo(from, to) },
};

function whereMoves(mover: Mover): string {
  const way = wayOf(mover);
  const stops = stopsOf(mover);
  const [first = mover, last = first] = [stops[0], stops.at(-1)];
  const [from, to] = [placeText(first.at), placeText(last.at)];
  if (way === 'to-and-fro' && stops.length === 2) return t(texts.goes, { from, to });
  if (way === 'to-and-fro') return t(moverWords.where.stops, { from, to, count: stops.length });
  return t(moverWords.where[way], { at: from, count: stops.length });
}

const fromTo = (from: Point, to: Point): string => t(texts.fromTo, { from: placeText(from), to: placeText(to) });

/** Place of an object in words. */
export const whereText = (object: SceneObject): string => kindWords[object.type].where(object);
