import type { Rgb } from '#core/rgb';
import type { Wire } from '../wires/wire';

const BYTES_PER_LED = 3;
const DARK: Rgb = [0, 0, 0];

/**
 * RGB LEDs soldered to the board, on a one-wire stream. They take the bytes in the order green, red, blue and show
 * their colours until the next stream; a stream that is too short leaves the other LEDs as they were. Source: WS2812B
 * datasheet, "Composition of 24bit data"; the Calliope mini 3 carries three of them.
 */
export class RgbLeds {
  private leds: readonly Rgb[];

  constructor(wire: Wire, count: number) {
    this.leds = Array.from({ length: count }, () => DARK);
    wire.onStream((bytes) => this.take(bytes));
  }

  /** The first is the one next to the pin. A new list after each change. */
  get colors(): readonly Rgb[] {
    return this.leds;
  }

  /** Dark, as the firmware leaves them when it starts. */
  reset(): void {
    this.leds = this.leds.map(() => DARK);
  }

  private take(bytes: Uint8Array): void {
    this.leds = this.leds.map((before, place): Rgb => {
      const [green, red, blue] = bytes.subarray(place * BYTES_PER_LED, (place + 1) * BYTES_PER_LED);
      return green === undefined || red === undefined || blue === undefined ? before : [red, green, blue];
    });
  }
}
