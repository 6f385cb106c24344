import type { TickGrid, TickSlot } from '../tick-grid';

const SIGMA_MAX = 12; // codal-core Button.h: DEVICE_BUTTON_SIGMA_MAX
const SIGMA_ON = 8; // DEVICE_BUTTON_SIGMA_THRESH_HI: on above it
const SIGMA_OFF = 2; // DEVICE_BUTTON_SIGMA_THRESH_LO: off below it

/**
 * The device's lazy follower of a contact: a sum that rises by one per sample while the contact is closed and falls
 * while it is open. Sampled every 4 ms it switches on 36 ms after the contact closes and off 44 ms after it opens.
 * Source: codal-core Button.cpp, periodicCallback.
 */
export class Debounce {
  private readonly slot: TickSlot;
  private sigma = 0;
  private on = false;
  private was = false;
  private count = 0;

  constructor(
    grid: TickGrid,
    private readonly isClosed: () => boolean,
  ) {
    this.slot = grid.join(() => this.sample());
  }

  /** Call it whenever the contact may have changed. */
  changed(): void {
    this.slot.wake();
  }

  /** Forgets what it has seen; a contact that is still closed switches on again. */
  reset(): void {
    this.sigma = 0;
    this.on = false;
    this.was = false;
    this.count = 0;
    this.slot.wake();
  }

  get isOn(): boolean {
    return this.on;
  }

  /** True if it switched on since the last call. Does not change the count. */
  wasOn(): boolean {
    const was = this.was;
    this.was = false;
    return was;
  }

  /** Number of times it switched on since the last call. Does not change `wasOn`. */
  takeCount(): number {
    const count = this.count;
    this.count = 0;
    return count;
  }

  private sample(): boolean {
    const closed = this.isClosed();
    this.sigma = closed ? Math.min(SIGMA_MAX, this.sigma + 1) : Math.max(0, this.sigma - 1);
    if (!this.on && this.sigma > SIGMA_ON) {
      this.on = true;
      this.was = true;
      this.count++;
    } else if (this.on && this.sigma < SIGMA_OFF) {
      this.on = false;
    }
    return this.sigma !== (closed ? SIGMA_MAX : 0);
  }
}
