import { describe, expect, it } from 'vitest';
import { createRng } from '#core/rng';
import { fuzzRuns } from '#core/testing/fuzz-runs';
import { mutatedText } from '#scene/testing/mutate';
import { cleanFirmware } from './clean';
import { makeHex } from './make';
import { readHex } from './read';
import { appended, firmwareRegions, firmwareText, hexText, makeCodeText, record } from './testing/firmware';

/** Only against an endless loop. */
const TIME_LIMIT_MS = 60_000 + 20 * fuzzRuns;

/** A hex has a thousand lines: fewer are read than of other files. */
const runs = Math.ceil(fuzzRuns / 10);

/** A hex with files, in which every line is whole again after a change of a byte: the change itself must be borne. */
function changedInside(text: string, rng: { unit(): number }): string {
  const lines = text.split('\n');
  for (let times = 0; times < 5; times++) {
    const place = Math.floor(rng.unit() * lines.length);
    const [, offset, type, data] = /^:..(....)(..)(.*)..$/.exec(lines[place] ?? '') ?? [];
    if (data === undefined || data === '') continue;
    const bytes = (data.match(/../g) ?? []).map((digits) => parseInt(digits, 16));
    bytes[Math.floor(rng.unit() * bytes.length)] = Math.floor(rng.unit() * 256);
    lines[place] = record(parseInt(type ?? '0', 16), parseInt(offset ?? '0', 16), bytes);
  }
  return lines.join('\n');
}

describe('randomly changed hexes', () => {
  it(
    `are read or refused, never an exception (${String(runs)} files)`,
    () => {
      const cleaned = cleanFirmware(firmwareText('microbit-v2'));
      const made = makeHex('firmwares' in cleaned ? cleaned.firmwares : [], [{ name: 'main.py', text: 'x = 1\n'.repeat(99) }]); // prettier-ignore
      const old = hexText([...firmwareRegions('microbit-v1').slice(0, 1), appended('x'), ...firmwareRegions('microbit-v1').slice(1)]); // prettier-ignore
      const texts = [
        made.kind === 'hex' ? made.text.slice(made.text.indexOf('FE307F59') - 200) : '',
        old,
        makeCodeText(),
      ];
      const whole = made.kind === 'hex' ? made.text : '';
      const kinds = new Set<string>();
      for (let seed = 1; seed <= runs; seed += 1) {
        const rng = createRng(seed);
        const text = seed % 2 === 0 ? changedInside(whole, rng) : mutatedText(texts[seed % 3] ?? '', rng);
        const read = readHex(text);
        kinds.add(read.kind === 'hex' ? read.made : read.problem.code);
        const firmware = cleanFirmware(text);
        if ('firmwares' in firmware)
          for (const { roomBytes } of firmware.firmwares) expect(roomBytes).toBeGreaterThan(0);
      }
      expect([...kinds]).toEqual(expect.arrayContaining(['micropython', 'line']));
    },
    TIME_LIMIT_MS,
  );
});
