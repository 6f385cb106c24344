import { runFilesOf } from '#project/devices';
import { MAIN } from '#project/project';
import { isSame } from '#core/same';
import { findFact, isEmpty, type Files } from './program/facts';
import { twinHash, twinOfAll } from './program/twin';
import type { HandIn } from './hand-in/hand-in';
import { otherTask } from './hand-in/other-task';
import type { CheckOutcome, CheckResult, Reason, Remark, WorldResult } from './result';
import { programsOf } from './run/programs';
import { notRun, runWorld, type Onlooker } from './run/run-world';
import { isSameCourse } from './task/course-mark';
import { keptLines } from './task/kept-lines';
import type { TaskLevel } from './task/levels';
import { isUnlocked } from './task/unlocked';
import { coursesOf } from './task/world-course';
import { isFact, type Check, type ClassTask, type Fact } from './task/task';

/** Settings for running hand-ins. */
export interface Checker {
  /** The compiled VM. */
  readonly firmware: WebAssembly.Module;
  /**
   * Called often while a world runs, and at its beginning, with its place in the task: a sign of progress for watchers.
   */
  readonly beat?: (world: number) => void;
  /** Looks at the run in the world of this place. Left out: nobody looks. */
  readonly onlooker?: (world: number) => Onlooker;
  /** The `main.py` that was handed out, as pupils may have found it in other languages. */
  readonly starts?: readonly string[];
  /**
   * From this world on nothing is run, because the program was stuck there in one endless call, or has broken the VM; left
   * out: all are run.
   */
  readonly lost?: { readonly from: number; readonly reason: Reason };
}

/**
 * Checks a hand-in: runs its program in every world of the task, and examines its text. The same task and hand-in
 * give the same result on every machine. Everything except the programs is the task's; the pupil's other differences
 * are reported.
 */
export async function check(task: ClassTask, handIn: HandIn, checker: Checker): Promise<CheckResult> {
  const { firmware, beat, onlooker, lost, starts = [] } = checker;
  const worlds: WorldResult[] = [];
  for (const [place, world] of task.worlds.entries()) {
    beat?.(place);
    worlds.push(
      lost !== undefined && place >= lost.from
        ? notRun(task, world, lost.reason)
        : await runWorld(task, handIn.project, world, {
            ...{ firmware, beat: () => beat?.(place) },
            ...(onlooker && { onlooker: onlooker(place) }),
          }),
    );
  }
  return resultOf(task, handIn, worlds, starts);
}

function resultOf(
  task: ClassTask,
  handIn: HandIn,
  worlds: readonly WorldResult[],
  starts: readonly string[],
): CheckResult {
  const checks = task.checks.map((one) => outcomeOf(task, one, handIn, worlds));
  const passed =
    task.checks.every(({ needed }, place) => !needed || checks[place]?.passed === true) &&
    isEnough(task, worlds, ({ passed: holds }) => holds);
  const points = task.checks.reduce(
    (sum, one, place) => sum + (checks[place]?.passed === true ? one.points : 0) + countPoints(task, one, worlds),
    0,
  );
  const programs = programsOf(task.project, handIn.project);
  const unchanged = isUnchanged(task, programs, [...starts, ...(task.levels ?? []).map(({ text }) => text)]);
  return {
    passed,
    points,
    stars: starsOf(task, passed, points),
    checks,
    worlds,
    remarks: remarksOn(task, handIn, worlds, unchanged),
    // Nobody has an empty program from somebody else.
    twin: unchanged || programs.every(isEmpty) ? '' : twinOfAll(programs),
  };
}

/** True if it holds in all visible worlds and in enough of the hidden ones. */
function isEnough(
  { least }: ClassTask,
  worlds: readonly WorldResult[],
  holds: (world: WorldResult) => boolean,
): boolean {
  const hidden = worlds.filter((world) => world.hidden);
  return (
    worlds.every((world) => world.hidden || holds(world)) && hidden.filter(holds).length >= (least ?? hidden.length)
  );
}

function outcomeOf(task: ClassTask, check: Check, handIn: HandIn, worlds: readonly WorldResult[]): CheckOutcome {
  const { id } = check;
  if (isFact(check)) return { id, ...factOutcome(check, handIn) };
  const passed = isEnough(task, worlds, ({ held }) => held.includes(id));
  const missed = worlds.map((world) => world.missed[id]).find((reason) => reason !== undefined) ?? null;
  return { id, passed, reason: passed ? null : missed };
}

/** Points for each of what a check counts, as many as in all visible worlds and in enough of the hidden ones. */
function countPoints(task: ClassTask, check: Check, worlds: readonly WorldResult[]): number {
  if (check.type !== 'checkpoints' || check.each === null || worlds.length === 0) return 0;
  const countIn = ({ counts }: WorldResult): number => counts?.[check.id] ?? 0;
  const most = Math.max(...worlds.map(countIn));
  for (let count = most; count > 0; count -= 1)
    if (isEnough(task, worlds, (world) => countIn(world) >= count)) return count * check.each;
  return 0;
}

function factOutcome(fact: Check & Fact, { project }: HandIn): Pick<CheckOutcome, 'passed' | 'reason'> {
  const { holds, found, line } = findFact(fact, runFilesOf(project, 0));
  if (holds) return { passed: true, reason: null };
  const params: Reason['params'] = {
    ...('most' in fact && { most: fact.most }),
    ...('name' in fact && { name: fact.name }),
    ...(found !== null && { found }),
    ...(line !== null && { line }),
  };
  return { passed: false, reason: { code: fact.type, params } };
}

function starsOf({ stars }: ClassTask, passed: boolean, points: number): number | null {
  if (stars === null) return null;
  return passed ? 1 + stars.filter((wanted) => points >= wanted).length : 0;
}

/** True if the programs are still those that were handed out; those of further devices in any language. */
function isUnchanged({ project }: ClassTask, [main, ...others]: readonly Files[], starts: readonly string[]): boolean {
  const [own, ...ownOthers] = programsOf(project, project);
  return (
    [own, ...starts.map((text) => ({ [MAIN]: text }))].some((files) => isSame(files, main)) &&
    others.every((files, place) => twinHash(files) === twinHash(ownOthers[place] ?? {}))
  );
}

function remarksOn(
  task: ClassTask,
  handIn: HandIn,
  worlds: readonly WorldResult[],
  unchanged: boolean,
): readonly Remark[] {
  const { project, hasCourse, said, locks, isEdited, coding } = handIn;
  const remarks: Remark[] = [];
  const tell = (code: Remark['code'], params: Remark['params'] = {}): void => {
    remarks.push({ code, params });
  };
  const [visible] = worlds;
  const other = otherTask(task, handIn);
  // Differences from this task are correct in the other one: they raise no suspicion.
  if (other !== null) return [{ code: 'other-task', params: { task: other } }];
  const isOfTask = !hasCourse || coursesOf(task).some((course) => isSameCourse(course, project.scene));
  if (!isOfTask || said?.remarks.includes('course') === true) tell('course');
  if (said?.remarks.includes('hand') === true) tell('hand');
  if (said?.remarks.includes('outside') === true || lacksLines(task, handIn)) tell('outside');
  if (said !== null && locks !== undefined && isUnlocked(task.locks, locks)) tell('unlocked');
  if (said?.verdict === 'passed' && visible?.passed === false) tell('verdict');
  else if (said !== null && visible !== undefined && said.hash !== visible.hash) {
    if (said.hash !== '') tell('hash');
    // Only a run that is not over has no fingerprint.
    else if (said.verdict !== 'open') tell('no-hash');
  }
  if (isEdited) tell('edited');
  if (coding !== undefined) tell('coding', { coding });
  if (unchanged) tell('unchanged');
  return remarks;
}

/** True if a line that is locked in the editor was changed: then the program was written elsewhere. */
function lacksLines(task: ClassTask, { project, level }: HandIn): boolean {
  const main = runFilesOf(project, 0)[MAIN] ?? '';
  return startsOf(task, level).every(({ text, lines }) => lines.length > 0 && keptLines(text, main, lines) === null);
}

/** The start programs that a hand-in may come from: of a task with levels the chosen one, else any of them. */
function startsOf(
  { project, locks, levels = [] }: ClassTask,
  level: number | undefined,
): readonly Pick<TaskLevel, 'text' | 'lines'>[] {
  const chosen = level === undefined ? undefined : levels[level];
  if (chosen !== undefined) return [chosen];
  return [{ text: runFilesOf(project, 0)[MAIN] ?? '', lines: locks.lines }, ...levels];
}
