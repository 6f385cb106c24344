import { effectScope, shallowRef, watch, type Ref, type ShallowRef } from 'vue';

import { isSame } from '#core/same';
import type { Scene } from '#scene/scene';
import type { Snapshot } from '#simulation/snapshot';
import type { Verdict } from '#simulation/task/verdict';
import type { Recording } from './recording';
import type { Ended } from '#simulation/simulation';

/** The choice of the earlier run that is shown as a ghost. */
export type GhostWish = 'none' | 'last' | 'best' | 'opened';

/** Maximum number of runs in the list. Chosen: the last, the best and one that was opened, on two courses. */
const MOST_RUNS = 6;
/** Most bytes of all their tapes together. Chosen: three hours of one device; a usual run takes 20 kB a minute. */
const MOST_BYTES = 4_000_000;

/** The run that the page shows, as `RunModel` has it. */
interface RunNow {
  readonly present: Readonly<Ref<Snapshot | null>>;
  readonly recording: Readonly<Ref<Recording>>;
  readonly endings: Readonly<Ref<readonly (Ended | null)[]>>;
  readonly isActive: Readonly<Ref<boolean>>;
  readonly hasEnded: Readonly<Ref<boolean>>;
}

/** The stored part of a finished run. */
export interface EarlierRun {
  /** Its number on this page, as the console has it. */
  readonly number: number;
  /** True if it was opened from a link or a file. */
  readonly isOpened: boolean;
  /** Its moments. The last ones may still be in transit. */
  readonly recording: Recording;
  readonly scene: Scene;
  /** Ids of the robots, by the place of their device; `null`: a board alone. */
  readonly robots: readonly (string | null)[];
  readonly verdict: Verdict | null;
  /** Its duration: to the verdict if it was passed, else to the end of the program, else until it was left. */
  readonly tookUs: number;
}

/** The course on which a ghost is to drive, and the robots by the place of their device. */
export type GhostCourse = Pick<EarlierRun, 'scene' | 'robots'>;

/** The finished runs of this visit. Begins with the run on the page. */
export class EarlierRuns {
  /** Oldest first. */
  readonly all: ShallowRef<readonly EarlierRun[]> = shallowRef([]);
  /** The chosen ghost. Opening a run and then starting one means racing against it. */
  readonly wish: ShallowRef<GhostWish> = shallowRef('none');
  private last: Snapshot | null = null;

  /** @param number returns the number of the run on the page, also while it is being left */
  constructor(
    private readonly run: RunNow,
    private readonly number: () => number,
  ) {
    // Not the scope of its creator: it lives as long as the run.
    effectScope(true).run(() => {
      watch(run.present, (present) => (this.last = present ?? this.last), { flush: 'sync', immediate: true });
      watch(run.recording, (_, left) => this.keep(left), { flush: 'sync' });
    });
  }

  /**
   * The runs that can be chosen on a course with these robots; a missing entry: there is none.
   *
   * @param withPresent true: the run on the page counts as well once it is over, as it will for the next one
   */
  choices(course: GhostCourse, withPresent = false): Partial<Record<Exclude<GhostWish, 'none'>, EarlierRun>> {
    const present = withPresent ? this.finished() : null;
    const all = present === null ? this.all.value : [...this.all.value, present];
    const fitting = all.filter((run) => run.recording.count.value > 0 && isOn(run, course));
    const own = fitting.filter(({ isOpened }) => !isOpened);
    const last = own.at(-1);
    const best = bestOf(own);
    const opened = fitting.findLast(({ isOpened }) => isOpened);
    return { ...(last && { last }), ...(best && { best }), ...(opened && { opened }) };
  }

  /** Adds a run that was made beside the page, and lets it drive along. */
  bring(run: Omit<EarlierRun, 'number' | 'isOpened' | 'verdict'>): void {
    this.all.value = fewer([...this.all.value, { ...run, number: 0, isOpened: true, verdict: null }]);
    this.wish.value = 'opened';
  }

  private keep(left: Recording): void {
    const { last } = this;
    this.last = null;
    const kept = last && this.runOf(left, last);
    if (kept === null) return;
    this.all.value = fewer([...this.all.value, kept]);
    if (kept.isOpened) this.wish.value = 'opened';
  }

  /** The run on the page, if it is over. */
  private finished(): EarlierRun | null {
    const { present, recording, isActive, hasEnded } = this.run;
    if (present.value === null || (isActive.value && !hasEnded.value)) return null;
    return this.runOf(recording.value, present.value);
  }

  /** @param last its last picture @returns `null`: nothing of it would be seen */
  private runOf(recording: Recording, last: Snapshot): EarlierRun | null {
    const { setup, isBrought: isOpened } = recording;
    const robots = [last, ...last.others].map(({ robot }) => robot?.type ?? null);
    if (setup === null || robots.every((robot) => robot === null)) return null;
    const { verdict } = last;
    const endUs = Math.max(...this.run.endings.value.map((ended) => ended?.timeUs ?? last.timeUs), 0);
    const tookUs = verdict?.state === 'passed' && verdict.atMs !== null ? verdict.atMs * 1000 : endUs;
    return { number: this.number(), isOpened, recording, scene: setup.scene, robots, verdict, tookUs };
  }
}

/** True if a run was driven on this course, by these robots. The name and the task of the course do not matter. */
function isOn(run: EarlierRun, { scene, robots }: GhostCourse): boolean {
  return isSame(run.robots, robots) && (run.scene === scene || isSame(arenaOf(run.scene), arenaOf(scene)));
}

const arenaOf = ({ size, background, objects, robot: { at, heading, scale } }: Scene): unknown => [
  ...[size, background, objects],
  ...[at, heading, scale],
];

/** The best of the runs with a task, by `meritOf`; of equals, the first. `undefined`: there is none. */
function bestOf(runs: readonly EarlierRun[]): EarlierRun | undefined {
  return runs.filter(({ verdict }) => verdict !== null).reduce<EarlierRun | undefined>(better, undefined);
}

/** The better of two runs; of equals, the first: it is the one to be beaten. */
function better(one: EarlierRun | undefined, other: EarlierRun): EarlierRun {
  if (one === undefined) return other;
  const [of, to] = [meritOf(one), meritOf(other)];
  const at = of.findIndex((merit, index) => merit !== to[index]);
  return (of[at] ?? 0) < (to[at] ?? 0) ? other : one;
}

/** The criteria of a run's merit, the most important first; more is better. */
function meritOf({ verdict, tookUs }: EarlierRun): readonly number[] {
  if (verdict === null) return [];
  const { state, stars, checkpoints, targets, blocks } = verdict;
  const isPassed = state === 'passed';
  const done = checkpoints.passed + targets.reached + blocks.delivered;
  return [Number(isPassed), stars ?? 0, done, isPassed ? -tookUs : 0];
}

/**
 * Removes the oldest runs if there are too many. The newest, the last opened one and the best on each course are
 * removed last.
 */
function fewer(runs: readonly EarlierRun[]): readonly EarlierRun[] {
  let kept = runs;
  while (kept.length > 1 && (kept.length > MOST_RUNS || bytesOf(kept) > MOST_BYTES)) {
    const rest = kept;
    const isSpared = (run: EarlierRun): boolean =>
      run === rest.at(-1) ||
      run === rest.findLast(({ isOpened }) => isOpened) ||
      run === bestOf(rest.filter((other) => !other.isOpened && isOn(other, run)));
    const gone = kept.find((run) => !isSpared(run)) ?? kept[0];
    kept = kept.filter((run) => run !== gone);
  }
  return kept;
}

const bytesOf = (runs: readonly EarlierRun[]): number =>
  runs.reduce((sum, { recording }) => sum + recording.pieces.reduce((all, { length }) => all + length, 0), 0);
