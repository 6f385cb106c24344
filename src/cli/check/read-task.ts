import { basename } from 'node:path';
import { taskOf } from '#check/task/read-task';
import type { ClassTask } from '#check/task/task';
import type { Language } from '#core/languages';
import type { Series } from '#check/series/series';
import { seriesLinkOf } from '#intake/address';
import { limits, stemOf } from '#intake/formats';
import { documentOfText, taskIn } from '#intake/text';
import { isNoFile, readLimited } from '../read-files';
import { noReadyCourse, readyCourse, readyProject, readyTitle } from '../ready-courses';
import { addressProblem, documentAt, isAddress, shortened } from '../read-work';
import { partsOf, seriesInLink, taskInFile, taskInLink, withoutReload, type OpenedTask } from './series-task';

/** A task with the names that reports have for it. */
export interface NamedTask {
  readonly name: string;
  /** Its title in its series; left out: it belongs to none, or has no title there. */
  readonly title?: string;
  readonly task: ClassTask;
}

type Problem = { readonly problem: string };

/** A task with the files that it may be read from. */
export type ReadTask = NamedTask & { readonly files: readonly string[] };

/** A series, and the way to each of its tasks by number or id. */
interface NamedSeries {
  readonly series: Series;
  readonly open: (which: string) => Promise<OpenedTask | Problem>;
}

/**
 * The task behind a word of the command line: a task file, a project or a course, a link, the id of a ready course, or one of a
 * series, which is said behind `#`.
 */
export async function readTask(word: string): Promise<ReadTask | Problem> {
  const named = await namedBy(word);
  return opened(word, 'series' in named ? await named.open(partsOf(word).which) : named);
}

/** The tasks behind a word: all of a series, in their order, else the one. */
export async function readTasks(word: string): Promise<readonly ReadTask[] | Problem> {
  const named = await namedBy(word);
  const isWhole = 'series' in named && partsOf(word).which === '' && named.series.tasks.length > 0;
  const which = isWhole ? named.series.tasks.map((_, place) => String(place + 1)) : [partsOf(word).which];
  const tasks: ReadTask[] = [];
  for (const one of which) {
    const read = opened(word, 'series' in named ? await named.open(one) : named);
    if ('problem' in read) return read;
    tasks.push(read);
  }
  return tasks;
}

function opened(word: string, task: OpenedTask | Problem): ReadTask | Problem {
  if ('problem' in task) return task;
  const { project, name, beside = [], ...titled } = task;
  const read = taskOf(project);
  if ('problem' in read) return { problem: `${shortened(word)}: ${read.problem}` };
  const files = isAddress(word) ? [] : [partsOf(word).where, ...beside];
  return { name: read.task.id || name, ...titled, task: read.task, files };
}

/** The task or the series that a word names. */
async function namedBy(word: string): Promise<OpenedTask | NamedSeries | Problem> {
  const { where, which } = partsOf(word);
  const link = seriesLinkOf(where);
  if (link !== null) {
    const series = seriesInLink(link);
    if ('problem' in series) return { problem: `${shortened(word)}: ${series.problem}` };
    return { series, open: async (one) => saidOf(shortened(word), await taskInLink(series, one)) };
  }
  if (isAddress(word)) return taskOfAddress(word);
  const ready = isNoFile(where) ? readyProject(where) : null;
  if (ready !== null) return which === '' ? { project: ready, name: where } : isSingle(where, which);
  const file = readLimited(where, limits.json);
  if ('problem' in file) {
    const more = noReadyCourse(where);
    return more === null ? file : { problem: `${file.problem} ${more}` };
  }
  const document = documentOfText(file.text, readyCourse);
  if (document.kind === 'series') {
    const { series } = document;
    const named = (one: string): string => (one === '' ? where : `${where}#${one}`);
    return { series, open: async (one) => saidOf(named(one), await taskInFile(where, series, one)) };
  }
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

/** The task's name for reports: its id, else the title in its series or of its ready course, else its course's name. */
export const titleOf = ({ name, title, task: { id, project } }: NamedTask, language: Language): string =>
  id || (title ?? readyTitle(project.course, language) ?? (project.scene.name || name));
