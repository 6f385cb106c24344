import { taskOf } from '#check/task/read-task';
import { projectOfTask } from '#check/task/write-task';
import type { WorldResult } from '#check/result';
import { isRecord } from '#core/record';
import type { Project } from '#project/project';

import { entriesIn, inStore, type Entry } from '../../session/work/storage/database';
import type { KeptRow, OpenTask } from './model/class-model';

/** Names of the class's entries in the browser's database. */
const TASK = 'class.task';
const ROW = 'class.row.';
const all = (): IDBKeyRange => IDBKeyRange.bound('class.', 'class.~');

/** The version of what is written. */
const VERSION = 1;

/** A class as it is stored in the browser's database. */
export interface KeptClass {
  readonly task: OpenTask | null;
  readonly rows: readonly KeptRow[];
  /** The time of the writing and a random number: no other writing has the same. */
  readonly stamp: string;
}

/** The part of a class that has to be written. */
export interface Writing {
  readonly task: OpenTask | null;
  /** Number of hand-ins. */
  readonly count: number;
  /** The hand-ins that have changed, with their places. */
  readonly changed: readonly { readonly row: KeptRow; readonly place: number }[];
  /** True if all earlier entries of a class are deleted. */
  readonly isNew: boolean;
  readonly stamp: string;
}

/**
 * Writes a class in one step.
 *
 * @param known the stamp that must be stored now, `null` for no class; left out: any
 * @returns whether it was written: not if another tab has written since
 */
export async function writeClass(writing: Writing, known?: string | null): Promise<boolean> {
  const { task, count, changed, isNew, stamp } = writing;
  const head = entry(TASK, { version: VERSION, count, stamp, task: task && keptTask(task) });
  const entries = changed.map(({ row, place }) => entry(nameOfRow(place), row));
  let isWritten = false;
  await inStore('readwrite', (store) => {
    const request = store.getAll(TASK) as IDBRequest<Entry[]>;
    request.onsuccess = () => {
      const lies = request.result[0];
      if (known !== undefined && (lies === undefined ? null : stampIn(lies.text)) !== known) return;
      isWritten = true;
      if (isNew) store.delete(all());
      for (const one of [head, ...entries]) store.put(one);
    };
  });
  return isWritten;
}

/** Deletes the stored class; without a database there is none. */
export async function deleteClass(): Promise<void> {
  try {
    await inStore('readwrite', (store) => void store.delete(all()));
  } catch {
    // There is no database.
  }
}

/**
 * The stored class; `null`: none.
 *
 * @throws TypeError or SyntaxError (as a rejection) where it is not as it must be
 */
export async function readClass(): Promise<KeptClass | null> {
  const entries = await entriesIn(all());
  const texts = new Map(entries.map(({ name, text }) => [name, text]));
  const text = texts.get(TASK);
  if (text === undefined) return null;
  const head: unknown = JSON.parse(text);
  if (!isRecord(head) || head['version'] !== VERSION || typeof head['count'] !== 'number') throw new TypeError(TASK);
  const rows = Array.from({ length: head['count'] }, (_, place) => rowIn(texts.get(nameOfRow(place)) ?? 'null'));
  return { task: head['task'] === null ? null : taskIn(head['task']), rows, stamp: stampIn(text) };
}

/** Name of a row's entry: the names sort in the order of the places. */
const nameOfRow = (place: number): string => `${ROW}${String(place).padStart(6, '0')}`;

/** The work's entries are deleted when they are old; a class stays until it is forgotten. */
const entry = (name: string, value: object): Entry => ({ name, text: JSON.stringify(value), usedMs: Infinity });

const keptTask = ({ name, from, task }: OpenTask): object => ({ name, from, project: projectOfTask(task) });

/** The stamp of a stored class; empty for one from before there were stamps, or a damaged one. */
function stampIn(text: string): string {
  try {
    const head: unknown = JSON.parse(text);
    return isRecord(head) && typeof head['stamp'] === 'string' ? head['stamp'] : '';
  } catch {
    return '';
  }
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
  const row = value as unknown as KeptRow;
  // Ways had no times once: then it is checked again.
  const hasTimes = row.result?.worlds.every(({ trailMs }: Partial<WorldResult>) => trailMs !== undefined) ?? true;
  return hasTimes ? row : { ...row, result: null };
}
