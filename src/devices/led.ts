/** A plain LED between a wire and ground: lit while the wire is high, dimmed by PWM. */
import type { Wire } from '#board/wire';

/** The LED as its owner sees it. */
export interface Led {
  /** Brightness, 0 (dark) … 1 (fully lit): the mean voltage on the wire as a fraction of the supply. */
  brightness(): number;
  /** 1 while it shines, however weakly, else 0. */
  isLit(): 0 | 1;
}

/** Puts an LED on a wire. It draws nothing and drives nothing, so there is nothing to detach. */
export function ledOn(wire: Wire): Led {
  return {
    brightness: () => wire.fraction,
    isLit: () => (wire.fraction > 0 ? 1 : 0),
  };
}
