import { basename } from 'node:path';
import { taskOf } from '#check/task/read-task';
import type { ClassTask } from '#check/task/task';
import { openJson } from '#project/open-json';
import { MAIN, projectLimits, type Project } from '#project/project';
import type { Scene } from '#scene/scene';
import { isNoFile, readLimited } from '../read-files';
import { readyProject } from '../ready-courses';
import { isAddress, openAddress } from '../read-work';
import { partsOf, seriesLinkIn, taskOfLink, taskOfSeriesFile, type OpenedTask } from './series-task';

/** A task with the names that reports have for it. */
export interface NamedTask {
  readonly name: string;
  /** As its series calls it; left out: it is of none, or has no name there. */
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

async function openedTask(word: string): Promise<OpenedTask | Problem> {
  const { where, which } = partsOf(word);
  const link = seriesLinkIn(where);
  if (link !== null) return saidOf(shortened(word), await taskOfLink(link, which));
  if (isAddress(word)) return taskOfAddress(word);
  const ready = isNoFile(where) ? readyProject(where) : null;
  if (ready !== null) return which === '' ? { project: ready, name: where } : isSingle(where, which);
  const file = readLimited(where, projectLimits.textCharacters * 4);
  if ('problem' in file)
    return isId(where) ? { problem: `${file.problem} There is no ready course "${where}" either.` } : file;
  const ofSeries = await taskOfSeriesFile(where, file.text, which);
  if (ofSeries !== null) return saidOf(which === '' ? where : word, ofSeries);
  const opened = openJson(file.text);
  if (opened.kind === 'problem') return { problem: `${where}: ${opened.problem}` };
  if (which !== '') return isSingle(where, which);
  const project = opened.kind === 'scene' ? projectOfScene(opened.scene) : opened.project;
  return { project, name: project.scene.name || basename(where).replace(/(\.parcours)?\.json$/i, '') };
}

async function taskOfAddress(address: string): Promise<OpenedTask | Problem> {
  const word = shortened(address);
  if (/#series=/.test(address))
    return { problem: `${word}: The series lies on a web server. Save its file, and name that.` };
  const opened = await openAddress(address);
  if ('problem' in opened) return { problem: `${word}: ${opened.problem}` };
  if (!('project' in opened)) return { problem: `${word}: is a program, and no task.` };
  return { project: opened.project, name: opened.project.scene.name || 'link' };
}

const saidOf = (word: string, opened: OpenedTask | Problem): OpenedTask | Problem =>
  'problem' in opened ? { problem: `${word}: ${opened.problem}` } : opened;

const isSingle = (where: string, which: string): Problem => ({
  problem: `${where}: is one task and no series. Leave out #${which}.`,
});

const isId = (word: string): boolean => /^[\w-]+$/.test(word);

const projectOfScene = (scene: Scene): Project => ({ files: [{ name: MAIN, text: '' }], scene, course: null });

/** An address may be as long as a program. */
const shortened = (word: string): string => (word.length > 60 ? `${word.slice(0, 57)}…` : word);
