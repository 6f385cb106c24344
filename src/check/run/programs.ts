import { deviceNames, runFilesOf } from '#project/devices';
import type { Project } from '#project/project';
import type { Files } from '../program/facts';

/**
 * The programs on each device of a task that is handed in: the pupil's program, and the task's where the pupil has not got
 * that device.
 */
export function programsOf(task: Project, handedIn: Project): readonly [Files, ...Files[]] {
  const theirs = deviceNames(handedIn);
  const names = deviceNames(task);
  const others = (task.devices?.others ?? []).map(({ name }, index) => {
    const place = placeOf(name, index + 1, names, theirs);
    return place > 0 ? runFilesOf(handedIn, place) : runFilesOf(task, index + 1);
  });
  return [runFilesOf(handedIn, 0), ...others];
}

/**
 * The pupil's device for one of the task: the one of its name, else the one at its place, unless that is another one's. A ready
 * course calls its devices in the language of the page.
 */
function placeOf(name: string, place: number, names: readonly string[], theirs: readonly string[]): number {
  const named = theirs.indexOf(name);
  if (named >= 0) return named;
  const isOthers = names.includes(theirs[place] ?? name);
  return theirs.length === names.length && !isOthers ? place : -1;
}
