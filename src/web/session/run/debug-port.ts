import { shallowRef, type ShallowRef } from 'vue';

import type { RunPhase } from '#simulation/pace';
import type { BreakPoint, LineStep } from '#vm/debug/stops';
import type { ToRun } from './run-client';
import type { FromWorker } from './worker/protocol';

/** Breakpoints of each device, by its place. */
export type PointsOfDevices = readonly (readonly BreakPoint[])[];

type Held = Extract<FromWorker, { type: 'held' }>;
type Told = Extract<FromWorker, { type: 'variables' }>;

/** The debugger's side of a run: its breakpoints and steps, and the variables at a stop. */
export class DebugPort {
  /** The place where a breakpoint or a step last paused the run; `null`: not yet. */
  readonly held: ShallowRef<Held | null> = shallowRef(null);
  /** The answer to `inspect`; `null`: there was none yet. */
  readonly told: ShallowRef<Told | null> = shallowRef(null);
  private points: PointsOfDevices = [];

  /** @param run its phase, and how it gets messages */
  constructor(private readonly run: { readonly phase: ShallowRef<RunPhase>; send(message: ToRun): unknown }) {}

  /** Sets the breakpoints of this run and the next ones. */
  setBreakPoints(points: PointsOfDevices): void {
    this.points = points;
    this.tellPoints();
  }

  /** Makes a device of a paused run step by lines; then the run is paused again. */
  step(step: LineStep, device: number): void {
    const { phase } = this.run;
    if (phase.value !== 'paused') return;
    this.run.send({ type: 'step-line', step, device });
    phase.value = 'running';
  }

  /** Requests the variables of a device. */
  inspect(device: number): void {
    this.run.send({ type: 'inspect', device });
  }

  /** A run begins: forgets the last stop and answer, and sends the breakpoints if there are any. */
  begin(): void {
    this.held.value = this.told.value = null;
    if (this.points.some(({ length }) => length > 0)) this.tellPoints();
  }

  hear(message: Held | Told): void {
    if (message.type === 'variables') {
      this.told.value = message;
      return;
    }
    if (this.run.phase.value === 'running') this.run.phase.value = 'paused';
    this.held.value = message;
  }

  private tellPoints(): void {
    this.run.send({ type: 'break-points', points: this.points });
  }
}
