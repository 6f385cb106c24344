import { Asker, inLanes, START_MS, type Every, type Start } from '#check/lane';
import { stuckOutcome, type Drive } from '#lab/outcome';
import type { RunEnd } from '#lab/run-end';
import type { RunAnswer, RunRequest } from '#lab/run-request';
import { readSweep, valuesOf, type Sweep } from '#lab/sweep';
import type { SweepResult, SweepRun } from '#lab/sweep-texts';
import { withValues, type Base } from '#lab/what';
import type { RunSetup } from '#simulation/run-setup';
import { hasTask } from '#simulation/task/task-brief';
import { computed, shallowRef, triggerRef, type ComputedRef, type ShallowRef } from 'vue';

import { troubleKey, type TroubleKey } from '../../../session/run/worker/firmware-trouble';
import { runOrder } from './run-order';
import { followed, rangeText, type Range } from './things';

/** The most runs of a sweep in the page. Chosen: a minute on a school tablet; more is for the command line. */
export const MOST_RUNS_HERE = 1000;

/** The number of used robots that are tried. */
export const ROBOTS = 50;

/** A question to the lab. */
export type Wish =
  | { readonly kind: 'ranges'; readonly ranges: readonly Range[] }
  /** Used robots, one after the other. */
  | { readonly kind: 'robots' };

/** A run of the series, with where it went. */
export interface LabRun extends SweepRun {
  readonly drive: Drive | null;
}

/** A series of runs. */
export interface Series {
  readonly wish: Wish;
  readonly base: Base;
  readonly sweep: Sweep;
  readonly end: RunEnd;
  readonly hasTask: boolean;
  /** The finished runs by their places in the sweep. */
  readonly runs: ReadonlyMap<number, LabRun>;
  /** The same in the order in which they ended: drawings add what is new. */
  readonly came: readonly LabRun[];
}

/** The services that the lab needs. */
export interface LabPorts {
  /** The run that would start now. */
  setup(): Base;
  /** Gives a function that starts threads. Rejects without the VM. */
  starter(): Promise<Start<RunRequest, RunAnswer>>;
  readonly every: Every;
  readonly lanes: number;
  readonly nowMs: () => number;
  /** Calls a function a little later: results that come meanwhile are shown together. */
  readonly later: (act: () => void) => void;
}

/** Runs without a task end with their program, or at this simulated time. Chosen: nobody looks longer at an endless one. */
const FREE_LIMIT_US = 60_000_000;
/** With a task they may take as long as on the command line. */
const TASK_LIMIT_US = 600_000_000;
/** How much faster than the real robot a run is, before one was measured. */
const FIRST_SPEED = 80;

/** Experiments: a series of runs side by side. It stays while the page is open. */
export class LabModel {
  /** `null`: nothing was asked yet. */
  readonly series: ShallowRef<Series | null> = shallowRef(null);
  readonly isRunning = shallowRef(false);
  /** Why nothing can run; `null`: it can. `refused`: the run itself cannot be. `unclear`: the question makes no series. */
  readonly failure: ShallowRef<TroubleKey | 'refused' | 'unclear' | null> = shallowRef(null);
  /** Place of the run that is looked at; `null`: none. */
  readonly chosen: ShallowRef<number | null> = shallowRef(null);
  /** Place of the run whose values were taken over; `null`: none was. */
  readonly taken: ShallowRef<number | null> = shallowRef(null);
  readonly chosenRun: ComputedRef<LabRun | null>;
  /** The runs so far, in the order of the sweep. */
  readonly inOrder: ComputedRef<readonly LabRun[]>;
  /** Wall time of the last series, in ms. */
  readonly tookMs = shallowRef(0);
  private startMs = 0;
  private msPerRun: number | null = null;
  private turn = 0;
  private lanes: readonly Asker<RunRequest, RunAnswer>[] = [];

  constructor(private readonly ports: LabPorts) {
    this.inOrder = computed(() => {
      const series = this.series.value;
      if (series === null) return [];
      return [...series.runs].sort(([one], [other]) => one - other).map(([, run]) => run);
    });
    this.chosenRun = computed(() => this.series.value?.runs.get(this.chosen.value ?? -1) ?? null);
  }

  /** The run that would start now, for what can vary. */
  base(): Base {
    return this.ports.setup();
  }

  /** Wall time that so many runs will take, in ms. @param simulatedMs of one of them */
  estimateMs(count: number, simulatedMs: number): number {
    return (count * (this.msPerRun ?? simulatedMs / FIRST_SPEED)) / this.ports.lanes;
  }

  /** Makes a series of runs; one that is under way is given up. @returns whether it makes sense */
  async begin(wish: Wish): Promise<boolean> {
    const { turn } = this.stop();
    const series = seriesOf(wish, this.ports.setup());
    this.failure.value = series === null ? 'unclear' : null;
    if (series === null) return false;
    this.chosen.value = this.taken.value = null;
    this.series.value = series;
    this.isRunning.value = true;
    this.startMs = this.ports.nowMs();
    try {
      await this.runAll(series, turn);
    } catch (why) {
      if (turn === this.turn) this.failure.value = troubleKey(why);
    }
    if (turn !== this.turn) return true;
    this.stop();
    triggerRef(this.series);
    return true;
  }

  /** The question of the series for the work as it is now; `null`: a number of it can no longer be found. */
  wishNow(): Wish | null {
    const series = this.series.value;
    if (series === null || series.wish.kind === 'robots') return series?.wish ?? null;
    const then = (this.taken.value === null ? null : this.setupAt(this.taken.value)) ?? series.base.setup;
    const { setup } = this.ports.setup();
    const ranges = series.wish.ranges.flatMap((range) => followed(range, then, setup) ?? []);
    return ranges.length < series.wish.ranges.length ? null : { kind: 'ranges', ranges };
  }

  /** Ends the runs that are under way; what has come stays. */
  stop(): { readonly turn: number } {
    this.turn += 1;
    if (this.isRunning.value) this.measure();
    for (const lane of this.lanes) lane.stop();
    this.lanes = [];
    this.isRunning.value = false;
    return { turn: this.turn };
  }

  /** The set-up of a run of the series. */
  setupAt(place: number): RunSetup | null {
    const series = this.series.value;
    return series && withValues(series.base, series.sweep.varied, valuesOf(series.sweep, place));
  }

  /** All runs so far as the command line gives them. */
  result(): SweepResult {
    return { varied: this.series.value?.sweep.varied.map(({ name }) => name) ?? [], runs: this.inOrder.value };
  }

  private measure(): void {
    this.tookMs.value = this.ports.nowMs() - this.startMs;
    const count = this.series.value?.runs.size ?? 0;
    if (count > 0 && this.lanes.length > 0) this.msPerRun = (this.tookMs.value * this.lanes.length) / count;
  }

  private async runAll(series: Series, turn: number): Promise<void> {
    const start = await this.ports.starter();
    if (turn !== this.turn) return;
    const order = runOrder(series.sweep);
    // A run has as long as it takes: only one without a sign of life is given up.
    this.lanes = Array.from(
      { length: Math.min(this.ports.lanes, order.length) },
      () => new Asker(start, this.ports.every, Infinity, START_MS),
    );
    let isTold = false;
    const tell = (): void => {
      if (isTold) return;
      isTold = true;
      this.ports.later(() => {
        isTold = false;
        if (this.series.value === series) triggerRef(this.series);
      });
    };
    const left = (): boolean => turn !== this.turn || this.failure.value !== null;
    const wanted = function* (): Generator<number> {
      for (const place of order) {
        if (left()) return;
        yield place;
      }
    };
    await inLanes(wanted(), this.lanes, async (place, _, lane) => {
      const values = valuesOf(series.sweep, place);
      const setup = withValues(series.base, series.sweep.varied, values);
      const answer = await lane.ask({ setup, end: series.end, withDrive: true });
      if (left()) return;
      const run = runOf(answer, series);
      if ('reason' in answer && answer.reason.code === 'unloaded') this.failure.value = troubleKey(null);
      else if (run === null) this.failure.value = 'refused';
      else {
        const made = { values, ...run };
        (series.runs as Map<number, LabRun>).set(place, made);
        (series.came as LabRun[]).push(made);
        tell();
      }
    });
  }
}

/** The answer of a thread as a run; `null`: it was refused, or something broke inside. */
function runOf(
  answer: Awaited<ReturnType<Asker<RunRequest, RunAnswer>['ask']>>,
  series: Series,
): Omit<LabRun, 'values'> | null {
  if (!('result' in answer)) {
    if (answer.reason.code === 'broken') return null;
    return { ...stuckOutcome(series.hasTask), drive: null };
  }
  const { result } = answer;
  return 'refused' in result ? null : { ...result.outcome, drive: result.drive ?? null };
}

/** A series that has not begun; `null`: it has no runs, or too many. */
function seriesOf(wish: Wish, now: Base): Series | null {
  const isUsed = now.setup.reality > 0;
  const base = wish.kind === 'robots' && !isUsed ? { ...now, setup: { ...now.setup, reality: 1 } } : now;
  const texts = wish.kind === 'robots' ? [`seed=1..${ROBOTS}/1`] : wish.ranges.map(rangeText);
  const sweep = readSweep(texts, base);
  if ('problem' in sweep || sweep.count > MOST_RUNS_HERE) return null;
  const isTask = hasTask(base.setup.scene);
  const end: RunEnd = {
    untilUs: isTask ? TASK_LIMIT_US : FREE_LIMIT_US,
    ...{ untilProgramEnds: !isTask, untilVerdict: isTask },
  };
  return { wish, base, sweep, end, hasTask: isTask, runs: new Map(), came: [] };
}
