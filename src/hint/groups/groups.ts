import { isUnread } from '#check/report/texts';
import { isSame } from '#core/same';
import type { CheckResult, Reason } from '#check/result';
import type { Point } from '#scene/scene';
import type { Happened } from '../happened/happened';
import { isForOtherTask } from './needs-run';
import type { RunFacts } from './run-facts';
import { sidesIn, type PassedSide } from './passed-sides';

/** A hand-in to be grouped. */
export interface ToGroup {
  /** Unlike the others. */
  readonly name: string;
  readonly result: CheckResult;
  /** The facts of its run; `null`: it has passed, or was not run. */
  readonly facts: RunFacts | null;
  /** Why its run could not be looked at; left out: it could. */
  readonly unseen?: Reason;
}

/** The common feature of a group, with its values. */
export type GroupKind =
  | { readonly kind: 'passed'; readonly side: PassedSide | null }
  | { readonly kind: 'straight' | 'late' | 'far' | 'after-bend'; readonly bend: number }
  /** They come no further; `bend`: at that one; 0: from the start; `null`: elsewhere. */
  | { readonly kind: 'stays'; readonly bend: number | null; readonly next: number | null }
  | { readonly kind: 'line' }
  | { readonly kind: 'past'; readonly side: 'left' | 'right'; readonly checkpoint: number | null }
  | { readonly kind: 'ended' | 'ended-near' | 'stands' | 'turns'; readonly next: number | null }
  | { readonly kind: 'touched' | 'forbidden' | 'spikes' | 'ring' | 'robot' }
  | { readonly kind: 'reached'; readonly done: number; readonly of: number }
  | { readonly kind: 'slow' | 'early'; readonly seconds: number }
  | { readonly kind: 'unmoved' | 'empty' | 'panic' | 'stuck' }
  | { readonly kind: 'waits'; readonly name: string }
  | { readonly kind: 'error'; readonly type: string }
  /** `null`: not the same of all. */
  | { readonly kind: 'reason' | 'unseen'; readonly reason: Reason | null }
  | { readonly kind: 'other-task' | 'unread' | 'others' };

/** Hand-ins whose runs did the same. */
export interface Group {
  /** Unlike the others of its class; it stays while further hand-ins join. */
  readonly key: string;
  readonly is: GroupKind;
  /** Id of the world in which it happened; `null`: in all, or none was run. */
  readonly world: string | null;
  /** Middle of the places at which it happened, in mm, and the radius round it that holds them all; `null`: nowhere. */
  readonly place: { readonly at: Point; readonly radius: number } | null;
  /** Part of the course in which it happened, if another group did the same elsewhere; else `null`. */
  readonly region: Region | null;
  /** The earliest and the latest time at which it happened, in simulated seconds; `null`: no time belongs to it. */
  readonly seconds: Span | null;
  /** How near the ends were to what was next, in cm; `null`: no distance belongs to it. */
  readonly nearCm: Span | null;
  /** Its hand-ins, in the order given. */
  readonly members: readonly string[];
  /** The one in the middle of its times. */
  readonly example: string;
}

type Span = readonly [least: number, most: number];

/** Ninths of a course, by row and column. */
export const regions = ['top-left', 'top', 'top-right', 'left', 'middle', 'right', 'bottom-left', 'bottom', 'bottom-right'] as const; // prettier-ignore
export type Region = (typeof regions)[number];

/** The most groups of a class. Chosen: a teacher talks about some of them, and all are seen at once. */
const MOST_GROUPS = 10;
/** Two places closer than this are the same, in mm. Chosen: a robot's length. */
const SAME_MM = 150;
/** Ends this near are just before the place that was next, in cm. Chosen. */
const NEAR_CM = 15;

/**
 * The groups of a class by what the runs did: those that have passed first, then the largest first; what cannot be read is last.
 * Each hand-in is in one of them.
 *
 * @param size of the course, in mm
 */
export function groupsOf(all: readonly ToGroup[], size: Point): readonly Group[] {
  const sides = sidesIn(all.filter(({ result }) => result.passed));
  const sorted = atOneBend(all.map((one) => sortedAs(one, kindOf(one, sides))));
  const clusters = [...byBase(sorted).values()].flatMap((those) => (isByPlace(those[0]?.is) ? nearEachOther(those) : [those])); // prettier-ignore
  const few = fewer(clusters.length > MOST_GROUPS ? [...byBase(sorted).values()] : clusters);
  const isAlone = ([first]: readonly Sorted[]): boolean => few.filter(([other]) => other?.base === first?.base).length === 1; // prettier-ignore
  return few
    .map((those) => groupOf(those, isAlone(those) ? null : size))
    .toSorted((one, other) => rank(one) - rank(other) || other.members.length - one.members.length || startOf(one) - startOf(other) || (one.key < other.key ? -1 : 1)); // prettier-ignore
}

const sortedAs = (one: ToGroup, is: GroupKind): Sorted => {
  const failed = one.facts?.world ?? one.result.worlds.find(({ passed }) => !passed)?.id ?? null;
  const world = ['other-task', 'unseen'].includes(is.kind) ? null : failed;
  return { one, is, world, base: `${baseOf(is)}${world === null ? '' : `@${world}`}` };
};

/** Those that stay near each other do so at the same bend: a place between two bends belongs to either. */
function atOneBend(sorted: readonly Sorted[]): readonly Sorted[] {
  const staying = sorted.filter(({ is }) => is.kind === 'stays' && is.bend !== 0);
  const first = new Map(nearEachOther(staying).flatMap((part) => part.map((one) => [one, part[0]?.is] as const)));
  return sorted.map((one) => {
    const [is, as] = [one.is, first.get(one)];
    return is.kind === 'stays' && as?.kind === 'stays' ? sortedAs(one.one, { ...is, bend: as.bend }) : one;
  });
}

interface Sorted {
  readonly one: ToGroup;
  readonly is: GroupKind;
  readonly world: string | null;
  readonly base: string;
}

const startOf = ({ seconds }: Group): number => seconds?.[0] ?? Infinity;

const rank = ({ is }: Group): number =>
  is.kind === 'passed'
    ? 0
    : ['unread', 'unseen'].includes(is.kind)
      ? 4
      : is.kind === 'other-task'
        ? 3
        : is.kind === 'others'
          ? 2
          : 1;

function kindOf({ name, result, facts, unseen }: ToGroup, sides: ReadonlyMap<string, PassedSide>): GroupKind {
  if (result.passed) return { kind: 'passed', side: sides.get(name) ?? null };
  if (isForOtherTask(result)) return { kind: 'other-task' };
  const reason = unseen ?? uncheckedFor(result);
  if (reason !== null) return { kind: 'unseen', reason };
  if (isUnread(result)) return { kind: 'unread' };
  if (facts === null) return kindOfReason(reasonIn(result));
  const { happened, departure, next, stays, bend } = facts;
  const isOfWay = ['bright', 'left-line', 'past', 'reached', 'turns'].includes(happened.fact);
  if (isOfWay && stays && (departure === null || bend === 0)) return { kind: 'stays', bend, next };
  if (isOfWay && departure !== null) return { kind: departure.manner ?? 'after-bend', bend: departure.bend };
  switch (happened.fact) {
    case 'bright':
    case 'left-line':
      return { kind: 'line' };
    case 'past':
      return { kind: 'past', side: happened.side, checkpoint: happened.checkpoint };
    case 'ended':
      return { kind: (happened.nearCm ?? Infinity) <= NEAR_CM ? 'ended-near' : 'ended', next };
    case 'stands':
    case 'turns':
      return { kind: happened.fact, next };
    case 'reached':
      return { kind: 'reached', done: happened.done, of: happened.of };
    default:
      return plainKind(happened);
  }
}

/** Why a hand-in was not even checked, where that is no matter of its own; else `null`. */
const uncheckedFor = ({ remarks }: CheckResult): Reason | null =>
  remarks.some(({ params }) => params['why'] === 'unloaded') ? { code: 'unloaded', params: {} } : null;

/** The kind by the reason alone, of a run that was not run again. */
function kindOfReason(reason: Reason): GroupKind {
  const { code, params } = reason;
  switch (code) {
    case 'unmoved':
    case 'empty':
    case 'panic':
    case 'stuck':
    case 'touched':
    case 'forbidden':
    case 'spikes':
    case 'robot':
      return { kind: code };
    case 'waits':
      return { kind: code, name: String(params['name'] ?? '') };
    case 'exception':
      return { kind: 'error', type: String(params['type'] ?? '') };
    default:
      return { kind: 'reason', reason };
  }
}

/** Why a hand-in has not passed that was not run again. */
const reasonIn = ({ worlds, checks }: CheckResult): Reason =>
  [...worlds, ...checks].find(({ reason }) => reason !== null)?.reason ?? { code: 'open', params: {} };

function plainKind(
  happened: Exclude<
    Happened,
    { readonly fact: 'bright' | 'left-line' | 'past' | 'ended' | 'stands' | 'turns' | 'reached' }
  >,
): GroupKind {
  // prettier-ignore
  switch (happened.fact) {
    case 'error':
      return { kind: 'error', type: happened.type };
    case 'waits':
      return { kind: 'waits', name: happened.name };
    case 'slow':
    case 'early':
      return { kind: happened.fact, seconds: happened.seconds };
    case 'reason':
      return { kind: 'reason', reason: happened.reason };
    default:
      return { kind: happened.fact };
  }
}

/** The common feature as text; values that differ a little from run to run are not in it. */
function baseOf(is: GroupKind): string {
  const { kind } = is;
  if (is.kind === 'stays') return `${kind}:${is.bend ?? ''}:${is.next ?? ''}`;
  if ('bend' in is) return `${kind}:${is.bend}`;
  if ('next' in is) return `${kind}:${is.next ?? ''}`;
  if (is.kind === 'passed') return `${kind}:${is.side ?? ''}`;
  if (is.kind === 'past') return `${kind}:${is.side}:${is.checkpoint ?? ''}`;
  if (is.kind === 'reached') return `${kind}:${is.done}:${is.of}`;
  if (is.kind === 'slow' || is.kind === 'early') return `${kind}:${is.seconds}`;
  if (is.kind === 'error') return `${kind}:${is.type}`;
  if (is.kind === 'waits') return `${kind}:${is.name}`;
  if (is.kind !== 'reason' || is.reason === null) return kind;
  const { code, params } = is.reason;
  return [kind, code, ...OF_TASK.map((name) => params[name] ?? '')].join(':');
}

/** The values of a reason that the task sets: hand-ins with other ones miss something else. */
const OF_TASK = ['object', 'zone', 'seconds', 'heading', 'percent', 'of', 'least', 'most', 'text', 'rows', 'name'] as const; // prettier-ignore

/** True of what may happen at different places of a course. */
const isByPlace = (is: GroupKind | undefined): boolean =>
  is !== undefined && !(is.kind === 'stays' && is.bend !== null) && ['line', 'stays', 'ended', 'stands', 'turns', 'touched', 'forbidden', 'spikes', 'robot', 'ring'].includes(is.kind); // prettier-ignore

const byBase = (sorted: readonly Sorted[]): ReadonlyMap<string, readonly Sorted[]> => {
  const found = new Map<string, Sorted[]>();
  for (const one of sorted) found.set(one.base, [...(found.get(one.base) ?? []), one]);
  return found;
};

/** Parts of hand-ins in which each is near another one of its part. */
function nearEachOther(those: readonly Sorted[]): readonly (readonly Sorted[])[] {
  const parts: Sorted[][] = [];
  for (const one of those) {
    const near = parts.filter((part) => part.some((other) => isNear(one.one.facts?.at, other.one.facts?.at)));
    for (const part of near) parts.splice(parts.indexOf(part), 1);
    parts.push([...near.flat(), one]);
  }
  // As they were given, whatever joined them.
  return parts.map((part) => part.toSorted((one, other) => those.indexOf(one) - those.indexOf(other)));
}

const isNear = (one: Point | null | undefined, other: Point | null | undefined): boolean =>
  one && other ? lengthBetween(one, other) <= SAME_MM : one === other;

const lengthBetween = ([x, y]: Point, [toX, toY]: Point): number =>
  Math.sqrt((x - toX) * (x - toX) + (y - toY) * (y - toY));

/** No more groups than that: the smallest that have not passed become one. */
function fewer(parts: readonly (readonly Sorted[])[]): readonly (readonly Sorted[])[] {
  const isOwn = ([first]: readonly Sorted[]): boolean => first !== undefined && !['passed', 'unread', 'unseen', 'other-task'].includes(first.is.kind); // prettier-ignore
  const own = parts.filter(isOwn).toSorted((one, other) => other.length - one.length);
  const apart = parts.filter((part) => !isOwn(part));
  const room = MOST_GROUPS - apart.length;
  if (own.length <= room) return parts;
  const others = own.slice(room - 1).flat().map((one): Sorted => ({ ...one, is: { kind: 'others' }, base: 'others' })); // prettier-ignore
  return [...apart, ...own.slice(0, room - 1), others];
}

function groupOf(those: readonly Sorted[], size: Point | null): Group {
  const [first] = those;
  const is = kindOfAll(those);
  const place = is.kind === 'others' || is.kind === 'passed' ? null : placeOf(those);
  const region = size === null || place === null || !isByPlace(is) ? null : regionOf(place.at, size);
  const timed = those.toSorted((one, other) => (secondsOf(one) ?? Infinity) - (secondsOf(other) ?? Infinity));
  return {
    ...{ key: `${first?.base ?? ''}#${first?.one.name ?? ''}`, is, place, region },
    world: is.kind === 'others' ? null : (first?.world ?? null),
    seconds: is.kind === 'others' ? null : spanOf(those.map(secondsOf)),
    nearCm: spanOf(those.map(nearOf)),
    members: those.map(({ one }) => one.name),
    example: timed[Math.floor((timed.length - 1) / 2)]?.one.name ?? '',
  };
}

/** The kind of hand-ins of one kind; a reason that is not the same of all is not told of all. */
function kindOfAll([first, ...others]: readonly Sorted[]): GroupKind {
  const is = first?.is ?? { kind: 'others' };
  if (is.kind !== 'reason' && is.kind !== 'unseen') return is;
  return others.every((other) => isSame(other.is, is)) ? is : { ...is, reason: null };
}

function secondsOf({ is, one: { result, facts } }: Sorted): number | null {
  const { happened } = facts ?? {};
  if (is.kind === 'stays') return null;
  if ('bend' in is) return facts?.departure?.atS ?? null;
  // A program that does not begin has no time.
  if (happened !== undefined && 'atS' in happened) return happened.atS === 0 ? null : happened.atS;
  const ms = result.passed ? (result.worlds[0]?.atMs ?? null) : null;
  return ms === null ? null : Math.round(ms / 100) / 10;
}

const nearOf = ({ one: { facts } }: Sorted): number | null =>
  facts?.happened.fact === 'ended' ? facts.happened.nearCm : null;

function spanOf(values: readonly (number | null)[]): Span | null {
  const known = values.filter((value) => value !== null);
  return known.length === 0 ? null : [Math.min(...known), Math.max(...known)];
}

function placeOf(those: readonly Sorted[]): Group['place'] {
  const places = those.flatMap(({ one: { facts } }) => (facts?.at ? [facts.at] : []));
  if (places.length === 0) return null;
  const middle = (index: 0 | 1): number => Math.round(places.reduce((sum, place) => sum + place[index], 0) / places.length); // prettier-ignore
  const at: Point = [middle(0), middle(1)];
  return { at, radius: Math.round(Math.max(...places.map((place) => lengthBetween(at, place)))) };
}

function regionOf([x, y]: Point, [width, height]: Point): Region {
  const third = (part: number, whole: number): number => Math.max(0, Math.min(2, Math.floor((3 * part) / whole)));
  return regions[(2 - third(y, height)) * 3 + third(x, width)] ?? 'middle';
}
