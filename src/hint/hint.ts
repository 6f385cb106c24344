import { check } from '#check/check';
import type { HandIn } from '#check/hand-in/hand-in';
import type { CheckResult, Reason, WorldResult } from '#check/result';
import { runWorld } from '#check/run/run-world';
import { mainReason, visibleTask } from '#check/task/visible';
import type { ClassTask, WorldVariant } from '#check/task/task';
import { linesOf, type Change } from './changes/change';
import { happenedIn, type Happened } from './happened/happened';
import { findChange, mainOf } from './search';
import { Observed } from './watch/observed';

/** How much a hint tells: the moment, the lines, the kind of change, the change itself. */
export const hintLevels = [1, 2, 3, 4] as const;
export type HintLevel = (typeof hintLevels)[number];

/** The most programs that are tried for a hint. Chosen: a school's computer tries them in about 20 s. */
export const USUAL_BUDGET = 400;
export const budgetLimits = { min: 0, max: 100_000 } as const;

/** Means for a hint. */
export interface Hinter {
  readonly firmware: WebAssembly.Module;
  /** The most programs that are tried. */
  readonly budget: number;
  /** Called often. */
  readonly beat?: () => void;
}

/** A hint to a program, as plain data. */
export interface Hint {
  readonly reason: Reason;
  /** Simulated ms until it was decided; `null`: it was not. */
  readonly atMs: number | null;
  readonly happened: Happened;
  /** A change with which the program passes, proved by running it; `null`: none was found. */
  readonly change: Change | null;
  /** Number of programs that were tried. */
  readonly tried: number;
  /** The program, for the lines beside the change. */
  readonly program: string;
}

/**
 * The hint to a program: what happened in its run, and a small change with which it passes in all worlds that pupils see.
 * Neither hidden worlds nor the model solution are looked at. The same program gives the same hint on every machine.
 *
 * @returns `null`: it passes
 */
export async function hintFor(given: ClassTask, handIn: HandIn, hinter: Hinter): Promise<Hint | null> {
  const { firmware, budget, beat = () => undefined } = hinter;
  const task = visibleTask(given);
  const result = await check(task, handIn, { firmware, beat });
  if (result.passed) return null;
  const failed = failedIn(task, result);
  const seen = new Observed();
  await runWorld(task, handIn.project, failed.world, { firmware, beat, onlooker: seen });
  const reason = mainReason(task, result) ?? { code: 'open', params: {} };
  const happened = happenedIn({ reason, result: failed.result, seen, course: task.project.scene });
  const suspects = suspectsIn(mainOf(handIn), seen, happened);
  const isBroken = happened.fact === 'error' && ['SyntaxError', 'IndentationError'].includes(happened.type);
  const search = { task, handIn, firmware, budget, beat, failedIn: failed.world, suspects, isBroken };
  const { change, tried } = await findChange(search);
  return { reason, atMs: failed.result?.atMs ?? null, happened, change, tried, program: mainOf(handIn) };
}

/** The first world in which the program does not pass; the first of all if only its text is wrong. */
function failedIn(
  { worlds }: ClassTask,
  result: CheckResult,
): { readonly world: WorldVariant; readonly result: WorldResult | null } {
  const place = Math.max(0, result.worlds.findIndex(({ passed }) => !passed)); // prettier-ignore
  return { world: worlds[place] ?? worlds[0], result: result.worlds[place] ?? null };
}

/** The lines of a program, those first that ran last before it failed, and an error's before all. */
function suspectsIn(text: string, { lastRanUs }: Observed, happened: Happened): readonly number[] {
  const numbers = linesOf(text).map((_, place) => place + 1);
  const at = (line: number): number => lastRanUs.get(line) ?? -1;
  const byTime = numbers.sort((one, other) => at(other) - at(one) || one - other);
  const first = happened.fact === 'error' && happened.line > 0 ? [happened.line] : [];
  return [...new Set([...first, ...byTime])];
}
