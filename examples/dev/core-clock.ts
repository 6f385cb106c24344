import { Clock } from '#core/clock';
import { createRng } from '#core/rng';

import type { Print } from './example';

/** core: simulated time without waiting. A dice is thrown every second; the same seed throws the same numbers everywhere. */
export function main(print: Print): void {
  const clock = new Clock();
  const rng = createRng(7);
  const stop = clock.every(1_000_000, () => print(`${clock.nowUs / 1_000_000} s: ${Math.floor(rng.unit() * 6) + 1}`));
  clock.at(3_500_000, () => {
    print('enough');
    stop();
  });
  clock.advanceTo(10_000_000);
}
