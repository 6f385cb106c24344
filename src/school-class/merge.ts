import { withoutDoubles } from './add-results';
import { freePupilId, wordsOfPupil } from './names';
import type { Pupil, SchoolClass, SetTask } from './school-class';

/**
 * Two copies of a class as one, such as those of two computers: what only one of them has is in it, and nothing twice. Where
 * both say something else, as of a name, the first copy holds.
 */
export function mergeClasses(one: SchoolClass, other: SchoolClass): SchoolClass {
  const pupils: Pupil[] = [...one.pupils];
  /** Ids of the other copy → ids of the pupils that they are. */
  const ids = new Map<string, string>();
  const taken = new Set<string>();
  for (const theirs of other.pupils) {
    const at = pupils.findIndex((pupil) => !taken.has(pupil.id) && isSame(pupil, theirs));
    const own = pupils[at];
    if (own === undefined) {
      const id = pupils.some((pupil) => pupil.id === theirs.id) ? freePupilId(pupils, theirs.name) : theirs.id;
      pupils.push({ ...theirs, id });
      ids.set(theirs.id, id);
      taken.add(id);
      continue;
    }
    const also = [...new Set([...own.also, ...theirs.also, theirs.name])].filter((name) => name !== own.name);
    pupils[at] = { ...own, also, isListed: own.isListed || theirs.isListed };
    ids.set(theirs.id, own.id);
    taken.add(own.id);
  }
  const results = other.results.map((result) => ({ ...result, pupil: ids.get(result.pupil) ?? result.pupil }));
  return {
    name: one.name,
    pupils,
    tasks: mergedTasks(one.tasks, other.tasks),
    results: withoutDoubles([...one.results, ...results]),
    scale: one.scale ?? other.scale,
  };
}

/** Two pupils are one if both copies call them alike, whatever else they are called there. */
function isSame(one: Pupil, other: Pupil): boolean {
  const [own, theirs] = [one, other].map((pupil) => wordsOfPupil(pupil).map((words) => words.join(' ') || pupil.name));
  return (own ?? []).some((name) => theirs?.includes(name));
}

function mergedTasks(own: readonly SetTask[], theirs: readonly SetTask[]): readonly SetTask[] {
  const merged = own.map((task) => {
    const same = theirs.find(({ id }) => id === task.id);
    if (same === undefined) return task;
    return { ...task, since: same.since < task.since ? same.since : task.since, due: task.due ?? same.due };
  });
  return [...merged, ...theirs.filter(({ id }) => !own.some((task) => task.id === id))];
}
