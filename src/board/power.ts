/** Whether the board works. */
export type PowerState = 'on' | 'asleep' | 'off';

/** What can wake a board that sleeps: a pin or a button. */
export interface WakeSource {
  /** To be asked when the board falls asleep; gives a question that is true as soon as it wants to wake the board. */
  arm(): () => boolean;
}

/** Deep sleep and off. While it is not on, its LEDs are dark. */
export class Power {
  private current: PowerState = 'on';

  /** @param darken is told whether the LEDs are to be dark */
  constructor(private readonly darken: (isDark: boolean) => void) {}

  get state(): PowerState {
    return this.current;
  }

  /** Falls asleep. @returns a question that is true as soon as one of the sources wants to wake the board */
  sleep(sources: readonly WakeSource[]): () => boolean {
    this.become('asleep');
    const wakes = sources.map((source) => source.arm());
    return () => wakes.some((wants) => wants());
  }

  /** Wakes up from sleep; a board that is off stays off. */
  wake(): void {
    if (this.current === 'asleep') this.become('on');
  }

  /** Until a reset. */
  off(): void {
    this.become('off');
  }

  /** As after a start: on. */
  reset(): void {
    this.become('on');
  }

  private become(state: PowerState): void {
    this.current = state;
    this.darken(state !== 'on');
  }
}
