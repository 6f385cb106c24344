import { levelsOf } from '#check/task/read-task';
import { isRecord } from '#core/record';
import { MAIN, type Project } from '#project/project';

/** A task that was handed out, with the start program of one of its levels; `null`: it has no such level. */
export function withLevel(project: Project, place: number): Project | null {
  const { task } = project;
  const level = levelsOf(task)[place];
  if (task === undefined || level === undefined) return null;
  const { lines: _, ...locks } = isRecord(task['locks']) ? task['locks'] : {};
  const { handIn, ...plain } = project;
  const { version, series, begunMs } = handIn ?? {};
  return {
    ...plain,
    files: project.files.map((file) => (file.name === MAIN ? { ...file, text: level.text } : file)),
    task: { ...task, level: place, locks: { ...locks, ...(level.lines.length > 0 && { lines: level.lines }) } },
    // What the page has noticed belongs to the program before; the place in a series and the begin of an exam stay.
    ...(handIn !== undefined && {
      handIn: { version, ...(series !== undefined && { series }), ...(begunMs !== undefined && { begunMs }) },
    }),
  };
}
