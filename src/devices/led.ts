/** A plain LED between a wire and ground: lit while the wire is high, dimmed by PWM. */
import type { Wire } from '#board/wires/wire';

/** The LED as its owner sees it. */
export interface Led {
  /** 1 while it shines, however weakly, else 0. */
  isLit(): 0 | 1;
}

/** Puts an LED on a wire. It draws nothing and drives nothing, so there is nothing to detach. */
export function ledOn(wire: Wire): Led {
  return { isLit: () => (wire.fraction > 0 ? 1 : 0) };
}
