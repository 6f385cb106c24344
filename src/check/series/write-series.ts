import { plainFileName } from '#core/plain-file-name';
import { projectToText } from '#project/file';
import type { Project } from '#project/project';
import { aboutData } from '../task/about';
import { withoutSecrets } from '../task/write-task';
import { SERIES_FORMAT, SERIES_VERSION } from './read-series';
import type { Series, SeriesTask, TaskSource } from './series';

/** A series as its file: readable JSON that ends in a newline. Reading it back gives an equal series. */
export function seriesToText({ id, title, text, tasks, about }: Series): string {
  const lines = [
    `"format": ${JSON.stringify(SERIES_FORMAT)}`,
    `"version": ${String(SERIES_VERSION)}`,
    `"id": ${JSON.stringify(id)}`,
    `"title": ${JSON.stringify(title)}`,
    ...(text === '' ? [] : [`"text": ${JSON.stringify(text)}`]),
    ...(about === undefined ? [] : [`"about": ${JSON.stringify(aboutData(about))}`]),
    tasks.length === 0 ? '"tasks": []' : `"tasks": [\n    ${tasks.map(taskText).join(',\n    ')}\n  ]`,
  ];
  return `{\n  ${lines.join(',\n  ')}\n}\n`;
}

function taskText({ id, title, from }: SeriesTask): string {
  // What cannot be read is written as it was.
  if (from.kind === 'unread') return JSON.stringify(from.value);
  const head = [`"id": ${JSON.stringify(id)}`, ...(title === '' ? [] : [`"title": ${JSON.stringify(title)}`])];
  return `{ ${[...head, sourceText(from)].join(', ')} }`;
}

function sourceText(from: Exclude<TaskSource, { readonly kind: 'unread' }>): string {
  if (from.kind === 'course') return `"course": ${JSON.stringify(from.course)}`;
  if (from.kind === 'file') return `"file": ${JSON.stringify(from.file)}`;
  return `"project": ${projectToText(from.project).trimEnd().replaceAll('\n', '\n    ')}`;
}

/**
 * A series as pupils get it: of its tasks neither solutions nor hidden worlds, and nothing that cannot be read, for it may hold
 * them.
 */
export const seriesForPupils = (series: Series): Series => ({
  ...series,
  tasks: series.tasks.flatMap((task): SeriesTask[] => {
    const { from } = task;
    if (from.kind === 'unread') return [];
    return [from.kind === 'project' ? { ...task, from: { ...from, project: given(from.project) } } : task];
  }),
});

/** Removes the task's secrets, and a pupil's hand-in, which belongs to that pupil alone. */
function given(project: Project): Project {
  const { handIn: _, ...others } = withoutSecrets(project);
  return others;
}

/** A file with its name. */
export interface NamedText {
  readonly name: string;
  readonly text: string;
}

/** The name of the series' own file in a folder. */
export const SERIES_FILE = 'series.json';

/**
 * A series as a folder for a web server: `series.json`, and a file for each task other than a ready course.
 *
 * @param nameOf title of a task, for the name of its file
 */
export function seriesToFolder(series: Series, nameOf: (task: SeriesTask) => string): readonly NamedText[] {
  const files: NamedText[] = [];
  const tasks = series.tasks.map((task, index): SeriesTask => {
    if (task.from.kind !== 'project') return task;
    const name = `${String(index + 1).padStart(2, '0')}-${taskFileName(nameOf(task))}.json`;
    files.push({ name, text: projectToText(task.from.project) });
    return { ...task, from: { kind: 'file', file: name } };
  });
  return [{ name: SERIES_FILE, text: seriesToText({ ...series, tasks }) }, ...files];
}

/** The name of a task or series as every web server has files and addresses. */
export const taskFileName = (name: string): string => plainFileName(name, 40) || 'task';
