/**
 * A chain of WS2812 colour LEDs on one wire.
 *
 * Source: Worldsemi WS2812B datasheet, "Composition of 24 bit data": green, red, blue, one byte each, most significant
 * bit first; each LED keeps the first 24 bits it receives after a reset and passes the rest on.
 */
import type { Wire } from '#board/wires/wire';
import type { Rgb } from '#core/rgb';
import type { Stop } from '#core/stop';

const BYTES_PER_LED = 3;
const DARK: Rgb = [0, 0, 0];

/** The chain as its owner sees it. */
export interface Ws2812Chain {
  /** The colours shown now, the LED next to the data pin first. A new array each time. */
  colors(): Rgb[];
  readonly stop: Stop;
}

/**
 * Attaches `count` LEDs to a wire, all dark. A stream for fewer LEDs leaves the others as they are, one for more is
 * lost at the chain's end; an LED that gets only a part of its three bytes keeps its colour.
 *
 * @param tell called for each LED that gets a colour, even if it is the same as before
 */
export function attachWs2812(
  wire: Wire,
  count: number,
  tell: (led: number, color: Rgb) => void = () => undefined,
): Ws2812Chain {
  const colors: Rgb[] = Array.from({ length: count }, () => DARK);
  const stop = wire.onStream((bytes) => {
    const complete = Math.min(count, Math.floor(bytes.length / BYTES_PER_LED));
    for (let led = 0; led < complete; led++) {
      const [green = 0, red = 0, blue = 0] = bytes.subarray(led * BYTES_PER_LED, (led + 1) * BYTES_PER_LED);
      colors[led] = [red, green, blue];
      tell(led, [red, green, blue]);
    }
  });
  return { colors: () => [...colors], stop };
}
