import { shownName, type ClassResult, type NamedResult } from '#check/report/class-result';
import { isUnread } from '#check/report/texts';
import { courseMark } from '#check/task/course-mark';
import { mostPoints, type ClassTask } from '#check/task/task';
import type { Day } from '#core/day';
import { findPupil, freePupilId } from './names';
import { classLimits, type Pupil, type Result, type SchoolClass, type SetTask } from './school-class';

/** Results of a task that are to be added. */
export interface CheckedTask {
  readonly task: ClassTask;
  readonly found: ClassResult;
  /** Day of today. */
  readonly day: Day;
}

/** A class with what was added. */
export interface Added {
  readonly schoolClass: SchoolClass;
  /** Number of results that were not in it before. */
  readonly count: number;
  /** Names of hand-ins that nobody on the list has; they are pupils of their own now. */
  readonly strangers: readonly string[];
}

/** The key of a task in a class: its id, else the mark of its course. */
export const taskKey = ({ id, project }: ClassTask): string => id || `course-${courseMark(project.scene)}`;

/** Adds the results of a task. What is in the class already is not added twice; nothing that is in it goes. */
export function addResults(given: SchoolClass, { task, found, day }: CheckedTask): Added {
  const id = taskKey(task);
  const isList = given.pupils.some(({ isListed }) => isListed);
  const pupils: Pupil[] = [...given.pupils];
  const results: Result[] = [];
  const strangers: string[] = [];
  for (const one of found.handIns) {
    const shown = shownName(one);
    let pupil = findPupil(pupils, shown);
    if (pupil === null) {
      const name = shown.slice(0, classLimits.nameCharacters);
      pupil = { id: freePupilId(pupils, name), name, also: [], isListed: !isList };
      pupils.push(pupil);
      strangers.push(name);
    }
    results.push(resultOf(one, { pupil: pupil.id, task: id, day }));
  }
  const tasks = withTask(given.tasks, { ...setTask(task, found.task, day), id });
  const all = withoutDoubles([...markedAnew(given.results, results), ...results]);
  return {
    schoolClass: { ...given, pupils, tasks, results: all },
    count: all.length - given.results.length,
    strangers: isList ? strangers : [],
  };
}

const setTask = (task: ClassTask, title: string, since: Day): Omit<SetTask, 'id'> => ({
  title: title.slice(0, classLimits.titleCharacters),
  points: mostPoints(task),
  hasStars: task.stars !== null,
  ...{ since, due: null },
});

/** A task that is there already keeps its day; its title and points are the newest. */
function withTask(tasks: readonly SetTask[], task: SetTask): readonly SetTask[] {
  if (!tasks.some(({ id }) => id === task.id)) return [...tasks, task];
  return tasks.map((one) =>
    one.id === task.id ? { ...task, since: one.since < task.since ? one.since : task.since, due: one.due } : one,
  );
}

function resultOf(
  { result, note = '', marked }: NamedResult,
  { pupil, task, day }: Pick<Result, 'pupil' | 'task' | 'day'>,
): Result {
  const outcome = isUnread(result) ? 'unread' : result.passed ? 'passed' : 'failed';
  const { points, stars, twin } = result;
  return {
    ...{ pupil, task, day, outcome, points, stars, work: twin, note: note.slice(0, classLimits.noteCharacters) },
    ...(marked !== undefined && outcome !== 'unread' && { marked }),
  };
}

/** Results, of which those that are added once more have the newest points set by hand. */
function markedAnew(given: readonly Result[], added: readonly Result[]): readonly Result[] {
  const marks = new Map(added.flatMap((one) => (one.marked === undefined ? [] : [[identityOf(one), one.marked]])));
  return given.map((one) => {
    const marked = marks.get(identityOf(one));
    return marked === undefined ? one : { ...one, marked };
  });
}

/** A text that two results share if they are the same one. */
const identityOf = (result: Omit<Result, 'day' | 'note' | 'marked'>): string =>
  [result.pupil, result.task, result.outcome, result.points, result.stars ?? '', result.work].join('\n');

/** Each result once, by its first day, with all notes on it, in the order of their days. */
export function withoutDoubles(results: readonly Result[]): readonly Result[] {
  const once = new Map<string, Result>();
  for (const result of results) {
    const key = identityOf(result);
    const known = once.get(key);
    once.set(key, known === undefined ? result : joined(known, result));
  }
  return [...once.values()].toSorted((a, b) => (a.day < b.day ? -1 : a.day > b.day ? 1 : 0));
}

function joined(one: Result, other: Result): Result {
  const notes = [...new Set([...one.note.split('\n'), ...other.note.split('\n')])].filter((line) => line !== '');
  const note = notes.join('\n').slice(0, classLimits.noteCharacters);
  const marked = one.marked ?? other.marked;
  return { ...one, day: one.day < other.day ? one.day : other.day, note, ...(marked !== undefined && { marked }) };
}
