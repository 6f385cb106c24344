import { sceneLimits, type Mover, type Point } from '../scene';

/** A place on a mover's way, and how many seconds it waits there. */
export interface MoverStop {
  readonly at: Point;
  readonly wait: number;
}

/** The movements of a mover besides turning, as its options offer them. */
export const moverWays = ['to-and-fro', 'round', 'stays', 'chases', 'guards'] as const;
export type MoverWay = (typeof moverWays)[number];

/** The movement of a mover. */
export function wayOf({ at, to, stops, loops, chases }: Mover): MoverWay {
  if (chases) return chases.zone === undefined ? 'chases' : 'guards';
  if (loops) return 'round';
  return stops === undefined && at[0] === to[0] && at[1] === to[1] ? 'stays' : 'to-and-fro';
}

/** The stops of a mover in their order; one without a way has its place alone. */
export function stopsOf(mover: Mover): readonly MoverStop[] {
  const { at, to, stops = [], waits = [] } = mover;
  const places = mover.chases || isStill(mover) ? [at] : [at, to, ...stops];
  return places.map((place, index) => ({ at: place, wait: waits[index] ?? 0 }));
}

/** True if it neither goes anywhere nor turns. */
export const isIdle = (mover: Mover): boolean => isStill(mover) && mover.spin === undefined && !mover.chases;

const isStill = ({ at, to, stops }: Mover): boolean => stops === undefined && at[0] === to[0] && at[1] === to[1];

/** A mover with other stops; any beyond the 20th are left out, and without one it stays at its place. */
export function withStops(mover: Mover, given: readonly MoverStop[]): Mover {
  const { stops: _stops, waits: _waits, ...rest } = mover;
  const kept = given.slice(0, sceneLimits.stops);
  const [first, second, ...further] = kept;
  const at = first?.at ?? mover.at;
  return {
    ...{ ...rest, at, to: second?.at ?? at },
    ...(further.length === 0 ? {} : { stops: further.map((stop) => stop.at) }),
    ...waitsProperty(kept.map(({ wait }) => wait)),
  };
}

/** The property of the waits of a mover's stops: without the zeros at its end. */
export function waitsProperty(waits: readonly number[]): Pick<Mover, 'waits'> {
  const last = waits.findLastIndex((wait) => wait > 0);
  return last < 0 ? {} : { waits: waits.slice(0, last + 1) };
}

/** A mover with each of its places at another. */
export const withPlaces = (mover: Mover, place: (at: Point) => Point): Mover => ({
  ...mover,
  at: place(mover.at),
  to: place(mover.to),
  ...(mover.stops ? { stops: mover.stops.map(place) } : {}),
});
