import { effectScope, shallowRef, watch } from 'vue';

import { classTabs, type ClassNews, type ClassTabs } from './class-tabs';
import { deleteClass, readClass, writeClass } from './kept-class';
import type { ClassModel, OpenTask, Row } from './model/class-model';

/** After a change that goes on, such as typing, only its end is written. Chosen, in ms. */
const QUIET_MS = 400;

/**
 * The reason why a class is not stored: it could not be written · what was stored cannot be read · another tab stores
 * another one · another tab has ended it.
 */
export type KeepProblem = 'failed' | 'lost' | 'other' | 'ended';

/** The content of the database, as this tab knows it. */
interface Written {
  readonly task: OpenTask | null;
  readonly rows: readonly Row[];
  /** `null`: there is nothing. */
  readonly stamp: string | null;
}

const nothing: Written = { task: null, rows: [], stamp: null };

/**
 * Stores a class in the browser's database, if somebody wants that: its task, what was handed in, results and notes.
 * Nothing of it is ever part of a link or a file. Of several tabs each follows what another one writes; where both have
 * changed something, somebody chooses.
 */
export class ClassKeeper {
  /** True once a stored class, if there is one, has been restored. */
  readonly isReady = shallowRef(false);
  readonly isKept = shallowRef(false);
  /** True if another tab has written the class, too. */
  readonly isShared = shallowRef(false);
  readonly problem = shallowRef<KeepProblem | null>(null);
  private written = nothing;
  private timer: ReturnType<typeof setTimeout> | null = null;
  private working: Promise<void> = Promise.resolve();

  constructor(
    private readonly model: ClassModel,
    private readonly tabs: ClassTabs = classTabs(),
  ) {
    effectScope(true).run(() => watch([model.task, model.rows, model.isChecking], () => this.later()));
    tabs.hear((news) => void this.after(() => this.hear(news)));
    void this.after(() => this.bringBack());
  }

  /** Begins to store the class, or ends it: then nothing of it is left in the browser. */
  keep(wish: boolean): Promise<void> {
    this.isKept.value = wish;
    this.problem.value = null;
    return this.after(() => (wish ? this.write('new') : this.forget()));
  }

  /** Puts the class of this tab in the place of that of the other. */
  keepThis(): Promise<void> {
    this.isKept.value = true;
    this.problem.value = null;
    return this.after(() => this.write('instead'));
  }

  /** Puts the class of the other tab in the place of that of this one. */
  takeOther(): Promise<void> {
    this.problem.value = null;
    return this.after(() => this.bringBack());
  }

  /** Runs an action after those before it. */
  private after(act: () => Promise<void>): Promise<void> {
    return (this.working = this.working.then(act));
  }

  private async bringBack(): Promise<void> {
    try {
      if (await this.restore()) {
        this.isKept.value = true;
        void this.model.check();
      }
    } catch (error) {
      if (error instanceof TypeError || error instanceof SyntaxError) {
        this.problem.value = 'lost';
        await this.forget();
      }
      // A browser without a database has kept nothing.
    }
    this.isReady.value = true;
  }

  /** @returns whether a class lay there */
  private async restore(): Promise<boolean> {
    const kept = await readClass();
    if (kept === null) return false;
    this.model.restore(kept.task, kept.rows);
    const { task, rows } = this.model;
    this.written = { task: task.value, rows: rows.value, stamp: kept.stamp };
    return true;
  }

  /**
   * Takes over what another tab has written. If this tab has changes of its own that are not written yet, they stay:
   * writing them will find those of the other tab.
   */
  private async hear(news: ClassNews): Promise<void> {
    if (!this.isKept.value) return;
    if (news === 'ended') {
      this.end('ended');
      return;
    }
    this.isShared.value = true;
    // The tab that has added hand-ins checks them.
    if (this.isWritten()) await this.restore().catch(() => this.end('lost'));
  }

  private end(problem: KeepProblem): void {
    this.isKept.value = false;
    this.written = nothing;
    this.problem.value = problem;
  }

  private isWritten(): boolean {
    const { written, model } = this;
    return written.stamp !== null && written.task === model.task.value && written.rows === model.rows.value;
  }

  private later(): void {
    if (!this.isKept.value) return;
    if (this.timer !== null) clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.after(() => this.write('changes')), QUIET_MS);
  }

  /** @param wish `instead`: whatever another tab has written */
  private async write(wish: 'new' | 'changes' | 'instead'): Promise<void> {
    if (!this.isKept.value || (wish === 'changes' && this.isWritten())) return;
    const { model, written } = this;
    const [task, rows] = [model.task.value, model.rows.value];
    const before = wish === 'changes' && rows.length >= written.rows.length ? written.rows : [];
    const changed = rows.flatMap((row, place) => (row === before[place] ? [] : [{ row, place }]));
    const stamp = `${String(Date.now())} ${String(Math.random())}`;
    try {
      const kept = await Promise.all(changed.map(async ({ row, place }) => ({ row: await model.keptRow(row), place })));
      const writing = { task, count: rows.length, changed: kept, isNew: before !== written.rows, stamp };
      const isDone = await writeClass(writing, wish === 'instead' ? undefined : written.stamp);
      if (!isDone) {
        this.end('other');
        return;
      }
      this.written = { task, rows, stamp };
      this.tabs.tell('written');
    } catch {
      this.end('failed');
      await this.forget();
    }
  }

  private async forget(): Promise<void> {
    this.written = nothing;
    this.isShared.value = false;
    await deleteClass();
    this.tabs.tell('ended');
  }
}
