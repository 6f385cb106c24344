import type { Inspected } from '#vm/debug/inspected';
import type { StopRule } from '#vm/debug/line-watch';
import { atBreakPoints, ruleOf, type BreakPoint, type LineStep } from '#vm/debug/stops';

/** The used part of a run. */
export interface Debugged {
  /** Place of the device whose rule has stopped the run, or `null`. */
  readonly heldBy: number | null;
  inspect(device: number): Inspected | null;
  watch(rule: StopRule | null, device: number): void;
  /** The clock of a device. */
  timeOf(device: number): number;
}

/** The stops of a run: the breakpoints of its devices, and the end of the current step. */
export class Stops {
  private points: readonly (readonly BreakPoint[])[] = [];
  private step: { readonly device: number; readonly step: LineStep } | null = null;

  /** @param points of each device, by its place */
  setPoints(points: readonly (readonly BreakPoint[])[], run: Debugged | null): void {
    const before = this.points;
    this.points = points;
    for (const device of new Set([...before.keys(), ...points.keys()])) this.apply(run, device);
  }

  /** Begins a step of a device. It ends at the next stop of the run, whatever caused it. */
  begin(step: LineStep, device: number, run: Debugged): void {
    this.end(run);
    this.step = { device, step };
    this.apply(run, device);
  }

  /** Ends the current step. */
  end(run: Debugged | null): void {
    const { step } = this;
    this.step = null;
    if (step !== null) this.apply(run, step.device);
  }

  /** Applies all stops to a run that has just been made, or that has caught up. */
  applyAll(run: Debugged): void {
    for (const device of this.points.keys()) this.apply(run, device);
  }

  private apply(run: Debugged | null, device: number): void {
    const vm = run?.inspect(device) ?? null;
    if (run === null || vm === null) return;
    const points = this.points[device] ?? [];
    const atPoint = points.length > 0 ? atBreakPoints(points) : null;
    const atStep = this.step?.device === device ? ruleOf(this.step.step, vm) : null;
    const both = atPoint && atStep && ((event: Parameters<StopRule>[0]) => atStep(event) || atPoint(event));
    run.watch(both ?? atStep ?? atPoint, device);
  }
}
