import type { Project } from '#project/project';
import { parseTape } from '#tape/file';
import { projectOfRun } from './project-of-run';

/**
 * The project of a recorded run that somebody hands in. What the run came to does not count: it is run anyway.
 *
 * @returns or why there is none; `isEdited`: its program or its set-up was changed since the recording
 */
export function handedRun(
  text: string,
): { readonly project: Project; readonly isEdited: boolean } | { readonly detail: string; readonly isNewer: boolean } {
  const read = parseTape(text);
  if ('problem' in read) return { detail: read.problem, isNewer: read.fault === 'newer' };
  const { setup } = read.tape;
  const made = projectOfRun(setup, setup.devices[0].name);
  if ('project' in made) return { project: made.project, isEdited: read.changes.length > 0 };
  return { detail: made.problems.map(({ message }) => message).join(' '), isNewer: false };
}
