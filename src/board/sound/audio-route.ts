import { busyMessage, type Pin, type PinMode } from '../wires/pin';

/**
 * The pin that carries the sound besides the speaker: one for music, audio and speech together. Source:
 * micropython-microbit-v2 microbit_pinaudio.c.
 */
export class AudioRoute {
  private pin: Pin | null = null;
  private mode: PinMode = 'unused';

  constructor(private readonly changed: (pin: Pin | null) => void) {}

  /** The pin that the sound still owns, or `null`. Freeing the pin or taking it for another use ends the ownership. */
  get current(): Pin | null {
    if (this.pin && this.pin.mode !== this.mode) this.leave();
    return this.pin;
  }

  /**
   * Sends the sound to this pin, or to none, and gives back the pin that had it.
   *
   * @param mode `music` reserves the pin, `audio` lets other uses take it
   * @returns `null`, or the device's ValueError if the pin is reserved; the sound then has no pin
   */
  select(pin: Pin | null, mode: 'music' | 'audio'): string | null {
    const problem = this.take(pin, mode);
    if (problem !== null) return problem;
    this.mode = mode;
    if (pin !== this.pin) {
      this.pin = pin;
      this.changed(pin);
    }
    return null;
  }

  /**
   * Gives back the pin that has the sound, and this one, as if it had been taken for music before.
   *
   * @returns `null`, or the device's ValueError if the pin is held
   */
  giveBack(pin: Pin | null): string | null {
    const problem = this.take(pin, 'music');
    if (problem !== null) return problem;
    pin?.free();
    if (this.pin) this.leave();
    return null;
  }

  /** Gives the pin back. */
  free(): void {
    const pin = this.current;
    if (!pin) return;
    pin.free();
    this.leave();
  }

  /** Puts a tone's square wave on the pin, or silence. */
  playTone(periodUs: number | null): void {
    if (this.mode === 'music') this.current?.playTone(periodUs);
  }

  /**
   * Takes a pin; the previous pin of the sound is released. @returns `null`, or the error message if the pin is
   * reserved
   */
  private take(pin: Pin | null, mode: 'music' | 'audio'): string | null {
    const before = this.current;
    if (before && (pin !== before || this.mode !== mode)) this.free();
    const holder = pin?.acquire(mode) ?? null;
    return pin && holder ? busyMessage(pin, holder) : null;
  }

  private leave(): void {
    this.pin = null;
    this.changed(null);
  }
}
