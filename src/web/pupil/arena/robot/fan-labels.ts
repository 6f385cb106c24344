import type { Vec } from '#core/geometry';
import { lidarCm } from '#robots/lidar-fan';
import { boxAround, type PxBox } from '../view/moving-window';

/** The end of a ray that meets something, in CSS px. */
export interface FanEnd {
  readonly at: Vec;
  /** The way of the ray on the screen, 1 px long. */
  readonly along: Vec;
  readonly depthMm: number;
}

/** A number beside the end of a ray, in CSS px. */
export interface FanLabel {
  readonly text: string;
  /** Its middle. */
  readonly at: Vec;
  readonly isNearest: boolean;
  readonly box: PxBox;
}

/** Height of a label, in px. */
export const LABEL_PX = { nearest: 24, other: 20 } as const;

/** Distance between a label and the point that it belongs to, and between two labels, in px. */
const AWAY_PX = 8;
const APART_PX = 2;

/** Widths of digits and of the unit in bold letters of 13 px, in px: measured with Liberation Sans, rounded up. */
const DIGIT_PX = 7.6;
const UNIT_PX = 27;

/**
 * Ways that the label of the nearest end tries, as turns of the ray's way in rad: behind its point, then away from the middle of
 * the fan, then towards it.
 */
const TURNS = [0, 0.4, 0.8, 1.2, 1.6, 2.3, -0.8, -1.6, -2.3, Math.PI];
/** How much farther than usual from their points labels are tried, in px. */
const FARTHER_PX = { nearest: [0, 22, 44], other: [0, 14] } as const;

/** Radius around the points of other rays that the nearest label leaves free, in px. */
const POINT_PX = 5;

/**
 * Places a number behind each end, none over another: where two would be, the one nearer to the fan's edge stays. The
 * nearest gives way to the others, and only where it finds no place do they give way to it.
 *
 * @param ends from left to right
 * @param sight all labels lie in it
 */
export function fanLabels(ends: readonly FanEnd[], sight: PxBox): readonly FanLabel[] {
  const nearest = ends.reduce<FanEnd | null>((best, end) => (best !== null && best.depthMm <= end.depthMm ? best : end), null); // prettier-ignore
  if (nearest === null) return [];
  const placed: FanLabel[] = [];
  for (const end of fromTheEdges(ends)) {
    if (end === nearest) continue;
    const tried = FARTHER_PX.other.map((fartherPx) => labelOf(end, end.along, fartherPx, false, sight));
    const label = tried.find(({ box }) => isFree(box, placed));
    if (label !== undefined) placed.push(label);
  }
  const own = labelOfNearest(nearest, ends, placed, sight);
  return [...placed.filter(({ box }) => !isOver(box, own.box)), own];
}

/** The label of the nearest end at the first of its places that is free, or else at the first of all. */
function labelOfNearest(end: FanEnd, ends: readonly FanEnd[], placed: readonly FanLabel[], sight: PxBox): FanLabel {
  const outward = ends.indexOf(end) < (ends.length - 1) / 2 ? -1 : 1; // y is down: clockwise on the right of the fan
  const points = ends.filter((other) => other !== end).map(({ at }) => ({ box: boxAround(at, POINT_PX) }));
  for (const fartherPx of FARTHER_PX.nearest) {
    for (const turn of TURNS) {
      const label = labelOf(end, turned(end.along, outward * turn), fartherPx, true, sight);
      if (isFree(label.box, placed) && isFree(label.box, points)) return label;
    }
  }
  return labelOf(end, end.along, 0, true, sight);
}

const isFree = (box: PxBox, taken: readonly { readonly box: PxBox }[]): boolean =>
  taken.every((other) => !isOver(other.box, box));

/** First and last, second and last but one, and so on: who comes first keeps its place. */
function fromTheEdges<T>(all: readonly T[]): readonly T[] {
  const last = all.length - 1;
  return all.flatMap((one, place) => {
    const other = all[last - place];
    return place > last - place || other === undefined ? [] : place === last - place ? [one] : [one, other];
  });
}

function labelOf(end: FanEnd, way: Vec, fartherPx: number, isNearest: boolean, sight: PxBox): FanLabel {
  const cm = String(lidarCm(end.depthMm));
  const height = isNearest ? LABEL_PX.nearest : LABEL_PX.other;
  const width = height - 2 + DIGIT_PX * cm.length + (isNearest ? UNIT_PX : 0);
  const away = AWAY_PX + fartherPx + (Math.abs(way.x) * width + Math.abs(way.y) * height) / 2;
  const at = {
    x: within(end.at.x + way.x * away, width / 2, sight.left, sight.width),
    y: within(end.at.y + way.y * away, height / 2, sight.top, sight.height),
  };
  const box = { left: at.x - width / 2, top: at.y - height / 2, width, height };
  return { text: isNearest ? `${cm} cm` : cm, at, isNearest, box };
}

const within = (middle: number, half: number, from: number, size: number): number =>
  Math.max(from + half + 4, Math.min(middle, from + size - half - 4));

function turned({ x, y }: Vec, rad: number): Vec {
  const [cos, sin] = [Math.cos(rad), Math.sin(rad)];
  return { x: x * cos - y * sin, y: x * sin + y * cos };
}

/** True if two labels lie over each other or nearly touch. */
const isOver = (one: PxBox, other: PxBox): boolean =>
  one.left < other.left + other.width + APART_PX &&
  other.left < one.left + one.width + APART_PX &&
  one.top < other.top + other.height + APART_PX &&
  other.top < one.top + one.height + APART_PX;
