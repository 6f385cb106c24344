import { withFiles } from '#project/devices';
import { defaultProjectSettings, MAIN, projectLimits, type Project, type SourceFile } from '#project/project';
import type { RunSetup } from '#simulation/run-setup';
import { usOf } from '#core/seconds';
import type { HandIn } from '../hand-in/hand-in';
import type { CheckResult, WorldResult } from '../result';
import { programsOf } from '../run/programs';
import { setupOf } from '../run/setup';
import { isSameCourse } from '../task/course-mark';
import { keptLines } from '../task/kept-lines';
import { taskOf } from '../task/read-task';
import { mostPoints, plainWorld, secondsOf, type ClassTask, type WorldVariant } from '../task/task';
import { courseOfWorld } from '../task/world-course';
import { projectForPupils } from '../task/write-task';
import { readFeedback, withFeedback } from './feedback';

/** Most simulated time that is run for a feedback without a moment. Chosen: a weak tablet takes some seconds for it. */
const MOST_MS = 60_000;

/** Simulated time that is shown after the moment of a feedback. Chosen: enough to see what came of it. */
const AFTER_US = 2_000_000;

/** Reasons that belong to the end of the program, whose time is not in the result. */
const BY_THE_END: readonly string[] = ['exception', 'panic', 'empty'];

/**
 * The moment to look at in a world: when it was decided, else when the robot moved last, in simulated ms. `null`: the end of
 * the program.
 */
export function momentOf({ atMs, reason, trailMs }: WorldResult): number | null {
  if (atMs !== null) return Math.round(atMs);
  if (reason !== null && BY_THE_END.includes(reason.code)) return null;
  const last = trailMs.at(-1)?.at(-1);
  return last === undefined ? null : Math.min(Math.round(last), MOST_MS);
}

/** A hand-in with its result, of which a pupil is told. */
export interface Marked {
  readonly task: ClassTask;
  readonly handIn: HandIn;
  readonly result: CheckResult;
  /** The points that count: those that were found, or set by hand. */
  readonly points: number;
  readonly note: string;
}

/**
 * The project that a pupil gets back: the own programs in the task as it was handed out, in the course of a world, with the
 * teacher's feedback. A hidden world is no secret any more then.
 *
 * @returns `null`: the task has no such world, or it cannot be made
 */
export function feedbackProject({ task, handIn, result, points, note }: Marked, world: WorldResult): Project | null {
  const variant = task.worlds.find(({ id }) => id === world.id);
  const course = variant && courseOfWorld(task.project.scene, variant);
  if (variant === undefined || course === undefined || !('scene' in course)) return null;
  const isAsSet = isSameCourse(course.scene, task.project.scene) && !variant.hidden;
  const given = projectForPupils(isAsSet ? task : inWorld(task, variant, course.scene));
  const most = mostPoints(task);
  const outside = handIn.said?.remarks.filter((remark) => remark === 'outside') ?? [];
  return withPrograms(task, handIn, {
    ...given,
    handIn: withFeedback(outside.length > 0 ? { remarks: outside } : {}, {
      note,
      world: world.id,
      atMs: momentOf(world),
      failed: !world.passed,
      missed: result.checks.filter(({ passed }) => !passed).map(({ id }) => id),
      points: most > 0 ? [points, most] : null,
    }),
  });
}

/** The task with one world alone, whose course is that of the project. */
function inWorld(task: ClassTask, variant: WorldVariant, scene: Project['scene']): ClassTask {
  const settings = task.project.settings ?? defaultProjectSettings;
  const { min, max } = projectLimits.seed;
  const seed = variant.seed !== null && variant.seed >= min && variant.seed <= max ? variant.seed : settings.seed;
  const reality = variant.reality ?? settings.reality;
  const { start, edits, hidden } = plainWorld;
  return {
    ...task,
    // The course is a drawing of its own now.
    project: { ...task.project, scene, course: null, settings: { ...settings, seed, reality } },
    worlds: [{ ...variant, start, edits, hidden }],
    least: null,
  };
}

/** The project with the pupil's programs, and the locks on the lines where these stand in them. */
function withPrograms({ project: set, locks }: ClassTask, { project }: HandIn, given: Project): Project {
  const [main, ...others] = programsOf(set, project);
  const devices = given.devices && {
    ...given.devices,
    others: given.devices.others.map((device, place) => ({ ...device, sameAs: '', files: filesOf(others[place]) })),
  };
  const own = { ...withFiles(given, 0, filesOf(main)), ...(devices && { devices }) };
  if (locks.lines.length === 0 || given.task === undefined) return own;
  const [before = ''] = set.files.filter(({ name }) => name === MAIN).map(({ text }) => text);
  const lines = keptLines(before, main[MAIN] ?? '', locks.lines) ?? [];
  return { ...own, task: { ...given.task, locks: { ...(given.task['locks'] as object), lines } } };
}

/** The program first, as tabs have it. */
const filesOf = (files: Readonly<Record<string, string>> = {}): readonly SourceFile[] =>
  Object.entries({ [MAIN]: '', ...files }).map(([name, text]) => ({ name, text }));

/** The run that a feedback is about. */
export interface FeedbackRun {
  readonly setup: RunSetup;
  readonly untilUs: number;
  readonly untilProgramEnds: boolean;
  /** The moment that is looked at; `null`: the end. */
  readonly atUs: number | null;
}

/** The run of the feedback in a project, as the check has made it; `null`: there is none, or it cannot be made. */
export function runOfFeedback(project: Project): FeedbackRun | null {
  const feedback = readFeedback(project);
  if (feedback === null || typeof feedback === 'string') return null;
  const read = taskOf(project);
  if (!('task' in read)) return null;
  const { task } = read;
  const setup = setupOf(task, project, task.worlds.find(({ id }) => id === feedback.world) ?? task.worlds[0]);
  if ('problem' in setup) return null;
  const mostUs = usOf(secondsOf(task));
  const { atMs } = feedback;
  if (atMs === null) {
    const untilUs = Math.min(mostUs, MOST_MS * 1000);
    return { setup, untilUs, untilProgramEnds: true, atUs: null };
  }
  return { setup, untilUs: atMs * 1000 + AFTER_US, untilProgramEnds: false, atUs: atMs * 1000 };
}
