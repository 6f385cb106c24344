import { existsSync } from 'node:fs';
import { basename } from 'node:path';
import { taskOf } from '#check/task/read-task';
import type { ClassTask } from '#check/task/task';
import { openJson } from '#project/open-json';
import { MAIN, projectLimits, type Project } from '#project/project';
import type { Scene } from '#scene/scene';
import { readLimited } from '../read-files';
import { readyProject } from '../ready-courses';
import { isAddress, openAddress } from '../read-work';

/** A task with the name that reports have for it. */
export interface NamedTask {
  readonly name: string;
  readonly task: ClassTask;
}

type Problem = { readonly problem: string };

/** The task behind a word of the command line: a task file, a project or a course, a link, the id of a ready course. */
export async function readTask(word: string): Promise<NamedTask | Problem> {
  const opened = await projectOf(word);
  if ('problem' in opened) return opened;
  const { project, name } = opened;
  const read = taskOf(project);
  if ('problem' in read) return { problem: `${shortened(word)}: ${read.problem}` };
  return { name: read.task.id || name, task: read.task };
}

async function projectOf(word: string): Promise<{ readonly project: Project; readonly name: string } | Problem> {
  if (isAddress(word)) {
    const opened = await openAddress(word);
    if ('problem' in opened) return { problem: `${shortened(word)}: ${opened.problem}` };
    if (!('project' in opened)) return { problem: `${shortened(word)}: is a program, and no task.` };
    return { project: opened.project, name: opened.project.scene.name || 'link' };
  }
  const ready = existsSync(word) ? null : readyProject(word);
  if (ready !== null) return { project: ready, name: word };
  const file = readLimited(word, projectLimits.textCharacters * 4);
  if ('problem' in file)
    return isId(word) ? { problem: `${file.problem} There is no ready course "${word}" either.` } : file;
  const opened = openJson(file.text);
  if (opened.kind === 'problem') return { problem: `${word}: ${opened.problem}` };
  const project = opened.kind === 'scene' ? projectOfScene(opened.scene) : opened.project;
  return { project, name: project.scene.name || basename(word).replace(/(\.parcours)?\.json$/i, '') };
}

const isId = (word: string): boolean => /^[\w-]+$/.test(word);

const projectOfScene = (scene: Scene): Project => ({ files: [{ name: MAIN, text: '' }], scene, course: null });

/** An address may be as long as a program. */
const shortened = (word: string): string => (word.length > 60 ? `${word.slice(0, 57)}…` : word);
