/**
 * An infrared receiver such as the VS1838B: its output is high while no remote control is heard, and goes low in
 * bursts of 38 kHz. Source: Vishay TSOP38238 data sheet, block diagram (output transistor with a pull-up resistor).
 */
import type { Wire } from '#board/wires/wire';
import type { Stop } from '#core/stop';

/** Puts a receiver on a wire, in a room without remote controls: it only holds the wire up. */
export function attachIrReceiver(wire: Wire): Stop {
  const output = wire.connect('infrared receiver');
  output.pull('up');
  return output.detach;
}
