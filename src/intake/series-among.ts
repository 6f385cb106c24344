import { unread } from '#check/hand-in/unread';
import { looksLikeSeries } from '#check/series/read-series';
import { seriesLimits, type Series, type SeriesTask } from '#check/series/series';
import { SERIES_FILE } from '#check/series/write-series';
import type { ReadyCourses } from '#project/link/link';
import { unreadable, type SeriesDocument, type Unreadable } from './document';
import { bytesOf, textOf, type Opened } from './file';
import { formatOf, lastOf, limits, stemOf } from './formats';
import { readTasks, type LoadFile } from './read-files';
import { documentOfText, taskIn } from './text';
import type { TreeFile } from './tree';

/** A series that came among files, with the tasks in the others. */
export interface SeriesAmong {
  readonly document: SeriesDocument | Unreadable;
  /** The files that do not belong to it. */
  readonly rest: readonly Opened[];
}

/** The series among files that came together, also in the zip of its folder; `null`: there is none. Never rejects. */
export async function seriesAmong(all: readonly Opened[], courses: ReadyCourses): Promise<SeriesAmong | null> {
  for (const one of all) {
    const zipped = one.zip !== null && 'entries' in one.zip ? await seriesInZip(one.zip.entries, courses) : null;
    if (zipped !== null) return { document: zipped, rest: all.filter((other) => other !== one) };
    const text = formatOf(one.file.path) === 'json' ? await jsonIn(one.file) : '';
    if (typeof text !== 'string' || !looksLikeSeries(text)) continue;
    const used = new Set([one]);
    const document = await seriesIn(text, courses, async (file) => {
      const beside = all.find((other) => lastOf(other.file.path) === lastOf(file) && isJson(other.file));
      if (beside !== undefined) used.add(beside);
      const read = beside && (await jsonIn(beside.file));
      return typeof read === 'string' ? { text: read } : null;
    });
    return { document, rest: all.filter((other) => !used.has(other)) };
  }
  return null;
}

async function seriesInZip(
  entries: readonly TreeFile[],
  courses: ReadyCourses,
): Promise<SeriesDocument | Unreadable | null> {
  const files = entries.filter(isJson);
  if (sumOf(files) > limits.tasksInZip) return null;
  const named = (name: string): TreeFile | undefined => files.find(({ path }) => lastOf(path) === name);
  const first = named(SERIES_FILE);
  const text = first && (await jsonIn(first));
  if (typeof text !== 'string' || !looksLikeSeries(text)) return null;
  return seriesIn(text, courses, async (file) => {
    const beside = named(lastOf(file));
    const read = beside && (await jsonIn(beside));
    return typeof read === 'string' ? { text: read } : null;
  });
}

async function seriesIn(text: string, courses: ReadyCourses, load: LoadFile): Promise<SeriesDocument | Unreadable> {
  const document = documentOfText(text, courses);
  if (document.kind === 'series') return { ...document, series: await readTasks(document.series, load) };
  return document as Unreadable; // what looks like a series is one, or unreadable
}

/** Tasks in files, whole series, and what is neither. */
export interface TasksAmong {
  readonly tasks: readonly Omit<SeriesTask, 'id'>[];
  /** Those in files of series, in which each file beside is read. */
  readonly series: readonly Series[];
  readonly unreadable: readonly { readonly file: string; readonly document: Unreadable }[];
}

/** The tasks in files that came together, also in zips. Never rejects. */
export async function tasksAmong(all: readonly Opened[], courses: ReadyCourses): Promise<TasksAmong> {
  const [tasks, series]: [Omit<SeriesTask, 'id'>[], Series[]] = [[], []];
  const { texts, unreadable: refused } = await textsIn(all);
  const beside = new Map([...texts].map(([path, text]) => [lastOf(path), text]));
  const isUsed = new Set<string>();
  for (const [path, text] of texts) {
    if (!looksLikeSeries(text)) continue;
    const document = await seriesIn(text, courses, (file) => {
      isUsed.add(lastOf(file));
      const found = beside.get(lastOf(file));
      return Promise.resolve(found === undefined ? null : { text: found });
    });
    if (document.kind === 'series') series.push(document.series);
    else refused.push({ file: path, document });
  }
  for (const [path, text] of texts) {
    if (looksLikeSeries(text) || isUsed.has(lastOf(path))) continue;
    const task = taskIn(documentOfText(text, courses));
    if (!('project' in task)) refused.push({ file: path, document: task });
    else {
      const { project } = task;
      const title = project.scene.name === '' ? stemOf(path).slice(0, seriesLimits.titleCharacters) : '';
      tasks.push({ title, from: { kind: 'project', project } });
    }
  }
  return { tasks, series, unreadable: refused };
}

/** The JSON files among what came, by their paths; of a zip more than a teacher has is told, and never unpacked. */
async function textsIn(all: readonly Opened[]) {
  const texts = new Map<string, string>();
  const refused: { readonly file: string; readonly document: Unreadable }[] = [];
  const take = async (file: TreeFile, shown: string): Promise<void> => {
    const read = await jsonIn(file);
    if (typeof read === 'string') texts.set(file.path, read);
    else refused.push({ file: shown, document: read });
  };
  for (const { file, zip } of all) {
    const { path } = file;
    if (zip === null && isJson(file)) await take(file, path);
    else if (zip === null) refused.push({ file: path, document: unreadable(unread('kind').problem) });
    else if ('problem' in zip) refused.push({ file: path, document: unreadable(zip.problem) });
    else {
      const files = zip.entries.filter(isJson);
      const isMuch = sumOf(files) > limits.tasksInZip;
      const much = unread('zip-much', { most: limits.tasksInZip });
      if (isMuch) refused.push({ file: path, document: unreadable(much.problem) });
      else for (const entry of files) await take(entry, `${path}/${entry.path}`);
    }
  }
  return { texts, unreadable: refused };
}

const isJson = ({ path }: TreeFile): boolean => formatOf(path) === 'json';

const sumOf = (files: readonly TreeFile[]): number => files.reduce((sum, { size }) => sum + size, 0);

/** The text of a file of JSON, or why there is none. */
async function jsonIn(file: TreeFile): Promise<string | Unreadable> {
  // A zip's directory may tell less than there is.
  const read = await bytesOf(file, limits.json, Math.min(limits.json, file.size));
  if ('problem' in read) return unreadable(read.problem);
  return textOf(read.bytes) ?? unreadable(unread('not-text').problem);
}
