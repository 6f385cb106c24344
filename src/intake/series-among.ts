import { unread, type Unread } from '#check/hand-in/unread';
import { looksLikeSeries } from '#check/series/read-series';
import { seriesLimits, type Series, type SeriesTask } from '#check/series/series';
import { looksLikeShelf } from '#check/shelf/read-shelf';
import { SERIES_FILE } from '#check/series/write-series';
import type { ReadyCourses } from '#project/link/link';
import { unreadable, type SeriesDocument, type Unreadable } from './document';
import { decoded } from './decode';
import { bytesOf, type Opened } from './file';
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
  const loose = all.map(({ file }) => file).filter(isJson);
  for (const { file, zip } of all) {
    const inZip = zip === null ? null : jsonInZip(zip);
    if (inZip !== null && 'problem' in inZip) continue;
    const first = inZip === null ? file : inZip.files.find(({ path }) => lastOf(path) === SERIES_FILE);
    const text = first !== undefined && isJson(first) ? await jsonIn(first) : null;
    if (typeof text !== 'string' || !looksLikeSeries(text)) continue;
    const used = new Set([file]);
    const document = await seriesIn(text, courses, async (name) => {
      const beside = (inZip?.files ?? loose).find(({ path }) => lastOf(path) === lastOf(name));
      if (beside === undefined) return null;
      used.add(beside);
      const read = await jsonIn(beside);
      return typeof read === 'string' ? { text: read } : null;
    });
    return { document, rest: all.filter((other) => !used.has(other.file)) };
  }
  return null;
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
  const { texts, refused } = await textsIn(all);
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
    // The list of a shelf tells of the files beside it.
    if (looksLikeSeries(text) || looksLikeShelf(text) || isUsed.has(lastOf(path))) continue;
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

/** A series with the tasks beside it. What only looks like one is unreadable. */
async function seriesIn(text: string, courses: ReadyCourses, load: LoadFile): Promise<SeriesDocument | Unreadable> {
  const document = documentOfText(text, courses);
  if (document.kind === 'series') return { ...document, series: await readTasks(document.series, load) };
  return document as Unreadable;
}

/** The JSON files among what came, by their paths, and what is none. */
async function textsIn(all: readonly Opened[]) {
  const texts = new Map<string, string>();
  const refused: { readonly file: string; readonly document: Unreadable }[] = [];
  for (const { file, zip } of all) {
    const none = (problem: Unread): void => void refused.push({ file: file.path, document: unreadable(problem) });
    const found = zip === null ? { files: [file].filter(isJson) } : jsonInZip(zip);
    if ('problem' in found) none(found.problem);
    else if (zip === null && found.files.length === 0) none(unread('kind').problem);
    else
      for (const one of found.files) {
        const read = await jsonIn(one);
        if (typeof read === 'string') texts.set(one.path, read);
        else refused.push({ file: zip === null ? one.path : `${file.path}/${one.path}`, document: read });
      }
  }
  return { texts, refused };
}

/** The JSON files of a zip; more than `limits.tasksInZip` is a problem, and never unpacked. */
function jsonInZip(
  zip: NonNullable<Opened['zip']>,
): { readonly files: readonly TreeFile[] } | { readonly problem: Unread } {
  if ('problem' in zip) return zip;
  const files = zip.entries.filter(isJson);
  const size = files.reduce((sum, one) => sum + one.size, 0);
  return size > limits.tasksInZip ? unread('zip-much', { most: limits.tasksInZip }) : { files };
}

const isJson = ({ path }: TreeFile): boolean => formatOf(path) === 'json';

/** The text of a file of JSON, or why there is none. */
async function jsonIn(file: TreeFile): Promise<string | Unreadable> {
  // A zip's directory may tell less than there is.
  const read = await bytesOf(file, limits.json, Math.min(limits.json, file.size));
  if ('problem' in read) return unreadable(read.problem);
  return decoded(read.bytes)?.text ?? unreadable(unread('not-text').problem);
}
