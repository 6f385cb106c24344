import { checkForDevice } from '#device-check/check-for-device';

import type { Print } from './example';

/** device-check: what runs here and not on a micro:bit with MicroPython 1.18. */
export function main(print: Print): void {
  const program = 'name = "Ada"\nprint(f"hello {name}")\n';
  for (const { line, column, rule } of checkForDevice(
    { 'main.py': program },
    { features: [], micropython: [1, 18, 0] },
  ))
    print(`line ${line}, column ${column}: ${rule}`);
}
