import { basename } from 'node:path';
import { taskOf } from '#check/task/read-task';
import type { ClassTask } from '#check/task/task';
import type { Language } from '#core/languages';
import { documentOfSeriesLink, seriesLinkOf } from '#intake/address';
import { limits, stemOf } from '#intake/formats';
import { documentOfText, taskIn } from '#intake/text';
import { isNoFile, readLimited } from '../read-files';
import { readyCourse, readyProject, readyTitle } from '../ready-courses';
import { addressProblem, documentAt, isAddress, shortened } from '../read-work';
import { partsOf, taskInFile, taskOfLink, withoutReload, type OpenedTask } from './series-task';

/** A task with the names that reports have for it. */
export interface NamedTask {
  readonly name: string;
  /** Its title in its series; left out: it belongs to none, or has no title there. */
  readonly title?: string;
  readonly task: ClassTask;
}

type Problem = { readonly problem: string };

/**
 * The task behind a word of the command line: a task file, a project or a course, a link, the id of a ready course, or one of a
 * series, which is said behind `#`.
 *
 * @returns also the files that it may be read from
 */
export async function readTask(word: string): Promise<(NamedTask & { readonly files: readonly string[] }) | Problem> {
  const opened = await openedTask(word);
  if ('problem' in opened) return opened;
  const { project, name, beside = [], ...titled } = opened;
  const read = taskOf(project);
  if ('problem' in read) return { problem: `${shortened(word)}: ${read.problem}` };
  const files = isAddress(word) ? [] : [partsOf(word).where, ...beside];
  return { name: read.task.id || name, ...titled, task: read.task, files };
}

/** The tasks behind a word: all of a series, in their order, else the one. */
export async function readTasks(
  word: string,
): Promise<readonly (NamedTask & { readonly files: readonly string[] })[] | Problem> {
  const { where, which } = partsOf(word);
  const count = which === '' ? seriesLength(where) : null;
  const words = count === null ? [word] : Array.from({ length: count }, (_, place) => `${where}#${String(place + 1)}`);
  const tasks = [];
  for (const one of words) {
    const read = await readTask(one);
    if ('problem' in read) return read;
    tasks.push(read);
  }
  return tasks;
}

/** Number of tasks of a series; `null`: it is none, or one without tasks. */
function seriesLength(where: string): number | null {
  const link = seriesLinkOf(where);
  if (link === null && (isAddress(where) || isNoFile(where))) return null;
  const file = link === null ? readLimited(where, limits.json) : null;
  const document = link !== null ? documentOfSeriesLink(link, readyCourse) : file && 'text' in file ? documentOfText(file.text, readyCourse) : null; // prettier-ignore
  return document?.kind === 'series' ? document.series.tasks.length || null : null;
}

async function openedTask(word: string): Promise<OpenedTask | Problem> {
  const { where, which } = partsOf(word);
  const link = seriesLinkOf(where);
  if (link !== null) return saidOf(shortened(word), await taskOfLink(link, which));
  if (isAddress(word)) return taskOfAddress(word);
  const ready = isNoFile(where) ? readyProject(where) : null;
  if (ready !== null) return which === '' ? { project: ready, name: where } : isSingle(where, which);
  const file = readLimited(where, limits.json);
  if ('problem' in file)
    return isId(where) ? { problem: `${file.problem} There is no ready course "${where}" either.` } : file;
  const document = documentOfText(file.text, readyCourse);
  if (document.kind === 'series')
    return saidOf(which === '' ? where : word, await taskInFile(where, document.series, which));
  const task = taskIn(document);
  if (!('project' in task)) return { problem: `${word}: ${withoutReload(task.message)}` };
  if (which !== '') return isSingle(where, which);
  return { project: task.project, name: task.project.scene.name || stemOf(basename(where)) };
}

async function taskOfAddress(address: string): Promise<OpenedTask | Problem> {
  const word = shortened(address);
  if (/#series=/.test(address))
    return { problem: `${word}: The series lies on a web server. Save its file, and name that.` };
  const document = await documentAt(address);
  if (document.kind === 'project') return { project: document.project, name: document.project.scene.name || 'link' };
  const task = document.kind === 'course' ? taskIn(document) : null;
  if (task !== null && 'project' in task) return { project: task.project, name: 'link' };
  const isProgram = document.kind === 'program';
  return { problem: `${word}: ${isProgram ? 'is a program, and no task.' : addressProblem(document)}` };
}

const saidOf = (word: string, opened: OpenedTask | Problem): OpenedTask | Problem =>
  'problem' in opened ? { problem: `${word}: ${opened.problem}` } : opened;

const isSingle = (where: string, which: string): Problem => ({
  problem: `${where}: is one task and no series. Leave out #${which}.`,
});

const isId = (word: string): boolean => /^[\w-]+$/.test(word);

/** The task's name for reports: its id, else the title in its series or of its ready course, else its course's name. */
export const titleOf = ({ name, title, task: { id, project } }: NamedTask, language: Language): string =>
  id || (title ?? readyTitle(project.course, language) ?? (project.scene.name || name));
