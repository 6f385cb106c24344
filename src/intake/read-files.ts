import { openJson } from '#project/open-json';
import type { ProjectProblem } from '#project/problem';
import { MAIN } from '#project/project';
import { looksLikeSeries, unread } from '#check/series/read-series';
import type { Series, SeriesTask, TaskSource } from '#check/series/series';

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
  const value = { id, ...(title !== '' && { title }), file };
  const loaded = await load(file);
  if ('problem' in loaded) {
    const said = `${file}: ${loaded.problem}`;
    return { ...unread(value, [{ code: 'missing', path: file, value: '', params: {}, message: said }]), said };
  }
  const from = taskOfText(loaded.text);
  if ('kind' in from) return from;
  return unread(
    value,
    from.problems.map((problem) => inFile(problem, file)),
  );
}

const inFile = (problem: ProjectProblem, file: string): ProjectProblem => ({
  ...problem,
  path: problem.path === '' ? file : `${file}: ${problem.path}`,
  message: `${file}: ${problem.message}`,
});

/** The task in the text of a file: a project, or a course with an empty program. */
export function taskOfText(
  text: string,
): Extract<TaskSource, { readonly kind: 'project' }> | { readonly problems: readonly ProjectProblem[] } {
  if (looksLikeSeries(text)) {
    const message = 'is a series itself; a series holds tasks only. Add its tasks one by one.';
    return { problems: [{ code: 'wrong-type', path: '', value: '"parcours-series"', params: {}, message }] };
  }
  const opened = openJson(text);
  if (opened.kind === 'problem') return { problems: opened.problems };
  if (opened.kind === 'project') return { kind: 'project', project: opened.project };
  return { kind: 'project', project: { files: [{ name: MAIN, text: '' }], scene: opened.scene, course: null } };
}
