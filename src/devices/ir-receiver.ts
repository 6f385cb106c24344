/**
 * An infrared receiver such as the VS1838B: its output is high while no remote control is heard, and low during each
 * burst of 38 kHz. Source: Vishay TSOP38238 data sheet, block diagram (output transistor with a pull-up resistor). A real
 * one is late by some 10 periods of the carrier at both edges, which leaves the lengths as they are.
 */
import type { Wire } from '#board/wires/wire';
import type { Stop } from '#core/stop';
import type { InfraredLight } from './nec-remote';

/** Puts a receiver on a wire. */
export function attachIrReceiver(wire: Wire, light: InfraredLight): Stop {
  const output = wire.connect('infrared receiver');
  output.pull('up');
  const deafen = light.onBurst((isOn) => (isOn ? output.drive(0) : output.release()));
  return () => {
    deafen();
    output.detach();
  };
}
