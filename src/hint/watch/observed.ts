import type { Pose, Vec } from '#core/geometry';
import type { Onlooker } from '#check/run/run-world';
import { LineWatch } from '#check/run/line-watch';
import { MAIN } from '#project/project';
import type { Zone } from '#scene/scene';
import type { Simulation } from '#simulation/simulation';
import { Route } from '#simulation/task/route';
import { briefOf } from '#simulation/task/task-brief';
import { isStill } from './still';

/** The first robot at one moment. */
export interface Moment {
  readonly timeUs: number;
  readonly pose: Pose;
  readonly duty: { readonly left: number; readonly right: number };
  /** True for each line sensor that sees light ground. */
  readonly bright: readonly boolean[];
  readonly touches: number;
}

/** Simulated time between two moments that are kept. Chosen: as often as the trace. */
const EVERY_US = 20_000;
/** Chosen: ten minutes; a longer run says nothing new. */
const MOST_MOMENTS = 30_000;

/** Notes what a run does: where the robot was, what it saw, which lines ran when. */
export class Observed implements Onlooker {
  readonly hasEnough = false;
  readonly moments: Moment[] = [];
  /** For each line of `main.py` that ran, when it last began, in µs. */
  readonly lastRanUs = new Map<number, number>();
  /** The places of its line sensors, robot frame, in mm. */
  sensorsMm: readonly Vec[] = [];
  private line: LineWatch | null = null;
  private route: Route | null = null;
  /** Number of the checkpoint that is next; infinite: none is left. */
  private number: number | null = null;
  private isNew = true;
  /** True once nothing new happens: a robot that stands is not looked at any closer. */
  private looksLess = false;
  /** Simulated time since which the places that were next at the end were next, in µs. */
  nextSinceUs = 0;
  /** Simulated time at which its program ended; `null`: it did not. */
  endedUs: number | null = null;

  /** The places that were next at the end. */
  get next(): readonly Zone[] {
    return this.route?.next ?? [];
  }

  /** Simulated time at which the robot left the line that leads to the course's places, in µs; `null`: it did not. */
  get leftUs(): number | null {
    return this.line?.leftUs ?? null;
  }

  /**
   * From now on a robot that stands is not looked at any closer, and only lines are noted that have not run yet: all others run
   * at full speed.
   *
   * @param count number of lines of `main.py`
   */
  noteLess(run: Simulation, count: number): void {
    this.looksLess = true;
    const only = Array.from({ length: count }, (_, place) => ({ file: MAIN, line: place + 1 })).filter(
      ({ line }) => !this.lastRanUs.has(line),
    );
    run.watch(only.length === 0 ? null : Object.assign(this.note(run), { only }));
  }

  private note(run: Simulation): (event: { readonly file: string; readonly line: number }) => boolean {
    return ({ file, line }) => {
      if (file === MAIN) this.lastRanUs.set(line, run.nowUs);
      return false;
    };
  }

  look(run: Simulation): void {
    if (this.isNew) {
      this.isNew = false;
      this.line = new LineWatch(run.scene);
      this.route = new Route(briefOf(run.scene));
      run.watch(this.note(run));
    }
    const { nowUs, pose, ended } = run;
    if (ended !== null) this.endedUs ??= ended.timeUs;
    if (pose !== null) this.pass({ x: pose.xMm, y: pose.yMm }, nowUs);
    if (pose === null || nowUs % EVERY_US !== 0 || this.moments.length >= MOST_MOMENTS) return;
    this.line?.look(nowUs, { x: pose.xMm, y: pose.yMm });
    const last = this.moments.at(-1);
    if (this.looksLess && last !== undefined && isStill(pose, last.pose)) {
      this.moments.push({ ...last, timeUs: nowUs, pose, touches: run.touches });
      return;
    }
    const { robot } = run.snapshot();
    if (robot === null) return;
    const { duty, lineSensors } = robot.state;
    if (this.moments.length === 0) this.sensorsMm = lineSensors.map(({ atMm }) => atMm);
    this.moments.push({
      ...{ timeUs: nowUs, pose, touches: run.touches },
      duty: { left: duty.left, right: duty.right },
      bright: lineSensors.map(({ bright }) => bright),
    });
  }

  private pass(at: Vec, nowUs: number): void {
    const { route } = this;
    if (route === null) return;
    const next = route.pass(at);
    if (next !== this.number) [this.number, this.nextSinceUs] = [next, nowUs];
  }
}
