import type { Pose } from '#core/geometry';
import type { RunOutlets } from '#simulation/outlets';
import type { Scene } from '#scene/scene';
import type { Reason, WorldResult } from '../result';
import { watcherOf, type RunCheck } from './watchers';
import type { Standing, Step, Watcher } from './watcher';

/** A check and its watcher. */
interface Watched {
  readonly check: RunCheck;
  readonly watcher: Watcher;
}

/** Result of a run's checks. */
export type Outcome = Pick<WorldResult, 'passed' | 'reason' | 'atMs' | 'held' | 'missed' | 'touches' | 'counts'>;

/** Why a check was not reached, if there is more to say than that (`causeOf`). */
export type ReasonGiver = (check: RunCheck, failedUs: number | null) => Reason | null;

/**
 * All watchers of a run for a task's checks. They see each step of the world that the judge of the course sees, up to
 * the step in which everything is decided or the time is over: anything later does not count.
 */
export class Judging {
  private readonly watched: readonly Watched[];
  private isOver = false;
  private touches = 0;
  private lastUs = 0;
  private endUs = 0;
  private start: Pose | null = null;
  private isAway = false;
  /** True if something was printed or sent since the last step. */
  private hasHeard = false;

  /** @param limitUs the last simulated time that counts */
  constructor(
    checks: readonly RunCheck[],
    course: Scene,
    private readonly limitUs: number,
  ) {
    this.watched = checks.map((check): Watched => ({ check, watcher: watcherOf(check, course) }));
  }

  /** True once nothing that happens changes the result any more. */
  get isDone(): boolean {
    return this.isOver;
  }

  /** Looks at the run. Call it before the first step of the world and after each. */
  step(run: Step): void {
    // Printed or sent data arrives between two steps, and may have been the last that was missing.
    if (run.nowUs > this.limitUs || (this.hasHeard && this.isDecided(this.lastUs))) this.end(run);
    this.hasHeard = false;
    if (this.isOver) return;
    this.lastUs = run.nowUs;
    if (!this.isAway) this.note(run.pose);
    ({ touches: this.touches } = run);
    for (const { watcher } of this.watched) watcher.step?.(run);
    if (this.isDecided(run.nowUs) || run.nowUs >= this.limitUs) this.end(run);
  }

  /** Call it when the run is over. */
  end(run: Step): void {
    if (this.isOver) return;
    this.isOver = true;
    this.endUs = run.nowUs;
    for (const { watcher } of this.watched) watcher.end?.(run);
  }

  /** The outlets for the run: those with a watcher, and `print` always, so that the run stores no printed text. */
  outlets(nowUs: () => number): RunOutlets {
    const having = (name: 'print' | 'sound' | 'radio' | 'log'): readonly Watcher[] =>
      this.watched.flatMap(({ watcher }) => (watcher[name] === undefined ? [] : [watcher]));
    const [prints, sounds, radios, logs] = [having('print'), having('sound'), having('radio'), having('log')];
    const hears = (device: number): boolean => {
      const isHeard = device === 0 && nowUs() <= this.limitUs && !this.isOver;
      this.hasHeard ||= isHeard;
      return isHeard;
    };
    return {
      print: (text, device) => {
        if (hears(device)) for (const watcher of prints) watcher.print?.(text, nowUs());
      },
      ...(sounds.length > 0 && {
        sound: (event, device) => {
          if (hears(device)) for (const watcher of sounds) watcher.sound?.(event);
        },
      }),
      ...(radios.length > 0 && {
        radio: (packet, device) => {
          if (hears(device)) for (const watcher of radios) watcher.radio?.(packet);
        },
      }),
      ...(logs.length > 0 && {
        log: (event, device) => {
          if (hears(device)) for (const watcher of logs) watcher.log?.(event);
        },
      }),
    };
  }

  /** True if the first robot has moved since the beginning, even if it is back there. */
  get hasMoved(): boolean {
    return this.isAway;
  }

  /**
   * The results of the checks, once the run is over.
   *
   * @param besides details for the reason of each check that was not reached
   */
  outcome(cause: ReasonGiver, besides: Reason['params']): Outcome {
    const ends = this.watched.map(({ check, watcher }) => ({ check, watcher, ...watcher.standing() }));
    const reachedUs = this.reachedAt();
    // Touching nothing because nothing was done does not count as passing.
    const counts =
      reachedUs !== null || !ends.some(({ check, state }) => check.needed && (state === 'open' || state === 'met'));
    const isHeld = ({ state }: Standing): boolean => state === 'met' || (state === 'held' && counts);
    const lacking = ends.filter((end) => end.check.needed && (end.state === 'open' || end.state === 'failed'));
    const failed = lacking.find(({ state }) => state === 'failed');
    const first = failed ?? lacking[0];
    // The cause of the run's end explains everything that was still open.
    const whyOpen = ({ check, watcher }: (typeof ends)[number]): Reason => {
      if (failed !== undefined) return cause(check, failed.atUs) ?? whyFailed(failed);
      const reason = cause(check, null) ?? watcher.reason();
      return { ...reason, params: { ...reason.params, ...besides } };
    };
    const whyFailed = ({ check, watcher }: (typeof ends)[number]): Reason => {
      const reason = watcher.reason();
      return (reason.code === 'time' ? cause(check, null) : null) ?? reason;
    };
    const whyFirst =
      first && (first.state === 'failed' ? (cause(first.check, first.atUs) ?? whyFailed(first)) : whyOpen(first));
    const reason = whyFirst ?? null;
    const whyMissed = (end: (typeof ends)[number]): Reason => {
      if (end.state === 'failed') return whyFailed(end);
      return end.state === 'held' && reason !== null ? reason : whyOpen(end);
    };
    return {
      passed: first === undefined,
      reason,
      atMs: timeOf(first, reachedUs ?? this.endUs),
      touches: this.touches,
      held: ends.filter(isHeld).map(({ check }) => check.id),
      missed: Object.fromEntries(ends.filter((end) => !isHeld(end)).map((end) => [end.check.id, whyMissed(end)])),
      ...this.counts(),
    };
  }

  /** Numbers of those reached, of the checks that give points for each. */
  private counts(): Pick<Outcome, 'counts'> {
    const found = this.watched.flatMap(({ check, watcher }) =>
      check.type === 'checkpoints' && check.each !== null ? [[check.id, watcher.count?.() ?? 0] as const] : [],
    );
    return found.length === 0 ? {} : { counts: Object.fromEntries(found) };
  }

  private note(pose: Pose | null): void {
    if (pose === null) return;
    this.start ??= pose;
    const { xMm, yMm, headingRad } = this.start;
    this.isAway = pose.xMm !== xMm || pose.yMm !== yMm || pose.headingRad !== headingRad;
  }

  /** True if something needed has failed for good, or if nothing is open and something was reached. */
  private isDecided(nowUs: number): boolean {
    const reachedUs = this.reachedAt();
    let [isOpen, isMet] = [false, false];
    for (const { check, watcher } of this.watched) {
      watcher.clock?.(nowUs, reachedUs);
      const { state } = watcher.standing();
      if (state === 'failed' && check.needed) return true;
      isOpen ||= state === 'open';
      isMet ||= state === 'met';
    }
    return isMet && !isOpen;
  }

  /** When the last of what is needed was reached; `null`: something is not yet, or there is nothing to reach. */
  private reachedAt(): number | null {
    let reachedUs: number | null = null;
    for (const { check, watcher } of this.watched) {
      if (!check.needed) continue;
      const { state, atUs } = watcher.standing();
      if (state === 'open') return null;
      if (state === 'met' && atUs !== null) reachedUs = Math.max(reachedUs ?? 0, atUs);
    }
    return reachedUs;
  }
}

/** Simulated ms of the decision; `null`: what is missing was not decided. */
function timeOf(missing: Standing | undefined, passedUs: number): number | null {
  if (missing === undefined) return passedUs / 1000;
  return missing.atUs === null ? null : missing.atUs / 1000;
}
