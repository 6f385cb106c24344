import { computed, shallowRef, type ComputedRef, type ShallowRef } from 'vue';

import type { AtTable } from '#advice/at-table';

import { ConsoleLog, type ConsoleEntry, type ErrorPlace } from './log/console-log';
import { foldGreetings } from './log/fold-greeting';
import { SharedLines } from './log/shared-lines';
import type { ErrorReport } from './advice/error-advice';
import type { TextKey } from '../../kit/i18n/texts';

/** How often new output is shown, in ms. Not by animation frames: those stop in a tab that is not seen. */
const SHOW_EVERY_MS = 50; // chosen: 20 times a second reads as at once

/** The console as the page shows it: output is gathered and shown in one go, twenty times a second at most. */
export class ConsoleModel {
  /** The entries of the device that is shown. */
  readonly entries: ComputedRef<readonly ConsoleEntry[]> = computed(() => this.lists.value[this.device()] ?? []);
  readonly isCut = computed(() => this.entries.value.length > 0 && this.logOf(this.device()).isCut);
  /** The entries of each device, by its place. */
  private readonly lists: ShallowRef<readonly (readonly ConsoleEntry[])[]> = shallowRef([]);
  /** The lines of all devices of a run that has several. */
  readonly together = new SharedLines();
  /** True if the lines of all devices are shown where there are several; else those of the shown device. */
  readonly isTogether = shallowRef(true);
  /** True if the chart is shown instead. */
  readonly isChart = shallowRef(false);
  /** True if there is output that the pupil may not have seen, on a screen where the console is behind a tab. */
  readonly isNew = shallowRef(false);
  /** Counts what the pupil has sent: from then on the console shows its end. */
  readonly sent = shallowRef(0);
  /** True if somebody has been at the REPL of the last run: from then on the console shows its greeting. */
  readonly isReplVisited: ComputedRef<boolean> = computed(() => this.visited.value.has(this.run.value));
  /** Numbers of the runs at whose REPL somebody has been. */
  private readonly visited = shallowRef<ReadonlySet<number>>(new Set());
  /** Number of the present run, from 1; 0: there was none. */
  readonly run = shallowRef(0);
  /** The shown part of `entries`. */
  readonly shown: ComputedRef<readonly ConsoleEntry[]> = computed(() =>
    foldGreetings(this.entries.value, this.visited.value, this.run.value),
  );
  private readonly logs: ConsoleLog[] = [];
  private readonly pending: string[] = [];
  private timer: ReturnType<typeof setTimeout> | undefined;

  /**
   * @param table what is plugged into a device, for errors of a robot that does not answer
   * @param device place of the device that is shown
   */
  constructor(
    private readonly table: (device: number) => AtTable | null,
    private readonly device: () => number = () => 0,
  ) {}

  /** Adds output of a device's program. */
  write(text: string, device = 0, timeUs = 0): void {
    this.together.write(text, device, timeUs);
    this.pending[device] = (this.pending[device] ?? '') + text;
    this.timer ??= setTimeout(() => this.show(), SHOW_EVERY_MS);
  }

  /**
   * Begins a run.
   *
   * @param devices number of its devices
   */
  startRun(number: number, devices = 1): void {
    this.show();
    this.run.value = number;
    this.together.startRun(number, devices);
    for (let device = 0; device < devices; device++) this.logOf(device).add({ kind: 'run', number });
    this.show();
  }

  /** Adds a sentence of the app itself. */
  addNote(key: TextKey, device = 0): void {
    this.show();
    this.logOf(device).add({ kind: 'note', key });
    this.show();
  }

  /** Notes that the robot of a device does not fit, as its run begins. */
  addFit(device = 0): void {
    this.show();
    this.logOf(device).add({ kind: 'fit' });
    this.show();
  }

  addError(place: ErrorPlace | null, report: ErrorReport, device = 0): void {
    this.show();
    this.logOf(device).add({ kind: 'error', place, report });
    this.isNew.value = true;
    this.show();
  }

  /** Shows the last traceback quietly: the pupil has stopped the program. */
  quieten(device = 0): void {
    this.show();
    this.logOf(device).quieten();
    this.show();
  }

  clear(): void {
    this.pending.length = 0;
    this.together.clear();
    for (const log of this.logs) log.clear();
    this.show();
    this.isNew.value = false;
  }

  /** Notes that the pupil goes to the REPL. */
  visitRepl(): void {
    if (!this.isReplVisited.value) this.visited.value = new Set([...this.visited.value, this.run.value]);
  }

  /** Everything that is kept of the device that is shown, as text. */
  toText(): string {
    this.show();
    return this.logOf(this.device()).toText();
  }

  private logOf(device: number): ConsoleLog {
    for (let place = this.logs.length; place <= device; place++)
      this.logs.push(new ConsoleLog(() => this.table(place)));
    return this.logs[device] as ConsoleLog;
  }

  private show(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    for (const [device, text] of this.pending.entries()) {
      if (!text) continue;
      this.logOf(device).write(text);
      this.isNew.value = true;
    }
    this.pending.length = 0;
    this.together.show();
    this.lists.value = this.logs.map(({ entries }) => entries);
  }
}
