import { effectScope, shallowRef, watch } from 'vue';

import { taskOf } from '#check/task/read-task';
import { projectOfTask } from '#check/task/write-task';
import { isRecord } from '#core/record';
import type { Project } from '#project/project';

import { inStore, type Entry } from '../work/storage/database';
import type { ClassModel, KeptRow, OpenTask, Row } from './class-model';

/** Names in the browser's database; what else lies there is the work's. */
const TASK = 'class.task';
const ROW = 'class.row.';
const all = (): IDBKeyRange => IDBKeyRange.bound('class.', 'class.~');

/** The version of what is written. */
const VERSION = 1;
/** After a change that goes on, such as typing, only its end is written. Chosen, in ms. */
const QUIET_MS = 400;

/**
 * Keeps a class in the browser's database, if somebody wants that: its task, what was handed in, results and notes.
 * Nothing of it is ever part of a link or a file.
 */
export class ClassKeeper {
  /** It is known whether a class was kept, and it is there. */
  readonly isReady = shallowRef(false);
  readonly isKept = shallowRef(false);
  /** It could not be written, or what was kept cannot be read. */
  readonly problem = shallowRef<'failed' | 'lost' | null>(null);
  /** What is in the database, by its place. */
  private written: readonly Row[] = [];
  private timer: ReturnType<typeof setTimeout> | null = null;
  private working: Promise<void> = Promise.resolve();

  constructor(private readonly model: ClassModel) {
    effectScope(true).run(() => watch([model.task, model.rows, model.isChecking], () => this.later()));
    void this.bringBack();
  }

  /** Begins to keep the class, or ends it: then nothing of it is left in the browser. */
  keep(wish: boolean): Promise<void> {
    this.isKept.value = wish;
    this.problem.value = null;
    return wish ? this.save() : this.forget();
  }

  private async bringBack(): Promise<void> {
    try {
      const kept = await readAll();
      if (kept !== null) {
        void this.model.restore(kept.task, kept.rows);
        this.written = this.model.rows.value;
        this.isKept.value = true;
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

  private later(): void {
    if (!this.isKept.value) return;
    if (this.timer !== null) clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.save(), QUIET_MS);
  }

  /** Writes what has changed, one time after the other. */
  private save(): Promise<void> {
    return (this.working = this.working.then(() => this.isKept.value ? this.write() : undefined)); // prettier-ignore
  }

  private async write(): Promise<void> {
    const { task, rows } = this.model;
    const now = rows.value;
    const before = now.length < this.written.length ? [] : this.written;
    const head: Entry = entry(TASK, { version: VERSION, count: now.length, task: task.value && keptTask(task.value) });
    const changed = now.flatMap((row, place) => (row === before[place] ? [] : [{ row, place }]));
    try {
      const entries = await Promise.all(
        changed.map(async ({ row, place }) => entry(nameOfRow(place), await this.model.keptRow(row))),
      );
      await inStore('readwrite', (store) => {
        if (before !== this.written) store.delete(all());
        for (const one of [head, ...entries]) store.put(one);
      });
      this.written = now;
    } catch {
      this.isKept.value = false;
      this.problem.value = 'failed';
      await deleteAll();
    }
  }

  private forget(): Promise<void> {
    return (this.working = this.working.then(async () => {
      this.written = [];
      await deleteAll();
    }));
  }
}

/** In the order of their places. */
const nameOfRow = (place: number): string => `${ROW}${String(place).padStart(6, '0')}`;

/** The work's entries are deleted when they are old; a class stays until it is forgotten. */
const entry = (name: string, value: object): Entry => ({ name, text: JSON.stringify(value), usedMs: Infinity });

const keptTask = ({ name, from, task }: OpenTask): object => ({ name, from, project: projectOfTask(task) });

async function deleteAll(): Promise<void> {
  try {
    await inStore('readwrite', (store) => void store.delete(all()));
  } catch {
    // A browser that takes nothing has nothing.
  }
}

/**
 * What was kept; `null`: nothing.
 *
 * @throws TypeError or SyntaxError (as a rejection) where it is not as it must be
 */
async function readAll(): Promise<{ readonly task: OpenTask | null; readonly rows: readonly KeptRow[] } | null> {
  let entries: readonly Entry[] = [];
  await inStore('readonly', (store) => {
    const request = store.getAll(all()) as IDBRequest<Entry[]>;
    request.onsuccess = () => (entries = request.result);
  });
  const texts = new Map(entries.map(({ name, text }) => [name, text]));
  const text = texts.get(TASK);
  if (text === undefined) return null;
  const head: unknown = JSON.parse(text);
  if (!isRecord(head) || head['version'] !== VERSION || typeof head['count'] !== 'number') throw new TypeError(TASK);
  const rows = Array.from({ length: head['count'] }, (_, place) => rowIn(texts.get(nameOfRow(place)) ?? 'null'));
  return { task: head['task'] === null ? null : taskIn(head['task']), rows };
}

function taskIn(value: unknown): OpenTask {
  if (!isRecord(value) || !isRecord(value['project'])) throw new TypeError('task');
  const read = taskOf(value['project'] as unknown as Project);
  if ('problem' in read) throw new TypeError(read.problem);
  // What was open then need not be now.
  const from = value['from'] === 'open' ? 'kept' : String(value['from']);
  return { name: String(value['name']), from, task: read.task };
}

function rowIn(text: string): KeptRow {
  const value: unknown = JSON.parse(text);
  if (!isRecord(value) || !isRecord(value['content']) || typeof value['name'] !== 'string') throw new TypeError('row');
  return value as unknown as KeptRow;
}
