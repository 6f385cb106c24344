import { shallowRef, type ShallowRef } from 'vue';

import type { RunPhase } from '#simulation/pace';
import type { BreakPoint, LineStep } from '#vm/debug/stops';
import type { ToRun } from './run-client';
import type { FromWorker } from './worker/protocol';

/** Break points of each device, by its place. */
export type PointsOfDevices = readonly (readonly BreakPoint[])[];

type Held = Extract<FromWorker, { type: 'held' }>;
type Told = Extract<FromWorker, { type: 'variables' }>;

/** What of a run is a debugger's: where it stops, and what its variables are then. */
export class DebugPort {
  /** Where a break point or a step has stopped the run last; `null`: not yet. */
  readonly held: ShallowRef<Held | null> = shallowRef(null);
  /** The answer to `inspect`; `null`: there was none yet. */
  readonly told: ShallowRef<Told | null> = shallowRef(null);
  private points: PointsOfDevices = [];

  /** @param run its phase, and how it gets messages */
  constructor(private readonly run: { readonly phase: ShallowRef<RunPhase>; send(message: ToRun): unknown }) {}

  /** Where this run and the next ones stop from now on. */
  stopAt(points: PointsOfDevices): void {
    this.points = points;
    this.tellPoints();
  }

  /** Lets a device of a paused run make a step by lines; then the run stands again. */
  step(step: LineStep, device: number): void {
    const { phase } = this.run;
    if (phase.value !== 'paused') return;
    this.run.send({ type: 'step-line', step, device });
    phase.value = 'running';
  }

  /** Asks for the variables of a device. */
  inspect(device: number): void {
    this.run.send({ type: 'inspect', device });
  }

  /** A run begins. */
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
