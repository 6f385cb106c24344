import { limits } from './limits';

/** What a message costs besides what it says, in characters: a thousand of them a second at most. */
const MESSAGE_CHARACTERS = 200;

/**
 * How much of one kind of news may be sent to a host: a second's worth at once, and it fills up with time. Of what comes
 * faster the end is left out and counted.
 */
export class Allowance {
  /** How much was left out since somebody last took the count. */
  private omitted = 0;
  private room: number = limits.outputCharactersPerSecond;

  /** @param atMs wall clock now */
  constructor(private atMs: number) {}

  /** Whether something was left out that nobody was told of. */
  get hasOmitted(): boolean {
    return this.omitted > 0;
  }

  /** The next piece comes: whether there is room for a message at all. @param nowMs wall clock now */
  hasRoom(nowMs: number): boolean {
    const { outputCharactersPerSecond: most } = limits;
    const passedMs = Math.max(0, nowMs - this.atMs);
    this.atMs = nowMs;
    this.room = Math.min(most, this.room + (passedMs / 1000) * most);
    return this.room >= MESSAGE_CHARACTERS;
  }

  /** Takes room for so many characters. @returns false: there is too little */
  take(characters: number): boolean {
    if (this.room - MESSAGE_CHARACTERS < characters) return false;
    this.room -= characters;
    return true;
  }

  /** So much is left out. */
  omit(count: number): void {
    this.omitted += count;
  }

  /** A message is sent. @returns the field that counts what was left out before it; none where that is nothing */
  send(): { readonly omitted?: number } {
    const { omitted } = this;
    this.omitted = 0;
    this.room -= MESSAGE_CHARACTERS;
    return omitted > 0 ? { omitted } : {};
  }
}
