import { existsSync } from 'node:fs';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { readTasks, type LoadFile } from '#intake/read-files';
import type { Series, SeriesTask } from '#check/series/series';
import { documentOfSeriesLink } from '#intake/address';
import { limits } from '#intake/formats';
import type { Project } from '#project/project';
import { readLimited } from '../read-files';
import { readyCourse, readyProject, readyTitle } from '../ready-courses';

type Problem = { readonly problem: string };

/** A task of a series as a project, with the names that reports have for it. */
export interface OpenedTask {
  readonly project: Project;
  readonly name: string;
  /** Its title in the series; left out: it has none. */
  readonly title?: string;
  /** The files that were read beside the one that was named. */
  readonly beside?: readonly string[];
}

/** A word of the command line in its parts: the part behind the last `#` selects a task of a series. */
export interface TaskWord {
  /** A file, a link, the id of a ready course. */
  readonly where: string;
  /** The selected task: a number from 1 or an id; empty: none is named. */
  readonly which: string;
}

/** An address that holds a series, or the part of it from `s=` on, and the part behind it. */
const LINK = /^((?:https?:\/\/[^#]*#|#)?s=\d[^#]*)(?:#(.*))?$/is;

/** The parts of a word other than a link to a project: a file may have `#` in its name. */
export function partsOf(word: string): TaskWord {
  const [, link, which = ''] = LINK.exec(word) ?? [];
  if (link !== undefined) return { where: link, which };
  const at = existsSync(word) ? -1 : word.lastIndexOf('#');
  return at < 1 ? { where: word, which: '' } : { where: word.slice(0, at), which: word.slice(at + 1) };
}

/** The series in a link. */
export function seriesInLink(link: string): Series | Problem {
  const document = documentOfSeriesLink(link, readyCourse);
  return document.kind === 'unreadable' ? { problem: withoutReload(document.message) } : document.series;
}

/** The task that is meant of the series in a link. */
export const taskInLink = (series: Series, which: string): Promise<OpenedTask | Problem> =>
  chosen(series, which, 'LINK', () => Promise.resolve({ problem: 'a link has no files beside it.' }));

/** The task that is meant of the series in a file. */
export async function taskInFile(path: string, series: Series, which: string): Promise<OpenedTask | Problem> {
  const beside: string[] = [];
  const task = await chosen(series, which, path, (file) => Promise.resolve(fileBeside(path, file, beside)));
  return 'problem' in task ? task : { ...task, beside };
}

/** The advice to reload is for people with the page open. */
export const withoutReload = (problem: string): string =>
  problem.replace(' Reload the page to update.', ' Update Parcours.');

/** A file beside a series: its address is seen from there, as on a web server. */
function fileBeside(series: string, file: string, found: string[]): { readonly text: string } | Problem {
  const base = pathToFileURL(series).href;
  const url = URL.canParse(file, base) ? new URL(file, base) : null;
  if (url?.protocol !== 'file:' || url.host !== '')
    return { problem: 'lies on a web server. Save it beside the series.' };
  const path = fileURLToPath(url);
  found.push(path);
  const read = readLimited(path, limits.json);
  return 'problem' in read ? { problem: read.problem.replace(`${path}: `, '') } : read;
}

/** @param word how the series is named on the command line */
async function chosen(series: Series, which: string, word: string, load: LoadFile): Promise<OpenedTask | Problem> {
  const found = taskNamed(series, which, word);
  if ('problem' in found) return found;
  const { tasks } = await readTasks({ ...series, tasks: [found] }, load);
  const [{ title, from } = found] = tasks;
  const said = title === '' ? {} : { title };
  if (from.kind === 'project') return { project: from.project, name: title || from.project.scene.name, ...said };
  if (from.kind !== 'course')
    return { problem: from.kind === 'unread' ? (from.said ?? withoutReload(from.problem)) : from.file };
  const project = readyProject(from.course);
  if (project === null) return { problem: `there is no ready course "${from.course}".` };
  return { project, name: title || from.course, ...said };
}

/** A number is always a place: ids stay when tasks change places. */
function taskNamed({ tasks }: Series, which: string, word: string): SeriesTask | Problem {
  if (tasks.length === 0) return { problem: 'there are no tasks in this series.' };
  if (which === '') return { problem: `is a series. Say which of its tasks, such as ${word}#1: ${namesOf(tasks)}` };
  const isPlace = /^\d+$/.test(which);
  const task = isPlace ? tasks[Number(which) - 1] : tasks.find(({ id }) => id === which);
  if (task !== undefined) return task;
  return {
    problem: isPlace
      ? `there are tasks 1 to ${tasks.length} in this series.`
      : `no task of this series has the id ${JSON.stringify(which)}. There are ${namesOf(tasks)}`,
  };
}

const namesOf = (tasks: readonly SeriesTask[]): string =>
  `${tasks.map((task, place) => `#${place + 1}${orId(task)}${called(task)}`).join(', ')}.`;

const orId = ({ id }: SeriesTask): string => (/^\d+$/.test(id) ? '' : ` or #${id}`);

function called({ title, from }: SeriesTask): string {
  const name = title || (from.kind === 'course' ? (readyTitle(from.course, 'en') ?? from.course) : nameIn(from));
  return name === '' ? '' : ` (${name})`;
}

const nameIn = (from: SeriesTask['from']): string =>
  from.kind === 'project' ? from.project.scene.name : from.kind === 'file' ? from.file : '';
