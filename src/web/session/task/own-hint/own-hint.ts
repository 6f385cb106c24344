import { computed, shallowRef, watch, type ComputedRef, type ShallowRef } from 'vue';

import { handInOf } from '#check/hand-in/read-hand-in';
import type { Every, Start } from '#check/lane';
import { taskOf } from '#check/task/read-task';
import type { ClassTask } from '#check/task/task';
import { visibleTask } from '#check/task/visible';
import { projectOfTask } from '#check/task/write-task';
import { linesToSee } from '#hint/changes/change';
import { hintLevels, USUAL_BUDGET, type Hint } from '#hint/hint';
import { HintLane, type HintRequest } from '#hint/hint-lane';
import { hintTexts } from '#hint/say';

import { shownLanguage } from '../../../kit/i18n';
import { lateModel, type WithLate } from '../../../kit/state/late-models';
import { every, serveThread } from '../../run/serve-thread';
import { compileFirmware } from '../../run/worker/firmware';
import type { WorkParts } from '../../work/model/parts';
import type { OwnHintState } from './own-levels';

/** `looks`: the run is made once more; `tries`: changes are tried; `told`: the hint is there. */
type OwnHintPhase = 'looks' | 'tries' | 'told' | 'passes' | 'failed';

/** The hint to the pupil's own program. It goes with the first change to the program or the course. */
export interface OwnHint {
  readonly phase: ShallowRef<OwnHintPhase>;
  readonly hint: ShallowRef<Hint | null>;
  /** Number of changes tried so far. */
  readonly tried: ShallowRef<number>;
  /** The sentences, as far as they were asked for. */
  readonly texts: ComputedRef<readonly string[]>;
  /** The lines of `main.py` to look at. */
  readonly lines: ComputedRef<readonly number[]>;
  /** Ends the trying; the moment stays. */
  cancel(): void;
}

/** The page's services for a hint. */
export interface HintPorts {
  /** Gives a function that starts threads for a task. Rejects without the VM. */
  starter(task: ClassTask): Promise<Start<HintRequest, Hint | null>>;
  readonly every: Every;
}

const inWorkers: HintPorts = {
  starter: async (task) => serveThread({ service: 'hint', task: projectOfTask(task) }, await compileFirmware()),
  every,
};

type App = { readonly task: { readonly own: OwnHintState } } & Pick<WorkParts, 'work'>;

/** The hint of this page. */
export const ownHintOf = lateModel((app: WithLate & App) => createOwnHint(app));

/** The progress is shown this often, in ms of wall time. */
const SHOW_MS = 300;

/** Number of levels of a hint for which no change was found: the moment, and what was tried. */
const WITHOUT_CHANGE = 2;

/** Finds the hint as soon as a level of it is asked for: the moment at once, all else by trying. */
export function createOwnHint({ task: { own }, work }: App, ports = inWorkers): OwnHint {
  const phase = shallowRef<OwnHintPhase>('looks');
  const hint = shallowRef<Hint | null>(null);
  const tried = shallowRef(0);
  let [lane, turn, hasTried]: [HintLane | null, number, boolean] = [null, 0, false];
  let unwatch = (): void => undefined;

  function stop(): void {
    turn += 1;
    unwatch();
    lane?.stop();
    lane = null;
  }
  function drop(): void {
    stop();
    hasTried = false;
    hint.value = null;
    phase.value = 'looks';
    own.level.value = 0;
    own.most.value = hintLevels.length;
  }
  async function find(budget: number): Promise<void> {
    stop();
    const now = turn;
    phase.value = budget === 0 ? 'looks' : 'tries';
    tried.value = 0;
    const { project } = work.work.value;
    const [read, given] = [taskOf(project), handInOf(project)];
    try {
      if ('problem' in read || 'problem' in given) throw new Error('There is no task, or no program.');
      const task = visibleTask(read.task);
      const start = await ports.starter(task);
      if (now !== turn) return;
      lane = new HintLane(task, withProgress(start, task.worlds.length), ports.every);
      const found = await lane.hint(given.handIn, budget);
      if (now === turn) tell(found, budget);
    } catch {
      if (now === turn) end('failed');
    }
  }
  function tell(found: Hint | null, budget: number): void {
    hasTried = budget > 0;
    hint.value = found;
    if (found === null) own.most.value = own.level.value;
    else if (hasTried && found.change === null) own.most.value = WITHOUT_CHANGE;
    end(found === null ? 'passes' : 'told');
  }
  function end(how: OwnHintPhase): void {
    stop();
    phase.value = how;
  }
  /** The threads say in which world they are, and after the worlds at which try. */
  const withProgress =
    (start: Start<HintRequest, Hint | null>, worlds: number): Start<HintRequest, Hint | null> =>
    (heard) => {
      const thread = start(heard);
      unwatch();
      unwatch = ports.every(SHOW_MS, () => (tried.value = Math.max(tried.value, thread.pulse().world - worlds)));
      return thread;
    };

  watch(
    own.level,
    (level) => {
      if (level === 0) drop();
      else if (level === 1 && hint.value === null) void find(0);
      else if (level > 1 && !hasTried && phase.value !== 'tries') void find(USUAL_BUDGET);
    },
    { immediate: true },
  );
  watch(() => [work.work.value.project.files, work.work.value.project.devices, work.scene.value], drop);
  const level = computed(() => hintLevels.findLast((one) => one <= own.level.value && (one === 1 || hasTried)) ?? 1);
  return {
    ...{ phase, hint, tried },
    texts: computed(() =>
      phase.value === 'told' && hint.value !== null ? hintTexts(hint.value, level.value, shownLanguage()) : [],
    ),
    lines: computed(() => {
      const found = hint.value;
      if (phase.value !== 'told' || found === null || level.value < 2) return [];
      return found.change === null ? [] : linesToSee(found.change, found.program);
    }),
    cancel() {
      own.level.value = 1;
      if (hint.value === null) void find(0);
      else end('told');
    },
  };
}
