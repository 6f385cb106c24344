import { degOf, fullTurnDeg, radOf, wrappedDeg } from '#core/angle';
import { exactAtan2, exactCos, exactSin } from '#core/exact-math';
import type { Vec } from '#core/geometry';
import { sceneLimits, type Point } from '#scene/scene';

/** A place of a course as a vector. */
export const toVec = ([x, y]: Point): Vec => ({ x, y });

/** A place in whole mm within what a course may hold. */
export const toPoint = ({ x, y }: Vec): Point => [wholeMm(x), wholeMm(y)];

/** A coordinate in whole mm within the limits of a course; anything but a number becomes the lower limit. */
export function wholeMm(mm: number): number {
  const { min, max } = sceneLimits.placeMm;
  if (!(mm > min)) return min;
  return mm < max ? Math.round(mm) + 0 : max; // + 0: a file knows no −0
}

/** A value clamped to a range, both ends included; anything but a number becomes the lower end. */
export function within(value: number, { min, max }: { readonly min: number; readonly max: number }): number {
  if (!(value > min)) return min;
  return value < max ? value : max;
}

/** Length of the straight line from one place to another. */
export function distanceMm(a: Vec, b: Vec): number {
  const dx = b.x - a.x;
  const dy = b.y - a.y;
  return Math.sqrt(dx * dx + dy * dy);
}

/** One place moved by a displacement. */
export const plus = (a: Vec, b: Vec): Vec => ({ x: a.x + b.x, y: a.y + b.y });

/** The displacement from `b` to `a`. */
export const minus = (a: Vec, b: Vec): Vec => ({ x: a.x - b.x, y: a.y - b.y });

/** Halfway between two places. */
export const middleBetween = (a: Vec, b: Vec): Vec => ({ x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 });

/** The place of the straight piece from `a` to `b` that is nearest to `place`. */
export function nearestOn(a: Vec, b: Vec, place: Vec): Vec {
  const dx = b.x - a.x;
  const dy = b.y - a.y;
  const square = dx * dx + dy * dy;
  if (square === 0) return a;
  const share = within(((place.x - a.x) * dx + (place.y - a.y) * dy) / square, { min: 0, max: 1 });
  return { x: a.x + dx * share, y: a.y + dy * share };
}

/** Direction from one place to another in degrees, −180 … 180, counter-clockwise from +x. */
export const directionDeg = (from: Vec, to: Vec): number => degOf(exactAtan2(to.y - from.y, to.x - from.x));

/** The multiple of `stepDeg` nearest to an angle, above −180 up to 180. */
export const steppedDeg = (angleDeg: number, stepDeg: number): number =>
  wrappedDeg(Math.round(angleDeg / stepDeg) * stepDeg);

/** A displacement turned counter-clockwise; exact for whole quarter turns. */
export function turned({ x, y }: Vec, angleDeg: number): Vec {
  const angle = wrappedDeg(angleDeg);
  if (angle === 0) return { x, y };
  if (angle === 90) return { x: -y, y: x };
  if (angle === 180) return { x: -x, y: -y };
  if (angle === -90) return { x: y, y: -x };
  const cos = exactCos(radOf(angle));
  const sin = exactSin(radOf(angle));
  return { x: x * cos - y * sin, y: x * sin + y * cos };
}

/** A place turned counter-clockwise about another. */
export const turnedAbout = (place: Vec, pivot: Vec, angleDeg: number): Vec =>
  plus(pivot, turned(minus(place, pivot), angleDeg));

/** A rotation as objects have it: tenths of a degree from 0 up to but without 360. */
export const rotationDeg = (angleDeg: number): number => fullTurnDeg(Math.round(angleDeg * 10) / 10);
