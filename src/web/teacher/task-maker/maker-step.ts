import type { EqualWorlds } from '#check/equal-worlds';
import type { CheckResult, Reason } from '#check/result';
import { worldName, type ClassTask } from '#check/task/task';
import { isSame } from '#core/same';

/** The one thing that a task lacks most, or that it lacks nothing. */
export type MakerStep =
  /** The goals of the course are checked, and it has none. */
  | { readonly kind: 'goal' }
  /** There is no model solution. */
  | { readonly kind: 'write' }
  /** The model solution drives. */
  | { readonly kind: 'runs' }
  /** It does not pass; `place`: the first world where it does not; `null`: it lacks something in its text. */
  | { readonly kind: 'fails'; readonly place: number | null; readonly reason: Reason | null }
  /** The class would get it as its start program. */
  | { readonly kind: 'same' }
  /** A hidden world tests nothing new. */
  | { readonly kind: 'equal'; readonly place: number; readonly world: EqualWorlds }
  /** All worlds are visible: a program by heart passes. */
  | { readonly kind: 'visible' }
  | { readonly kind: 'ready' };

/** The state of a task that is being made. */
export interface MakerState {
  readonly task: ClassTask;
  readonly lacksGoals: boolean;
  /** Result of the model solution; `null`: it has not driven yet. */
  readonly result: CheckResult | null;
  /** The result is that of the task before its last change. */
  readonly isOld: boolean;
  readonly equals: readonly EqualWorlds[];
}

/** The next step in making a task, the most important first: whether it can be solved comes before what it hides. */
export function makerStep({ task, lacksGoals, result, isOld, equals }: MakerState): MakerStep {
  if (lacksGoals) return { kind: 'goal' };
  if (task.solution === null) return { kind: 'write' };
  if (result === null || isOld) return { kind: 'runs' };
  if (!result.passed) return failing(task, result);
  if (isSame(task.solution, task.project.files)) return { kind: 'same' };
  const [world] = equals;
  if (world !== undefined) {
    return { kind: 'equal', place: task.worlds.findIndex((one) => worldName(one) === world.id), world };
  }
  return { kind: task.worlds.some(({ hidden }) => hidden) ? 'ready' : 'visible' };
}

function failing(task: ClassTask, { worlds, checks }: CheckResult): MakerStep {
  const failed = worlds.find(({ passed }) => !passed);
  if (failed === undefined) {
    const reason = checks.find((check) => check.reason !== null)?.reason ?? null;
    return { kind: 'fails', place: null, reason };
  }
  return { kind: 'fails', place: task.worlds.findIndex(({ id }) => id === failed.id), reason: failed.reason };
}
