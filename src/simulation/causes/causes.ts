import { isSame } from '#core/same';
import { STEP_US } from '#world/step';
import type { CodeLine, Output, OutputSet } from './output';

/** The cause of an output's value at some moment. */
export interface Cause {
  readonly output: Output;
  /** When the output got this value, in µs; for an event, when it happened. */
  readonly sinceUs: number;
  /** The lines that set it then, innermost first; empty: it was typed at the REPL. */
  readonly lines: readonly CodeLine[];
  /** The value it was set to, as the robot or board reports it; `null`: it is an event. */
  readonly value: OutputSet['value'];
  /** Other lines, which were the last to set it to the same value again; `null`: there are none. */
  readonly again: readonly CodeLine[] | null;
}

/** Most entries of an output. Chosen: an hour of twenty a second; then the older half is removed. */
const MOST_ENTRIES = 72_000;

/** Which lines set the outputs of a run's devices, and when: as far as any repetition of it has come. */
export class Causes {
  private readonly devices: DeviceCauses[] = [];
  /** The causes are known up to this time, in µs. */
  untilUs = 0;

  /** Makes a listener to a repetition from its start. All listeners are the same: a report counts once. */
  listener(): (set: OutputSet, device: number) => void {
    const heard: number[] = [];
    return (set, device) => {
      const known = (this.devices[device] ??= new DeviceCauses());
      const count = (heard[device] ?? 0) + 1;
      heard[device] = count;
      if (count > known.count) known.add(set);
    };
  }

  /** Call it when a repetition has come to this time. */
  reached(us: number): void {
    this.untilUs = Math.max(this.untilUs, us);
  }

  /** The causes of the outputs' values just after a time, in the order in which the outputs were first set. */
  at(device: number, timeUs: number): readonly Cause[] {
    return this.devices[device]?.at(timeUs) ?? [];
  }

  /** The events of an output between two times, the ends included. */
  events(device: number, output: Output, fromUs: number, toUs: number): readonly Cause[] {
    return this.devices[device]?.between(output, fromUs, toUs) ?? [];
  }

  /**
   * Why a line stands in the console.
   *
   * @param timeUs the time of the line in the run's output, by the first device's clock: at most one step of the world
   *   early; the lines of a few ms share it
   * @param place how many lines of the device have this same time and come before
   */
  printed(device: number, timeUs: number, place: number): Cause | null {
    const fromUs = device === 0 ? timeUs : timeUs - STEP_US;
    return this.events(device, 'console', fromUs, timeUs + 2 * STEP_US)[place] ?? null;
  }
}

/** The first of several in a row that are alike in value and lines. */
type Entry = Omit<OutputSet, 'output'>;

class DeviceCauses {
  /** How often any output was set. */
  count = 0;
  private readonly outputs = new Map<Output, Entry[]>();
  /** Equal lists of lines are stored once. */
  private readonly lines = new Map<string, readonly CodeLine[]>();

  add({ output, timeUs, value, lines }: OutputSet): void {
    this.count += 1;
    const entries = this.outputs.get(output) ?? [];
    if (entries.length === 0) this.outputs.set(output, entries);
    const entry = { timeUs, value, lines: this.kept(lines) };
    const last = entries.at(-1);
    if (value !== null && last?.value === value && last.lines === entry.lines) return;
    entries.push(entry);
    if (entries.length > MOST_ENTRIES) entries.splice(0, MOST_ENTRIES / 2);
  }

  at(timeUs: number): readonly Cause[] {
    return Array.from(this.outputs).flatMap(([output, entries]) => {
      const last = lastUntil(entries, timeUs);
      return last < 0 ? [] : [causeOf(output, entries, last)];
    });
  }

  between(output: Output, fromUs: number, toUs: number): readonly Cause[] {
    const entries = this.outputs.get(output) ?? [];
    const from = lastUntil(entries, fromUs - 1) + 1;
    return entries
      .slice(from, lastUntil(entries, toUs) + 1)
      .map(({ timeUs, value, lines }) => ({ output, sinceUs: timeUs, lines, value, again: null }));
  }

  private kept(lines: readonly CodeLine[]): readonly CodeLine[] {
    const key = lines.map(({ file, line }) => `${file}:${line}`).join();
    const known = this.lines.get(key) ?? lines;
    this.lines.set(key, known);
    return known;
  }
}

/** The place of the last entry up to a time, or −1. */
function lastUntil(entries: readonly Entry[], timeUs: number): number {
  let [low, high] = [0, entries.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((entries[middle]?.timeUs ?? Infinity) <= timeUs) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

function causeOf(output: Output, entries: readonly Entry[], last: number): Cause {
  const now = entries[last];
  let first = last;
  while (now !== undefined && now.value !== null && entries[first - 1]?.value === now.value) first -= 1;
  const { timeUs = 0, lines = [] } = entries[first] ?? {};
  const isAgain = now !== undefined && !isSame(now.lines, lines);
  return { output, sinceUs: timeUs, lines, value: now?.value ?? null, again: isAgain ? now.lines : null };
}
