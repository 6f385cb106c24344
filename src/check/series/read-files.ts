import { openJson } from '#project/open-json';
import type { ProjectProblem } from '#project/problem';
import { MAIN } from '#project/project';
import { looksLikeSeries, unread } from './read-series';
import type { Series, SeriesTask, TaskSource } from './series';

/** What brings a file beside a series. @param file its address, seen from the series */
export type LoadFile = (file: string) => Promise<{ readonly text: string } | { readonly problem: string }>;

/** A series with the tasks that lie in files beside it; one that cannot be read says so in its place. */
export async function readTasks(series: Series, load: LoadFile): Promise<Series> {
  const tasks = series.tasks.map(async (task): Promise<SeriesTask> => {
    const { from } = task;
    return from.kind === 'file' ? { ...task, from: await taskInFile(task, from.file, load) } : task;
  });
  return { ...series, tasks: await Promise.all(tasks) };
}

async function taskInFile({ id, title }: SeriesTask, file: string, load: LoadFile): Promise<TaskSource> {
  const loaded = await load(file);
  const from = 'text' in loaded ? taskOfText(loaded.text) : loaded;
  if ('kind' in from) return from;
  const message = `${file}: ${from.problem}`;
  const problem: ProjectProblem = { code: 'damaged', path: file, value: '', params: {}, message };
  return unread({ id, ...(title !== '' && { title }), file }, [problem]);
}

/** The task in the text of a file: a project, or a course with an empty program. */
export function taskOfText(
  text: string,
): Extract<TaskSource, { readonly kind: 'project' }> | { readonly problem: string } {
  if (looksLikeSeries(text))
    return { problem: 'is a series itself; a series holds tasks only. Add its tasks one by one.' };
  const opened = openJson(text);
  if (opened.kind === 'problem') return { problem: opened.problem };
  if (opened.kind === 'project') return { kind: 'project', project: opened.project };
  return { kind: 'project', project: { files: [{ name: MAIN, text: '' }], scene: opened.scene, course: null } };
}
