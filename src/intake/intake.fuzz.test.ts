import { describe, expect, it } from 'vitest';

import { createRng, type Rng } from '#core/rng';
import { fuzzRuns } from '#core/testing/fuzz-runs';
import { documentOfAddress, documentOfSeriesLink } from './address';
import { handInOfBytes } from './contents';
import { documentOf, openGiven } from './file';
import { seriesLinkIn, taskLinksIn } from './links';
import { contentOf, givenFile } from './sources';
import { seriesAmong, tasksAmong } from './series-among';
import { addresses, samples } from './testing/samples';

/** Only against an endless loop. */
const TIME_LIMIT_MS = 60_000 + 20 * fuzzRuns;

const ENDINGS = ['py', 'json', 'zip', 'html', 'csv', 'txt', 'eml', 'md', 'tsv', 'xlsx', 'png', 'hex', ''];
const pick = <T>(all: readonly T[], rng: Rng): T => all[Math.floor(rng.unit() * all.length)]!;
const none = () => null;

/** A few bytes of something that is read, changed, cut off or with noise behind. */
function changed(bytes: Uint8Array, rng: Rng): Uint8Array {
  const made = [...bytes.subarray(0, rng.unit() < 0.3 ? Math.floor(rng.unit() * bytes.length) : bytes.length)];
  for (let left = Math.floor(rng.unit() * 8) - 3; left > 0; left -= 1)
    made[Math.floor(rng.unit() * (made.length + 1))] = Math.floor(rng.unit() * 256);
  return Uint8Array.from(made, (byte) => byte ?? 0);
}

describe('whatever comes in', () => {
  it(
    `is some document, never an exception (${String(fuzzRuns)} files)`,
    async () => {
      const kinds = new Map<string, number>();
      for (let seed = 1; seed <= fuzzRuns; seed += 1) {
        const rng = createRng(seed);
        const { name, bytes } = pick(samples, rng);
        const noise = Uint8Array.from({ length: Math.floor(rng.unit() * 300) }, () => Math.floor(rng.unit() * 256));
        const content = rng.unit() < 0.2 ? noise : changed(bytes, rng);
        const called = rng.unit() < 0.3 ? `x.${pick(ENDINGS, rng)}` : name;
        const { kind } = await documentOf(called, content, none);
        kinds.set(kind, (kinds.get(kind) ?? 0) + 1);
        const said = await handInOfBytes(called, content, none);
        expect('handIn' in said || said.problem.code !== 'broken', `seed ${String(seed)}`).toBe(true);
        const opened = await openGiven({ path: called, size: content.length, read: () => ({ bytes: content }) });
        const { sources } = await givenFile(opened, none, true);
        for (const source of sources.slice(0, 5)) await contentOf(source);
        await seriesAmong([opened], none);
        await tasksAmong([opened], none);
      }
      for (const kind of [
        'program',
        'hex',
        'project',
        'course',
        'series',
        'recording',
        'zip',
        'links',
        'log',
        'picture',
        'unreadable',
      ])
        // prettier-ignore
        expect(kinds.get(kind) ?? 0, kind).toBeGreaterThan(fuzzRuns / 200);
    },
    TIME_LIMIT_MS,
  );

  it(
    `is some address, never an exception (${String(fuzzRuns)} addresses)`,
    () => {
      for (let seed = 1; seed <= fuzzRuns; seed += 1) {
        const rng = createRng(seed);
        const bytes = changed(new TextEncoder().encode(pick(Object.values(addresses), rng)), rng);
        const text = new TextDecoder().decode(bytes);
        const document = documentOfAddress(text, none);
        if (document.kind === 'series-link') documentOfSeriesLink(document.link, none);
        expect([seriesLinkIn(text) ?? '', taskLinksIn(text).length], `seed ${String(seed)}`).toHaveLength(2);
      }
    },
    TIME_LIMIT_MS,
  );
});
