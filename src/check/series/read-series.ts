/**
 * Reads the file of a series, `parcours-series` version 1; `schemas/series.schema.json` describes it. A mistake in
 * the series itself refuses it; a mistake in one of its tasks is reported in that task's place, and the others work.
 */
import { isRecord } from '#core/record';
import { fnvOfText } from '#core/fnv';
import { readJsonFile, summaryOf } from '#scene/json-file';
import { shown, versionProblem } from '#scene/problem';
import { Reader, type Fields } from '#scene/reader';
import { formatOf, parseProjectValue } from '#project/file';
import { projectOfLink, type ReadyCourses, type Room } from '#project/link/link';
import type { ProjectProblem } from '#project/problem';
import { readAbout } from '../task/about';
import { freeTaskId, seriesLimits, type Series, type SeriesTask, type TaskSource, type Unread } from './series';

/** The name of the format in a file. */
export const SERIES_FORMAT = 'parcours-series';

/** The version that this app writes, and the newest that it reads. A file of each version is stored in `kept/`. */
export const SERIES_VERSION = 1;

/** Mistakes of a series, in addition to those of a project file. */
export type SeriesProblemCode = ProjectProblem['code'] | 'not-a-series';

/** One thing that is wrong with a series as a whole. */
export interface SeriesProblem extends Omit<ProjectProblem, 'code'> {
  readonly code: SeriesProblemCode;
}

/** A series, or everything that is wrong with the file; `problem` is the first one's message and how many follow. */
export type ReadSeries =
  { readonly series: Series } | { readonly problem: string; readonly problems: readonly SeriesProblem[] };

/** True if a JSON value claims to be a series, of any version. */
export const isSeriesFile = (value: unknown): value is Fields => formatOf(value) === SERIES_FORMAT;

/** True if a text seems to be the file of a series: only then it is worth parsing. */
export const looksLikeSeries = (text: string): boolean =>
  /^\ufeff?\s*\{[^{[]*"format"\s*:\s*"parcours-series"/.test(text);

/** Reads the file of a series. Never throws. @param courses the ready courses, for links that name one */
export function parseSeries(text: string, courses: ReadyCourses): ReadSeries {
  const read = readJsonFile(text, 'series', seriesLimits.characters);
  return 'problem' in read ? refused([read.problem]) : parseSeriesValue(read.value, courses);
}

/** Reads a series that is already a JavaScript value. Never throws. */
export function parseSeriesValue(value: unknown, courses: ReadyCourses): ReadSeries {
  if (!isSeriesFile(value)) {
    const message = `This is not a series of tasks: "format" must be "${SERIES_FORMAT}".`;
    return refused([problemOf('not-a-series', 'format', formatOf(value), message)]);
  }
  const { version } = value;
  if (version !== SERIES_VERSION) return refused([versionProblem('Series', version, SERIES_VERSION)]);
  const reader = new Reader();
  const fields = reader.fields(value, '', ['format', 'version', 'id', 'title', 'text', 'tasks', 'about']);
  const title = reader.text(fields['title'], 'title', seriesLimits.titleCharacters, '');
  const entries = reader.list(fields['tasks'], 'tasks', seriesLimits.tasks);
  const given = reader.text(fields['id'], 'id', seriesLimits.idCharacters, '');
  if (!/^[\w-]*$/.test(given))
    reader.report('unknown-value', 'id', given, `${shown(given)} may have letters, digits, "_" and "-" only.`, {});
  const text = reader.text(fields['text'], 'text', seriesLimits.textCharacters, '');
  const about = readAbout(fields['about'], 'about', reader);
  if (reader.problems.length > 0) return refused(reader.problems);
  const tasks: SeriesTask[] = [];
  const links: Links = { courses, room: roomForLinks() };
  for (const [index, entry] of entries.entries()) tasks.push(taskIn(entry, index, tasks, links));
  const series = { id: given || idOf(title, entries), title, text, tasks };
  return { series: about === undefined ? series : { ...series, about } };
}

const refused = (problems: readonly SeriesProblem[]): ReadSeries => ({ problem: summaryOf(problems), problems });

const problemOf = (code: SeriesProblemCode, path: string, value: unknown, message: string): SeriesProblem => ({
  ...{ code, path, message, params: {} },
  value: value === undefined ? '' : shown(value),
});

/** Id of a series without one, as in files written by hand: the same for the same contents. */
const idOf = (title: string, tasks: readonly unknown[]): string =>
  `s${fnvOfText(JSON.stringify([title, tasks])).toString(36)}`;

/** The space left for the links of one series. */
export const roomForLinks = (): Room => ({ left: seriesLimits.linkedBytes });

/** Inputs for reading links. */
interface Links {
  readonly courses: ReadyCourses;
  readonly room: Room;
}

/** The four forms of saying where a task is. */
const SOURCES = ['course', 'project', 'link', 'file'] as const;

function taskIn(entry: unknown, index: number, before: readonly SeriesTask[], links: Links): SeriesTask {
  const reader = new Reader();
  const path = `tasks[${String(index)}]`;
  const fields = reader.fields(entry, path, ['id', 'title', ...SOURCES]);
  const id = reader.text(fields['id'], `${path}.id`, seriesLimits.idCharacters, '') || String(index + 1);
  const title = reader.text(fields['title'], `${path}.title`, seriesLimits.titleCharacters, '');
  const isTaken = before.some((other) => other.id === id);
  if (isTaken) reader.report('duplicate-id', `${path}.id`, id, `another task has the id ${JSON.stringify(id)}.`);
  const given = SOURCES.filter((source) => fields[source] !== undefined);
  if (given.length !== 1 && isRecord(entry)) {
    const what = `needs one of ${SOURCES.join(', ')}, and has ${given.length === 0 ? 'none' : given.join(', ')}.`;
    reader.report('missing', `${path}.course`, undefined, what, {});
  }
  const [source] = given;
  const from = reader.problems.length > 0 || source === undefined ? null : sourceIn(source, fields, path, links);
  return {
    id: isTaken ? freeTaskId(before) : id,
    title,
    from: from ?? unreadableTask(entry, reader.problems),
  };
}

function sourceIn(source: (typeof SOURCES)[number], fields: Fields, path: string, links: Links): TaskSource {
  const reader = new Reader();
  const at = `${path}.${source}`;
  const value = fields[source];
  if (source === 'project') return projectIn(fields, value, at);
  if (source === 'link') return linkedIn(fields, value, at, links);
  const text = reader.text(value, at, seriesLimits.fileCharacters);
  if (text === '') reader.report('missing', at, undefined, 'must not be empty.');
  if (reader.problems.length > 0) return unreadableTask(fields, reader.problems);
  return source === 'course' ? { kind: 'course', course: text } : { kind: 'file', file: text };
}

/** The task in a value that must be a project; a series in its place is reported as such. */
export function projectIn(entry: unknown, value: unknown, at: string): TaskSource {
  if (isSeriesFile(value)) {
    const message = `${at}: is a series itself; a series holds tasks only. Add its tasks one by one.`;
    return unreadableTask(entry, [{ ...problemOf('wrong-type', at, value, message), code: 'wrong-type' }]);
  }
  const parsed = parseProjectValue(value);
  if ('project' in parsed) return { kind: 'project', project: parsed.project };
  const inside = (problem: ProjectProblem): ProjectProblem => ({
    ...problem,
    path: `${at}.${problem.path}`,
    message: `${at}: ${problem.message}`,
  });
  return unreadableTask(entry, parsed.problems.map(inside));
}

function linkedIn(entry: unknown, value: unknown, at: string, { courses, room }: Links): TaskSource {
  if (room.left <= 0) {
    const max = seriesLimits.linkedBytes;
    const message = `${at}: Together the links of this series hold more than ${String(max)} bytes. Put this task in as a file.`;
    return unreadableTask(entry, [{ code: 'links-too-large', path: at, value: '', params: { max }, message }]);
  }
  const text = typeof value === 'string' ? value : '';
  const read = projectOfLink(text.slice(Math.max(text.indexOf('#'), 0)), courses, room);
  if ('project' in read) return { kind: 'project', project: read.project };
  const { message, params } = read.problem;
  return unreadableTask(entry, [{ code: 'damaged', path: at, value: '', params, message: `${at}: ${message}` }]);
}

/** A task that cannot be read. @param value its entry in the file */
export const unreadableTask = (value: unknown, problems: readonly ProjectProblem[]): Unread => ({
  kind: 'unread',
  value,
  problem: summaryOf(problems),
  problems,
});
