import type { Clock } from '#core/clock';

/** Access of one participant to the ticks. */
export interface TickSlot {
  /** Requests ticks from the next one on, until `tick` says that it needs no more. */
  wake(): void;
}

/**
 * A periodic interrupt of the board. It ticks at whole multiples of its period since the start of the run. An alarm is
 * set only while a participant needs ticks; the result is the same.
 */
export class TickGrid {
  private readonly slots: { awake: boolean; readonly tick: () => boolean }[] = [];
  private armed = false;

  constructor(
    private readonly clock: Clock,
    private readonly periodUs: number,
  ) {}

  /**
   * Adds a participant; participants tick in the order in which they joined (rule T4).
   *
   * @param tick one tick; returns whether it needs the next one too
   */
  join(tick: () => boolean): TickSlot {
    const slot = { awake: false, tick };
    this.slots.push(slot);
    return {
      wake: () => {
        slot.awake = true;
        this.arm();
      },
    };
  }

  private arm(): void {
    if (this.armed) return;
    this.armed = true;
    const next = (Math.floor(this.clock.nowUs / this.periodUs) + 1) * this.periodUs;
    this.clock.at(next, () => {
      this.armed = false;
      const due = this.slots.filter((slot) => slot.awake); // a participant woken by a tick waits for the next one (rule T3)
      for (const slot of due) slot.awake = false;
      for (const slot of due) if (slot.tick()) slot.awake = true;
      if (this.slots.some((slot) => slot.awake)) this.arm();
    });
  }
}
