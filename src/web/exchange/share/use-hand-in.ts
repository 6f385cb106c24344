import { computed, onScopeDispose, shallowRef, watch, type ComputedRef, type ShallowRef } from 'vue';

import { handInLimits, type Said, type SaidRemark } from '#check/hand-in/hand-in';
import { isUnreached, type CheckResult, type WorldResult } from '#check/result';
import { taskOf } from '#check/task/read-task';
import type { ClassTask } from '#check/task/task';
import { mainReason, visibleTask } from '#check/task/visible';
import { isSame } from '#core/same';
import type { Project } from '#project/project';

import { CheckRun } from '../../session/run/check-run';

/** Runs a project's program on its own course, as the teacher's check will; `null`: it cannot be run now. */
export type Prover = (task: ClassTask, project: Project) => Promise<WorldResult | null>;

/** The state of a hand-in. */
export interface HandInWish {
  /** The name that the pupil types; it goes along with the link and nowhere else. */
  readonly alias: Readonly<ShallowRef<string>>;
  rename(alias: string): void;
  /** The run in the visible world; `null`: it is being made, or could not be. */
  readonly run: Readonly<ShallowRef<WorldResult | null>>;
  readonly isRunning: Readonly<ShallowRef<boolean>>;
  /** The statements in the hand-in; `null`: the project has no task. */
  readonly said: ComputedRef<Said | null>;
}

/** Longest name, in characters. */
export const MOST_ALIAS = handInLimits.aliasCharacters;

/**
 * A hand-in of the present project.
 *
 * @param tries number of runs so far
 * @param noticed the page's remarks on the work
 */
export function useHandIn(
  project: () => Project,
  tries: () => number,
  noticed: () => readonly SaidRemark[] = () => [],
  prove: Prover = proved,
): HandInWish {
  const task = computed(() => {
    const read = taskOf(project());
    return 'task' in read ? read.task : null;
  });
  const isRunning = shallowRef(false);
  const alias = shallowRef('');
  const run = shallowRef<WorldResult | null>(null);
  let turn = 0;
  watch(
    project,
    async (now, before) => {
      if (task.value === null || isSame(now, before)) return;
      const mine = ++turn;
      [run.value, isRunning.value] = [null, true];
      const found = await prove(task.value, now).catch(() => null);
      if (mine !== turn) return;
      [run.value, isRunning.value] = [found, false];
    },
    { immediate: true },
  );
  onScopeDispose(() => (turn += 1));
  const said = computed((): Said | null =>
    task.value !== null
      ? {
          task: task.value.id,
          alias: alias.value.trim().slice(0, MOST_ALIAS),
          verdict: verdictOf(run.value),
          tries: tries(),
          hash: run.value?.hash ?? '',
          remarks: noticed(),
        }
      : null,
  );
  return {
    ...{ alias, run, isRunning, said },
    rename: (text) => (alias.value = text),
  };
}

/** True if a project can be handed in: it has a task. */
export const canBeHandedIn = (project: Project): boolean => 'task' in taskOf(project);

/** The verdict of the pupil's page on its run: goals not reached yet may still be. */
export function verdictOf(run: WorldResult | null): Said['verdict'] {
  if (run === null || (run.reason !== null && isUnreached(run.reason))) return 'open';
  return run.passed ? 'passed' : 'failed';
}

/** The run of the visible world, judged with the checks of the program itself, as the teacher's check will be. */
export function seenRun(task: ClassTask, result: CheckResult): WorldResult | null {
  const [world] = result.worlds;
  return world === undefined ? null : { ...world, passed: result.passed, reason: mainReason(task, result) };
}

/** Runs the check of the visible world in a worker of its own. */
async function proved(task: ClassTask, project: Project): Promise<WorldResult | null> {
  const seen = visibleTask(task);
  const run = new CheckRun();
  await run.run(seen, project);
  return run.result.value && seenRun(seen, run.result.value);
}
