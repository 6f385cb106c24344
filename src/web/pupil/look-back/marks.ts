import { leavesAt, timesOf, type Chunk } from '#tape/rows/chunk';
import type { Key, Leaf } from '#tape/rows/leaves';

/** The kind of an event at one moment of a run. */
export type MarkKind = 'pressA' | 'pressB' | 'touch' | 'checkpoint' | 'target' | 'block' | 'passed' | 'failed' | 'end';

export interface Mark {
  readonly timeUs: number;
  readonly kind: MarkKind;
  /** Place of the device that it is about; `null`: the course. */
  readonly device: number | null;
}

/** Marks of one kind that stand so close together that one sign stands for all. */
export interface MarkGroup extends Mark {
  readonly count: number;
  /** Time of the last one. */
  readonly toUs: number;
}

/** Puts marks of a kind together that are nearer to the one before than this. @param marks in the order of their times */
export function grouped(marks: readonly Mark[], nearUs: number): readonly MarkGroup[] {
  const groups: MarkGroup[] = [];
  const last = new Map<string, number>();
  for (const mark of marks) {
    const kind = `${mark.kind} ${mark.device}`;
    const place = last.get(kind) ?? -1;
    const before = groups[place];
    if (before !== undefined && mark.timeUs - before.toUs < nearUs)
      groups[place] = { ...before, count: before.count + 1, toUs: mark.timeUs };
    else last.set(kind, groups.push({ ...mark, count: 1, toUs: mark.timeUs }) - 1);
  }
  return groups;
}

/** The mark that is nearest to a time and not farther than this from it, or `null`. */
export function nearest(marks: readonly Mark[], timeUs: number, withinUs: number): Mark | null {
  const away = (mark: Mark): number => Math.abs(mark.timeUs - timeUs);
  const [first] = marks.filter((mark) => away(mark) < withinUs).sort((one, other) => away(one) - away(other));
  return first ?? null;
}

type Value = Leaf | undefined;

/** A watched value: its path in a snapshot, and the meaning of a change. */
interface Watch {
  readonly path: readonly Key[];
  readonly device: number | null;
  meaning(before: Value, now: Value): MarkKind | null;
  last: Value;
}

const rises = (kind: MarkKind) => (before: Value, now: Value) =>
  typeof now === 'number' && now > (typeof before === 'number' ? before : 0) ? kind : null;
const becomesTrue = (kind: MarkKind) => (before: Value, now: Value) => (now === true && before !== true ? kind : null);

/** Finds the marks of a run in the pieces of its tape, as they come. */
export class Marks {
  readonly all: Mark[] = [];
  private readonly watches: readonly Watch[];

  /** @param devices how many the run has */
  constructor(devices: number) {
    this.watches = [...Array.from({ length: devices }, (_, device) => ofDevice(device)).flat(), ...ofCourse()];
  }

  add(chunk: Chunk): void {
    const times = timesOf(chunk) ?? [];
    for (const watch of this.watches)
      for (const [at, now] of leavesAt(chunk, watch.path).entries()) {
        const kind = watch.meaning(watch.last, now);
        watch.last = now;
        if (kind !== null) this.all.push({ timeUs: times[at] ?? 0, kind, device: watch.device });
      }
    this.all.sort((one, other) => one.timeUs - other.timeUs);
  }
}

function ofDevice(device: number): Watch[] {
  const at = device === 0 ? [] : ['others', device - 1];
  const watch = (path: readonly Key[], meaning: Watch['meaning']): Watch => ({
    path: [...at, ...path],
    device,
    meaning,
    last: undefined,
  });
  return [
    watch(['buttons', 'a'], becomesTrue('pressA')),
    watch(['buttons', 'b'], becomesTrue('pressB')),
    watch(['robot', 'collisions'], rises('touch')),
    watch(['running'], (before, now) => (before === 'program' && now === 'world' ? 'end' : null)),
  ];
}

function ofCourse(): Watch[] {
  const watch = (path: readonly Key[], meaning: Watch['meaning']): Watch => ({
    path: ['verdict', ...path],
    device: null,
    meaning,
    last: undefined,
  });
  return [
    watch(['checkpoints', 'passed'], rises('checkpoint')),
    watch(['targets', 'reached'], rises('target')),
    watch(['blocks', 'delivered'], rises('block')),
    watch(['state'], (before, now) =>
      now === before ? null : now === 'passed' ? 'passed' : now === 'failed' ? 'failed' : null,
    ),
  ];
}
