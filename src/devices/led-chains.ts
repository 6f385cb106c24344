/**
 * Chains of WS2812 LEDs plugged onto free pins: rings, strips, matrices. Nothing declares them; they appear when a
 * program sends them bytes.
 *
 * Bytes as in `ws2812.ts`. A chain is as long as the longest stream sent to it since the start.
 */
import type { Wire } from '#board/wires/wire';
import type { Rgb } from '#core/rgb';
import type { Stop } from '#core/stop';

/** The colours of one chain, as plain data. */
export interface LedChain {
  /** Name of its wire, e.g. `P2`. */
  readonly pin: string;
  /** The LED next to the pin first; as long as the chain. The same array until something new is sent. */
  readonly colors: readonly Rgb[];
}

/** The chains found so far. */
export interface LedChains {
  /** In the order of the wires; the same array until something new is sent. */
  chains(): readonly LedChain[];
  readonly stop: Stop;
}

/** Chosen: a matrix of 32 × 32. More would be lost in a drawing, and takes 30 ms to send. */
export const LONGEST_CHAIN = 1024;

const BYTES_PER_LED = 3;

/**
 * Shows a chain on each of these wires as soon as a stream for at least one LED arrives there. If something else
 * listens for streams on the wire, the LEDs belong to a robot or to the board, and no chain is shown.
 */
export function watchLedChains(wires: readonly Wire[]): LedChains {
  const watched = [...new Set(wires)].map(watchWire);
  let shown: readonly LedChain[] = [];
  return {
    chains() {
      const now = watched.flatMap((wire) => wire.chain() ?? []);
      if (now.length !== shown.length || now.some((chain, i) => chain !== shown[i])) shown = now;
      return shown;
    },
    stop: () => watched.forEach(({ stop }) => stop()),
  };
}

interface WatchedWire {
  /** `null` until something is sent. */
  chain(): LedChain | null;
  readonly stop: Stop;
}

/** Keeps the bytes as they come and converts them to colours only on request. */
function watchWire(wire: Wire): WatchedWire {
  let bytes = new Uint8Array(0);
  let shown: LedChain | null = null;
  const stop = wire.onStream((stream) => {
    if (wire.streamListenerCount > 1) return;
    const whole = Math.min(LONGEST_CHAIN, Math.floor(stream.length / BYTES_PER_LED)) * BYTES_PER_LED;
    if (whole === 0) return;
    if (whole > bytes.length) {
      const longer = new Uint8Array(whole);
      longer.set(bytes);
      bytes = longer;
    }
    bytes.set(stream.subarray(0, whole));
    shown = null;
  });
  return {
    chain() {
      if (bytes.length > 0) shown ??= { pin: wire.name, colors: colorsOf(bytes) };
      return shown;
    },
    stop,
  };
}

function colorsOf(bytes: Uint8Array): Rgb[] {
  return Array.from({ length: bytes.length / BYTES_PER_LED }, (_, led): Rgb => {
    const [green = 0, red = 0, blue = 0] = bytes.subarray(led * BYTES_PER_LED, (led + 1) * BYTES_PER_LED);
    return [red, green, blue];
  });
}
