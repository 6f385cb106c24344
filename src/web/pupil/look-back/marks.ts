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
