import { isSame } from '#core/same';
import type { Carried, Project } from '#project/project';
import { withoutFeedback } from '../feedback/feedback';
import { aboutData } from './about';
import { courseMark } from './course-mark';
import { draftOf, TASK_VERSION } from './read-task';
import { chosenLevel } from './chosen-level';
import { levelsData } from './levels';
import { noLocks, plainWorld, type Check, type CheckKind, type ClassTask, type Locks, type WorldVariant } from './task';
import { visibleTask } from './visible';

/** The project of a task, with everything: for the teacher. */
export const projectOfTask = (task: ClassTask): Project => ({ ...task.project, task: dataOf(task) });

/** A task without one of its parts that it need not have. */
export function withoutPart(task: ClassTask, part: 'about' | 'levels' | 'exam' | 'hint'): ClassTask {
  const { [part]: _, ...others } = task;
  return others;
}

/**
 * The same without the solution and without hidden worlds: what pupils get. On their page the locks hold, and it knows
 * whether the course is still the one handed out.
 */
export const projectForPupils = (task: ClassTask): Project => {
  const given = projectOfTask(visibleTask(task));
  return { ...given, task: { ...given.task, handedOut: true, course: courseMark(given.scene) } };
};

/**
 * A project as it may be handed on: without a teacher's feedback, and of its task neither the solution nor hidden worlds. What cannot be read as a task
 * stays behind, for it may hold them.
 */
export function withoutSecrets(given: Project): Project {
  const project = withoutFeedback(given);
  if (project.task === undefined) return project;
  const read = draftOf(project);
  const { task: _, ...others } = project;
  const task = 'task' in read ? projectForPupils(read.task).task : undefined;
  if (task === undefined) return others;
  const { handedOut, course } = project.task;
  if (handedOut !== true) return { ...(task['exam'] === undefined ? others : withoutHints(others)), task };
  // A pupil hands on what was handed out; an earlier version did not say which course that was.
  const { course: _course, ...known } = task;
  const level = chosenLevel(project.task);
  return {
    ...others,
    task: { ...known, ...(course !== undefined && { course }), ...(level !== null && { level }) },
  };
}

/** A project without the hints of its course, also without those that a ready course brings. */
function withoutHints(project: Project): Project {
  const { card } = project.scene.task;
  if (card === undefined) return { ...project, course: null };
  const translations = card.translations.map((one) => ({ ...one, hints: [] }));
  const task = { ...project.scene.task, card: { ...card, hints: [], solution: false, translations } };
  return { ...project, course: null, scene: { ...project.scene, task } };
}

/** A task's own data as a project carries it; what has its usual value is left out. */
function dataOf({
  id,
  checks,
  worlds,
  least,
  seconds,
  stars,
  solution,
  locks,
  about,
  levels,
  exam,
  hint,
}: ClassTask): Carried {
  const others = worlds.length === 1 && isSame(worlds[0], plainWorld) ? [] : worlds;
  const plain: unknown = {
    // An earlier app says that it is too old, where it would find words it does not know.
    version: checks.some(isNew) || [about, levels, exam, hint].some((one) => one !== undefined) ? TASK_VERSION : 1,
    ...(id !== '' && { id }),
    checks: checks.map(checkData),
    ...(others.length > 0 && { worlds: others.map(worldData) }),
    ...(least !== null && { least }),
    ...(seconds !== null && { seconds }),
    ...(stars !== null && { stars }),
    ...(solution !== null && { solution }),
    ...(!isSame(locks, noLocks) && { locks: lockData(locks) }),
    ...(about !== undefined && { about: aboutData(about) }),
    ...(levels !== undefined && { levels: levelsData(levels) }),
    ...(exam !== undefined && { exam }),
    ...(hint !== undefined && { hint }),
  };
  return JSON.parse(JSON.stringify(plain)) as Carried;
}

/** True for a check that version 1 does not know. */
function isNew(check: Check): boolean {
  if (check.type === 'stop') return check.whole || check.heading !== null;
  if (check.type === 'checkpoints') return check.each !== null;
  return ['reach', 'stay', 'belongs', 'covered', 'later', 'tiles', 'score'].includes(check.type);
}

/** Leaves out fields that are `null`. */
const said = (fields: object): object =>
  Object.fromEntries(Object.entries(fields).filter(([, value]) => value !== null));

/** The fields of a check that say something. */
function checkFields(check: CheckKind): object {
  if (check.type === 'reach') return check.zones.length === 0 ? { type: check.type } : check;
  if (check.type !== 'stop') return said(check);
  const { whole, heading, within, ...others } = check;
  return said({ ...others, ...(whole && { whole }), ...(heading !== null && { heading, within }) });
}

/** The locks that are set, without the others. */
const lockData = ({ tools, lines, speed, ...flags }: Locks): object => ({
  ...(tools !== null && { tools: tools.length === 0 ? true : tools }),
  ...Object.fromEntries(Object.entries(flags).filter(([, isLocked]) => isLocked)),
  ...(speed !== null && { speed: speed === 1 ? true : speed }),
  ...(lines.length > 0 && { lines }),
});

const checkData = ({ points, needed, ...check }: Check): object => ({
  ...checkFields(check),
  ...(points !== 1 && { points }),
  ...(!needed && { needed }),
});

function worldData({ edits, sensors, inputs, hidden, ...world }: WorldVariant): object {
  return {
    ...said(world),
    ...(!hidden && { hidden }),
    ...(edits.length > 0 && { edits }),
    ...(Object.keys(sensors).length > 0 && { sensors }),
    ...(inputs.length > 0 && { inputs }),
  };
}
