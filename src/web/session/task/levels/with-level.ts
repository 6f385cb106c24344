import { chosenLevel } from '#check/task/chosen-level';
import { levelsOf } from '#check/task/read-task';
import { isRecord } from '#core/record';
import { MAIN, type Project } from '#project/project';

/** True if another level begins with the same program as the chosen one: it has other hints. */
export function beginsAlike(project: Project, place: number): boolean {
  const levels = levelsOf(project.task);
  const now = levels[chosenLevel(project.task) ?? -1];
  return now !== undefined && now !== levels[place] && now.text === levels[place]?.text;
}

/**
 * A task that was handed out, with the start program of one of its levels; where that begins as the chosen one does, the
 * pupil's own program stays. `null`: it has no such level.
 */
export function withLevel(project: Project, place: number): Project | null {
  const { task } = project;
  const level = levelsOf(task)[place];
  if (task === undefined || level === undefined) return null;
  const { lines: _, ...locks } = isRecord(task['locks']) ? task['locks'] : {};
  const { handIn, ...plain } = project;
  const { version, series, begunMs } = handIn ?? {};
  const chosen = { ...task, level: place, locks: { ...locks, ...(level.lines.length > 0 && { lines: level.lines }) } };
  if (beginsAlike(project, place)) return { ...project, task: chosen };
  return {
    ...plain,
    files: project.files.map((file) => (file.name === MAIN ? { ...file, text: level.text } : file)),
    task: chosen,
    // What the page has noticed belongs to the program before; the place in a series and the begin of an exam stay.
    ...(handIn !== undefined && {
      handIn: { version, ...(series !== undefined && { series }), ...(begunMs !== undefined && { begunMs }) },
    }),
  };
}
