import type { Cleaned, Firmware } from './firmware';
import { firmwareOf } from './image';
import { layoutOf } from './layout';
import { parseHex } from './parse';
import { isMakeCode } from './read';

/** The MicroPython in any hex of one's own board, without the files in it. */
export function cleanFirmware(text: string): Cleaned {
  const parsed = parseHex(text);
  if ('problem' in parsed) return parsed;
  const firmwares: Firmware[] = [];
  for (const { regions } of parsed.parts) {
    const layout = layoutOf(regions);
    if (layout !== null) firmwares.push(firmwareOf(regions, layout));
  }
  if (firmwares.length > 0) return { firmwares };
  return { problem: { code: isMakeCode(text, parsed) ? 'makecode' : 'no-python' } };
}
