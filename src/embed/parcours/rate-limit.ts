import { limits } from './limits';

/** Cost of a message besides its content, in characters: a thousand of them a second at most. */
const MESSAGE_CHARACTERS = 200;

/**
 * Rate limit for one kind of event to a host: one second's worth at once, refilled over time. Whatever comes faster is
 * left out and counted.
 */
export class RateLimit {
  /** Number left out since the last count was taken. */
  private omitted = 0;
  private room: number = limits.outputCharactersPerSecond;

  /** @param atMs wall clock now */
  constructor(private atMs: number) {}

  /** True if something was left out that was not reported yet. */
  get hasOmitted(): boolean {
    return this.omitted > 0;
  }

  /** Prepares for the next piece: whether there is room for a message at all. @param nowMs wall clock now */
  hasRoom(nowMs: number): boolean {
    const { outputCharactersPerSecond: most } = limits;
    const passedMs = Math.max(0, nowMs - this.atMs);
    this.atMs = nowMs;
    this.room = Math.min(most, this.room + (passedMs / 1000) * most);
    return this.room >= MESSAGE_CHARACTERS;
  }

  /** Takes room for this many characters. @returns false if there is too little */
  take(characters: number): boolean {
    if (this.room - MESSAGE_CHARACTERS < characters) return false;
    this.room -= characters;
    return true;
  }

  /** Counts what is left out. */
  omit(count: number): void {
    this.omitted += count;
  }

  /** A message is sent. @returns the field with the number left out before it; empty if that is 0 */
  send(): { readonly omitted?: number } {
    const { omitted } = this;
    this.omitted = 0;
    this.room -= MESSAGE_CHARACTERS;
    return omitted > 0 ? { omitted } : {};
  }
}
