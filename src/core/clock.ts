import type { Stop } from './stop';

interface Alarm {
  readonly timeUs: number;
  readonly order: number;
  readonly ring: () => void;
  cancelled: boolean;
}

/**
 * The one clock of a run: whole microseconds since its start, moved only by `advanceTo`.
 * Alarms ring in the order of their time; alarms of the same microsecond in the order in which they were set.
 */
export class Clock {
  private time = 0;
  private nextOrder = 0;
  /** Binary heap, earliest alarm first. Cancelled alarms stay in it until they reach the top. */
  private readonly heap: Alarm[] = [];

  /** Microseconds since the start of the run, a whole number. */
  get nowUs(): number {
    return this.time;
  }

  /** The time of the next alarm in µs, or `Infinity` when none is set. */
  get nextAlarmUs(): number {
    while (this.heap[0]?.cancelled) this.pop();
    return this.heap[0]?.timeUs ?? Infinity;
  }

  /** Number of alarms set; a repeating one counts once. */
  get alarms(): number {
    return this.heap.reduce((count, alarm) => (alarm.cancelled ? count : count + 1), 0);
  }

  /**
   * Sets an alarm. One set for the past or for now rings at the next `advanceTo`, at the time it is then.
   *
   * @param timeUs when it rings, in µs since the start of the run; fractions are rounded up
   * @returns a function that cancels the alarm
   */
  at(timeUs: number, ring: () => void): Stop {
    const alarm: Alarm = {
      timeUs: Math.max(Math.ceil(timeUs), this.time),
      order: this.nextOrder++,
      ring,
      cancelled: false,
    };
    this.push(alarm);
    return () => {
      alarm.cancelled = true;
    };
  }

  /** Rings every `periodUs` from now on; the first time one period from now. */
  every(periodUs: number, ring: () => void): Stop {
    if (!(periodUs >= 1)) throw new RangeError(`A period must be at least 1 µs, not ${String(periodUs)}.`);
    let stopped = false;
    let cancel: Stop = () => undefined;
    const schedule = (timeUs: number): void => {
      cancel = this.at(timeUs, () => {
        // Also after an error: an error ends the run, but the clock continues.
        try {
          ring();
        } finally {
          if (!stopped) schedule(timeUs + periodUs);
        }
      });
    };
    schedule(this.time + periodUs);
    return () => {
      stopped = true;
      cancel();
    };
  }

  /**
   * Moves the time on, ringing every alarm that is due by then (also those that alarms set meanwhile). While an alarm
   * rings, `nowUs` is the alarm's own time.
   *
   * @throws RangeError when `timeUs` is in the past
   */
  advanceTo(timeUs: number): void {
    if (timeUs < this.time) throw new RangeError(`The clock cannot go back from ${this.time} to ${timeUs} µs.`);
    for (let due = this.nextAlarmUs; due <= timeUs; due = this.nextAlarmUs) {
      const alarm = this.pop();
      this.time = Math.max(this.time, due);
      alarm?.ring();
    }
    this.time = Math.max(this.time, timeUs);
  }

  private push(alarm: Alarm): void {
    const heap = this.heap;
    let place = heap.push(alarm) - 1;
    while (place > 0) {
      const parent = (place - 1) >> 1;
      const above = heap[parent];
      if (!above || !isBefore(alarm, above)) break;
      heap[place] = above;
      place = parent;
    }
    heap[place] = alarm;
  }

  private pop(): Alarm | undefined {
    const heap = this.heap;
    const first = heap[0];
    const last = heap.pop();
    if (!last || heap.length === 0) return first;
    let place = 0;
    for (;;) {
      const left = 2 * place + 1;
      const right = left + 1;
      let child = heap[left];
      let childPlace = left;
      const other = heap[right];
      if (child && other && isBefore(other, child)) {
        child = other;
        childPlace = right;
      }
      if (!child || !isBefore(child, last)) break;
      heap[place] = child;
      place = childPlace;
    }
    heap[place] = last;
    return first;
  }
}

const isBefore = (a: Alarm, b: Alarm): boolean => a.timeUs < b.timeUs || (a.timeUs === b.timeUs && a.order < b.order);
