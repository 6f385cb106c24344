/** The power state of the board. */
export type PowerState = 'on' | 'asleep' | 'off';

/** Something that can wake a sleeping board: a pin, a button, the serial line. */
export interface WakeSource {
  /** Called when the board falls asleep; returns a function that becomes true to wake the board. */
  arm(): () => boolean;
}

/** Deep sleep and off. While the board is not on, its LEDs are dark. */
export class Power {
  private current: PowerState = 'on';

  /** @param darken called with whether the LEDs are dark */
  constructor(private readonly darken: (isDark: boolean) => void) {}

  get state(): PowerState {
    return this.current;
  }

  /** Falls asleep. @returns a function that becomes true when one of the sources wants to wake the board */
  sleep(sources: readonly WakeSource[]): () => boolean {
    this.become('asleep');
    const wakes = sources.map((source) => source.arm());
    return () => wakes.some((wants) => wants());
  }

  /** Wakes up from sleep; a board that is off stays off. */
  wake(): void {
    if (this.current === 'asleep') this.become('on');
  }

  /** Switches the board off until a reset. */
  off(): void {
    this.become('off');
  }

  /** Back to the state after a start: on. */
  reset(): void {
    this.become('on');
  }

  private become(state: PowerState): void {
    this.current = state;
    this.darken(state !== 'on');
  }
}
