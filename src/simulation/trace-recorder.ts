import type { Mounted } from './mount-robot';
import { createTraceHash, TRACE_PERIOD_US, type TraceRow } from './trace';

/** Writes down where the robots are, every 20 ms: into the fingerprint always, as rows only if rows are kept. */
export class TraceRecorder {
  private rows: TraceRow[] = [];
  private readonly hash = createTraceHash();

  /** @param robots by device, in their order; without a robot nothing is written */
  constructor(
    private readonly robots: readonly { readonly device: string; readonly mounted: Mounted }[],
    private readonly keepsRows: boolean,
  ) {}

  /** Fingerprint of the trajectory so far, 64 hexadecimal digits. */
  fingerprint(): string {
    return this.hash.hex();
  }

  /** The rows since the last call: one per 20 ms and robot, if they are kept. A run of a day would not fit into memory. */
  take(): readonly TraceRow[] {
    const { rows } = this;
    this.rows = [];
    return rows;
  }

  /** Call it after each step of the world. */
  step(timeUs: number): void {
    if (timeUs % TRACE_PERIOD_US !== 0) return;
    for (const { device, mounted } of this.robots) {
      const { xMm, yMm, headingRad } = mounted.chassis.pose();
      this.hash.add(timeUs, xMm, yMm, headingRad);
      if (this.keepsRows) this.rows.push({ device, ...rowOf(mounted, timeUs) });
    }
  }
}

function rowOf({ chassis, robot }: Mounted, timeUs: number): Omit<TraceRow, 'device'> {
  const { xMm, yMm, headingRad } = chassis.pose();
  const state = robot.state();
  return {
    timeUs,
    xMm,
    yMm,
    headingRad,
    leftMmPerS: chassis.wheelSpeedMmPerS(0),
    rightMmPerS: chassis.wheelSpeedMmPerS(1),
    leftDuty: state.duty.left,
    rightDuty: state.duty.right,
    lineSensors: state.lineSensors.map(({ name, bright }) => ({ name, bright })),
    distanceMm: state.ultrasonic?.distanceMm ?? null,
    collisions: chassis.collisions(),
  };
}
