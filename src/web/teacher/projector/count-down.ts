import { computed, shallowRef, type ComputedRef, type ShallowRef } from 'vue';

/** The clock on the wall, with alarms. */
export interface WallClock {
  /** In ms. It goes on while a laptop sleeps. */
  now(): number;
  /** Calls `act` after this time. @returns a function that calls it off */
  after(ms: number, act: () => void): () => void;
}

/** The part of a timer that outlasts a reload. */
export interface KeptTimer {
  /** The set time, in ms. */
  readonly setMs: number;
  /** The remaining time while it is paused, in ms. */
  readonly leftMs: number;
  /** Time of its end by the clock on the wall, in ms; `null`: it is not running. */
  readonly endsMs: number | null;
}

/** `ready`: not running, and nothing of the set time has passed. */
export type TimerPhase = 'ready' | 'running' | 'paused' | 'over';

const MINUTE_MS = 60_000;
/** Longest time, in ms: its digits are four. */
const MOST_MS = 99 * MINUTE_MS;
/** Chosen: what a class gets for a small task. */
const FIRST: KeptTimer = { setMs: 10 * MINUTE_MS, leftMs: 10 * MINUTE_MS, endsMs: null };

/** Counts down the time that a teacher gives a class, by the clock on the wall: it has nothing to do with a run. */
export class CountDown {
  private readonly kept: ShallowRef<KeptTimer>;
  private readonly left: ShallowRef<number>;
  /** Whole seconds that are left. The last one shows until it is over. */
  readonly seconds: ComputedRef<number> = computed(() => Math.ceil(this.left.value / 1000));
  readonly phase: ComputedRef<TimerPhase> = computed(() => {
    const { setMs, leftMs, endsMs } = this.kept.value;
    if (this.left.value === 0) return 'over';
    if (endsMs !== null) return 'running';
    return leftMs === setMs ? 'ready' : 'paused';
  });
  private callOff: () => void = () => undefined;

  /**
   * @param kept its state before a reload
   * @param keep called after every change but that of the time that passes
   * @param onOver called when it has just come to its end
   */
  constructor(
    private readonly clock: WallClock,
    kept: KeptTimer | null = null,
    private readonly keep: (timer: KeptTimer) => void = () => undefined,
    private readonly onOver: () => void = () => undefined,
  ) {
    this.kept = shallowRef(kept ?? FIRST);
    this.left = shallowRef(this.leftNow());
    this.goOn();
  }

  /** Sets the timer to a number of minutes, 1 to 99, and stops it. */
  set(minutes: number): void {
    const setMs = limited(minutes * MINUTE_MS);
    this.change({ setMs, leftMs: setMs, endsMs: null });
  }

  /**
   * Adds minutes to the set time while it is ready, else to the time that is left. After its end it runs on with them.
   */
  add(minutes: number): void {
    const { setMs } = this.kept.value;
    if (this.phase.value === 'ready') {
      this.set(setMs / MINUTE_MS + minutes);
      return;
    }
    const leftMs = Math.min(MOST_MS, Math.max(0, this.leftNow() + minutes * MINUTE_MS));
    const isOn = this.phase.value !== 'paused';
    this.change({ setMs, leftMs, endsMs: isOn ? this.clock.now() + leftMs : null });
  }

  start(): void {
    if (this.phase.value !== 'ready' && this.phase.value !== 'paused') return;
    this.change({ ...this.kept.value, endsMs: this.clock.now() + this.kept.value.leftMs });
  }

  pause(): void {
    if (this.phase.value === 'running') this.change({ ...this.kept.value, leftMs: this.leftNow(), endsMs: null });
  }

  /** Sets the timer back to the set time, and stops it. */
  reset(): void {
    const { setMs } = this.kept.value;
    this.change({ setMs, leftMs: setMs, endsMs: null });
  }

  private change(kept: KeptTimer): void {
    this.kept.value = kept;
    this.left.value = this.leftNow();
    this.keep(kept);
    this.goOn();
  }

  /** Looks again when the next second is over. */
  private goOn(): void {
    this.callOff();
    if (this.phase.value !== 'running') return;
    this.callOff = this.clock.after(this.left.value % 1000 || 1000, () => {
      this.left.value = this.leftNow();
      this.goOn();
      if (this.phase.value === 'over') this.onOver();
    });
  }

  private leftNow(): number {
    const { leftMs, endsMs } = this.kept.value;
    return endsMs === null ? leftMs : Math.max(0, endsMs - this.clock.now());
  }
}

const limited = (ms: number): number => Math.min(MOST_MS, Math.max(MINUTE_MS, ms));

/** Minutes and seconds: `9:05`. */
export const digitsOf = (seconds: number): string =>
  `${String(Math.floor(seconds / 60))}:${String(seconds % 60).padStart(2, '0')}`;
