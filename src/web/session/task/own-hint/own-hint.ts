import { computed, shallowRef, watch, type ComputedRef, type ShallowRef } from 'vue';

import { handInOf } from '#check/hand-in/read-hand-in';
import type { Every, Start } from '#check/lane';
import { taskOf } from '#check/task/read-task';
import type { ClassTask } from '#check/task/task';
import { visibleTask } from '#check/task/visible';
import { projectOfTask } from '#check/task/write-task';
import type { Project } from '#project/project';
import { linesToSee } from '#hint/changes/change';
import type { Hint } from '#hint/hint';
import { hintLevels, USUAL_BUDGET } from '#hint/level';
import { HintLane, type HintRequest } from '#hint/hint-lane';
import { hintTexts } from '#hint/say';

import { shownLanguage } from '../../../kit/i18n';
import { lateModel, type WithLate } from '../../../kit/state/late-models';
import { every, serveThread } from '../../run/serve-thread';
import type { RunParts } from '../../run/parts';
import { compileFirmware } from '../../run/worker/firmware';
import { deviceSettings } from '../../work/hardware/hardware';
import type { WorkParts } from '../../work/model/parts';
import { isHandedOut } from '../../work/model/task-locks';
import { presentProject } from '../../work/save-work';
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

type App = { readonly task: { readonly own: OwnHintState } } & WorkParts & Pick<RunParts, 'run'>;

/** The hint of this page. */
export const ownHintOf = lateModel((app: WithLate & App) => createOwnHint(app));

/** The progress is shown this often, in ms of wall time. */
const SHOW_MS = 300;

/** Number of levels of a hint for which no change was found: the moment, and what was tried. */
const WITHOUT_CHANGE = 2;

/** Looks for one hint at a time, in a thread. */
class Finder {
  readonly tried = shallowRef(0);
  private lane: HintLane | null = null;
  private turn = 0;
  private unwatch = (): void => undefined;

  constructor(private readonly ports: HintPorts) {}

  stop(): void {
    this.turn += 1;
    this.unwatch();
    this.lane?.stop();
    this.lane = null;
  }

  /** The hint to the program of a project; `undefined`: it is not wanted any more. Throws where none can be looked for. */
  async find(project: Project, budget: number): Promise<Hint | null | undefined> {
    this.stop();
    const { turn } = this;
    this.tried.value = 0;
    const [read, given] = [taskOf(project), handInOf(project)];
    if ('problem' in read || 'problem' in given) throw new Error('There is no task, or no program.');
    const task = visibleTask(read.task);
    const start = await this.ports.starter(task);
    if (turn !== this.turn) return undefined;
    this.lane = new HintLane(task, this.withProgress(start, task.worlds.length), this.ports.every);
    const found = await this.lane.hint(given.handIn, budget);
    return turn === this.turn ? found : undefined;
  }

  /** The threads say in which world they are, and after the worlds at which try. */
  private withProgress(start: Start<HintRequest, Hint | null>, worlds: number): typeof start {
    return (heard) => {
      const thread = start(heard);
      this.unwatch();
      this.unwatch = this.ports.every(SHOW_MS, () => {
        this.tried.value = Math.max(this.tried.value, thread.pulse().world - worlds);
      });
      return thread;
    };
  }
}

/** The program with the robot that it is checked with: that of a task that was handed out, else the pupil's own. */
const toSearch = (app: WorkParts): Project => {
  const { project } = app.work.work.value;
  return isHandedOut(project) ? project : presentProject(app);
};

/** Finds the hint as soon as a level of it is asked for: the moment at once, all else by trying. */
export function createOwnHint(app: App, ports = inWorkers): OwnHint {
  const { own } = app.task;
  const phase = shallowRef<OwnHintPhase>('looks');
  const hint = shallowRef<Hint | null>(null);
  const hasTried = shallowRef(false);
  const finder = new Finder(ports);

  function drop(): void {
    finder.stop();
    hasTried.value = false;
    hint.value = null;
    phase.value = 'looks';
    own.level.value = 0;
    own.most.value = hintLevels.length;
  }
  async function find(budget: number): Promise<void> {
    phase.value = budget === 0 ? 'looks' : 'tries';
    const found = await finder.find(toSearch(app), budget).catch(() => 'failed' as const);
    if (found !== undefined) tell(found, budget > 0);
  }
  function tell(found: Hint | null | 'failed', isTried: boolean): void {
    finder.stop();
    if (found === 'failed' || found === null) {
      phase.value = found ?? 'passes';
      own.most.value = own.level.value;
      return;
    }
    hasTried.value = isTried;
    hint.value = found;
    if (isTried && found.change === null) own.most.value = WITHOUT_CHANGE;
    phase.value = 'told';
  }

  watch(
    own.level,
    (level) => {
      if (level === 0) drop();
      else if (level === 1 && hint.value === null) void find(0);
      else if (level > 1 && !hasTried.value && phase.value !== 'tries') void find(USUAL_BUDGET);
    },
    { immediate: true },
  );
  function cancel(): void {
    finder.stop();
    own.level.value = 1;
    if (hint.value !== null) phase.value = 'told';
  }
  watch(searchedIn(app), drop);
  // A new run wants the computer for itself.
  watch(app.run.recording, ({ setup }) => {
    if (setup !== null && phase.value === 'tries') cancel();
  });
  return {
    ...{ phase, hint, tried: finder.tried, cancel },
    ...tellingOf(phase, hint, () => (hasTried.value ? own.level.value : 1)),
  };
}

/** The parts of the work that a hint depends on, each for itself: opening another file or saving changes none of them. */
const searchedIn = ({ work, settings }: App) => [
  () => work.work.value.project.files,
  () => work.work.value.project.devices,
  work.scene,
  () => JSON.stringify(deviceSettings(settings.current.value)),
];

/** The sentences and lines of a hint at a level. */
function tellingOf(phase: ShallowRef<OwnHintPhase>, hint: ShallowRef<Hint | null>, asked: () => number) {
  const level = computed(() => hintLevels.findLast((one) => one <= asked()) ?? 1);
  const told = computed(() => (phase.value === 'told' ? hint.value : null));
  return {
    texts: computed(() => (told.value === null ? [] : hintTexts(told.value, level.value, shownLanguage()))),
    lines: computed(() => {
      const { change = null, program = '' } = told.value ?? {};
      return change === null || level.value < 2 ? [] : linesToSee(change, program);
    }),
  };
}
