import { computed, shallowRef, type ComputedRef, type ShallowRef } from 'vue';

import { ConsoleLog, type ConsoleEntry, type ErrorPlace } from './log/console-log';
import { foldGreetings } from './log/fold-greeting';
import type { OnTable } from '../work/hardware/misplugged';
import type { ErrorReport } from './advice/error-advice';
import type { TextKey } from '../page/i18n/texts';

/** How often new output is shown, in ms. Not by animation frames: those stop in a tab that is not seen. */
const SHOW_EVERY_MS = 50; // chosen: 20 times a second reads as at once

/** The console as the page shows it: output is gathered and shown in one go, twenty times a second at most. */
export class ConsoleModel {
  readonly entries: ShallowRef<readonly ConsoleEntry[]> = shallowRef([]);
  readonly isCut = shallowRef(false);
  /** There is output the pupil may not have seen, on a screen where the console is behind a tab. */
  readonly isNew = shallowRef(false);
  /** Counts what the pupil has sent: from then on the console shows its end. */
  readonly sent = shallowRef(0);
  /** Somebody has been at the REPL of the last run: from then on the console shows what the REPL says. */
  readonly isReplVisited: ComputedRef<boolean> = computed(() => this.visited.value.has(this.run.value));
  /** Numbers of the runs of which this is so. */
  private readonly visited = shallowRef<ReadonlySet<number>>(new Set());
  private readonly run = shallowRef(0);
  /** What is shown of `entries`. */
  readonly shown: ComputedRef<readonly ConsoleEntry[]> = computed(() =>
    foldGreetings(this.entries.value, this.visited.value, this.run.value),
  );
  private readonly log: ConsoleLog;
  private pending = '';
  private timer: ReturnType<typeof setTimeout> | undefined;

  /** @param table what is plugged in, for errors of a robot that does not answer */
  constructor(table: () => OnTable | null) {
    this.log = new ConsoleLog(table);
  }

  /** Adds output of the program. */
  write(text: string): void {
    this.pending += text;
    this.timer ??= setTimeout(() => this.show(), SHOW_EVERY_MS);
  }

  startRun(number: number): void {
    this.show();
    this.run.value = number;
    this.log.add({ kind: 'run', number });
    this.show();
  }

  /** Adds a sentence of the app itself. */
  addNote(key: TextKey): void {
    this.show();
    this.log.add({ kind: 'note', key });
    this.show();
  }

  addError(place: ErrorPlace | null, report: ErrorReport): void {
    this.show();
    this.log.add({ kind: 'error', place, report });
    this.isNew.value = true;
    this.show();
  }

  /** The pupil stopped the program: its last traceback is not an alarm. */
  quieten(): void {
    this.show();
    this.log.quieten();
    this.show();
  }

  clear(): void {
    this.pending = '';
    this.log.clear();
    this.show();
    this.isNew.value = false;
  }

  /** The pupil goes to the REPL. */
  visitRepl(): void {
    if (!this.isReplVisited.value) this.visited.value = new Set([...this.visited.value, this.run.value]);
  }

  /** Everything that is kept, as text. */
  toText(): string {
    this.show();
    return this.log.toText();
  }

  private show(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    if (this.pending !== '') {
      this.log.write(this.pending);
      this.isNew.value = true;
      this.pending = '';
    }
    this.entries.value = this.log.entries;
    this.isCut.value = this.log.isCut;
  }
}
