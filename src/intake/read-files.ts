import type { ProjectProblem } from '#project/problem';
import { looksLikeSeries, unreadableTask } from '#check/series/read-series';
import type { Series, SeriesTask, TaskSource } from '#check/series/series';
import type { FileProblem } from './document';
import { documentOfText, SERIES, taskIn } from './text';

/**
 * Reads a file beside a series; `null`: it did not come along.
 *
 * @param file its address, seen from the series
 */
export type LoadFile = (file: string) => Promise<{ readonly text: string } | { readonly problem: string } | null>;

/** A series with the tasks that lie in files beside it; one that cannot be read says so in its place. */
export async function readTasks(series: Series, load: LoadFile): Promise<Series> {
  const tasks = series.tasks.map(async (task): Promise<SeriesTask> => {
    const { from } = task;
    return from.kind === 'file' ? { ...task, from: await taskInFile(task, from.file, load) } : task;
  });
  return { ...series, tasks: await Promise.all(tasks) };
}

async function taskInFile({ id, title }: SeriesTask, file: string, load: LoadFile): Promise<TaskSource> {
  const value = { id, ...(title !== '' && { title }), file };
  const loaded = await load(file);
  if (loaded === null)
    return unreadableTask(value, [problemOf('not-beside', file, `${file}: is not beside the series.`)]);
  if ('problem' in loaded) {
    const said = `${file}: ${loaded.problem}`;
    return { ...unreadableTask(value, [problemOf('missing', file, said)]), said };
  }
  const task = looksLikeSeries(loaded.text) ? SERIES : taskIn(documentOfText(loaded.text, () => null));
  if ('project' in task) return { kind: 'project', project: task.project };
  return unreadableTask(
    value,
    task.problems.filter(isOfProject).map((problem) => inFile(problem, file)),
  );
}

const problemOf = (code: 'missing' | 'not-beside', path: string, message: string): ProjectProblem => ({
  ...{ code, path, message, value: '', params: {} },
});

const isOfProject = (problem: FileProblem): problem is ProjectProblem => problem.code !== 'not-a-series';

const inFile = (problem: ProjectProblem, file: string): ProjectProblem => ({
  ...problem,
  path: problem.path === '' ? file : `${file}: ${problem.path}`,
  message: `${file}: ${problem.message}`,
});
