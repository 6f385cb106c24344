/** A share of a step, above 0 up to 1, through which a motor ran at one duty, −1 … 1. */
export interface PowerPiece {
  readonly share: number;
  readonly duty: number;
}

/**
 * The duty of one motor through a step of the world. A program sets it at any moment; what the motor does within the
 * step follows from all its duties, each with the share of the step for which it held.
 */
export class Power {
  private now = 0;
  /** Share of the step that was over when the present duty began. */
  private since = 0;
  private before: PowerPiece[] = [];

  /** The duty as last set. */
  get duty(): number {
    return this.now;
  }

  /** True if it is the same through all of this step. */
  get isSteady(): boolean {
    return this.since === 0;
  }

  /** True if the motor drives at some moment of this step. */
  get isOn(): boolean {
    return this.now !== 0 || !this.isSteady;
  }

  /** @param at share of the step that is over, from 0, below 1, never less than the last time */
  set(duty: number, at: number): void {
    if (duty === this.now) return;
    if (at > this.since) this.before.push({ share: at - this.since, duty: this.now });
    this.now = duty;
    this.since = at;
  }

  /** The duties of this step, from its beginning. */
  pieces(): readonly PowerPiece[] {
    return [...this.before, { share: 1 - this.since, duty: this.now }];
  }

  /** The next step begins. */
  beginStep(): void {
    if (this.isSteady) return;
    this.since = 0;
    this.before = [];
  }
}
