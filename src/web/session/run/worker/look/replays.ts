import type { RunSetup } from '#simulation/run-setup';
import { Causes } from '#simulation/causes/causes';
import { Simulation } from '#simulation/simulation';
import type { Instant } from './protocol';

/** Number of parked runs to continue from; each takes 4 MB and its world. Chosen: one near the shown moment, one before it. */
const MOST_PARKED = 2;
/** Longest stretch without looking at messages, in ms of wall time. */
const SLICE_MS = 12;
/** Simulated time run in one piece, in µs: at first, at least, and at most. Chosen: fractions of a slice. */
const PIECE_US = 20_000;
const LEAST_PIECE_US = 4000;
const MOST_PIECE_US = 2_000_000;

/** The worker's services that the replays use. */
export interface Bench {
  nowMs(): number;
  /** Lets messages in. */
  rest(): Promise<void>;
}

/** A newer request has arrived: the current one was given up. */
export class Overtaken extends Error {}

/** A parked run, and the moment it is at if that was inspected. */
interface Parked {
  readonly run: Simulation;
  readonly at: Instant | null;
}

/** The same run, again and again: brought to any moment, in slices, and parked there for the next request. */
export class Replays {
  /** The lines that caused each output, up to the farthest point of any run. */
  readonly causes = new Causes();
  private parked: readonly Parked[] = [];

  constructor(
    private readonly setup: RunSetup,
    private readonly firmware: WebAssembly.Module,
    private readonly bench: Bench,
  ) {}

  /** True if one is parked between two times: from there the second is soon reached. */
  hasBetween = (fromUs: number, toUs: number): boolean =>
    this.parked.some(({ run }) => run.nowUs >= fromUs && run.nowUs <= toUs);

  /**
   * Gives a run that is at a time, or before the first line for 0. The caller must park it again.
   *
   * @param mayGoOn called between slices; if it returns false, `Overtaken` is thrown
   */
  async at(us: number, mayGoOn: () => boolean): Promise<Simulation> {
    const before = this.parked.filter(({ run }) => run.nowUs <= us);
    const [nearest] = before.sort((one, other) => other.run.nowUs - one.run.nowUs);
    this.parked = this.parked.filter((other) => other !== nearest);
    const run = nearest?.run ?? (await this.create());
    try {
      await this.advance(run, us, mayGoOn);
    } catch (error) {
      this.park(run);
      throw error;
    }
    return run;
  }

  private create(): Promise<Simulation> {
    return Simulation.create(this.setup, this.firmware, { set: this.causes.listener() });
  }

  /** Runs a run until a time, or until its rule stops it. */
  async advance(run: Simulation, us: number, mayGoOn: () => boolean): Promise<void> {
    let pieceUs = PIECE_US;
    let sliceMs = this.bench.nowMs();
    while (run.nowUs < us) {
      const startMs = this.bench.nowMs();
      run.advanceTo(Math.min(us, run.nowUs + pieceUs));
      if (run.heldBy === null) this.causes.reached(run.nowUs);
      if (run.heldBy !== null) return;
      const endMs = this.bench.nowMs();
      if (endMs - startMs < SLICE_MS / 4) pieceUs = Math.min(2 * pieceUs, MOST_PIECE_US);
      else if (endMs - startMs > SLICE_MS) pieceUs = Math.max(pieceUs / 4, LEAST_PIECE_US);
      if (endMs - sliceMs < SLICE_MS) continue;
      await this.bench.rest();
      if (!mayGoOn()) throw new Overtaken();
      sliceMs = this.bench.nowMs();
    }
  }

  /** Takes out the run that is parked at a moment; `null`: there is none. */
  standing({ device, timeUs, isLine }: Instant): Simulation | null {
    const found = this.parked.find(({ at }) => at?.device === device && at.timeUs === timeUs && at.isLine === isLine);
    this.parked = this.parked.filter((other) => other !== found);
    return found?.run ?? null;
  }

  /** Parks a run to continue from, and drops the oldest if there are too many. @param at the moment it is at */
  park(run: Simulation, at: Instant | null = null): void {
    for (const device of run.endings.keys()) run.watch(null, device);
    const all = [...this.parked, { run, at }];
    for (const old of all.slice(0, -MOST_PARKED)) old.run.dispose();
    this.parked = all.slice(-MOST_PARKED);
  }

  dispose(): void {
    for (const { run } of this.parked) run.dispose();
    this.parked = [];
  }
}
