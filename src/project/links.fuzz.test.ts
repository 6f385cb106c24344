import LZString from 'lz-string';
import { describe, expect, it } from 'vitest';

import { createRng, type Rng } from '#core/rng';

import { fromBase64Url } from './base64';
import { packed, unpacked } from './deflate';
import { linkOf, linkOfBytes, projectOfLink, UNPACKED_BYTES } from './link';
import { mutatedBytes, mutatedText } from './testing/mutate';
import { fullProject, largeProject, penTrack } from './testing/projects';
import { programOfLink } from './webtigerpython';
import { LIKELY_WORDS } from './words';

/** How many links are tried: `npm run fuzz` tries a million. */
const RUNS = Number(process.env['FUZZ_RUNS'] ?? 10_000);
/** Against an endless loop only. */
const TIME_LIMIT_MS = 60_000 + 20 * RUNS;

const courses = (): null => null;
const linkFor = (project: Parameters<typeof linkOf>[0]): string =>
  linkOf(project, { courses, program: true })?.fragment ?? '';

/** The parts of a link as it holds them. */
function partsOf(link: string): { figures: Uint8Array; words: Uint8Array } {
  const all = fromBase64Url(link.slice(4)) ?? new Uint8Array();
  const end = 7 + (all[4] ?? 0) + 256 * (all[5] ?? 0);
  const figures = unpacked(all.subarray(7, end), UNPACKED_BYTES);
  const words = unpacked(all.subarray(end), UNPACKED_BYTES, LIKELY_WORDS);
  if (typeof figures === 'string' || typeof words === 'string') throw new Error('not a whole link');
  return { figures, words };
}

/** A link whose checksum is right although what it holds is not. */
function forged(parts: ReturnType<typeof partsOf>, rng: Rng): string {
  const { figures, words } = parts;
  return rng.unit() < 0.7
    ? linkOfBytes({ figures: mutatedBytes(figures, rng), words })
    : linkOfBytes({ figures, words: mutatedBytes(words, rng) });
}

describe('randomly changed links', () => {
  it(
    `open as a valid project or give a message, never an exception (${String(RUNS)} links)`,
    () => {
      const links = [linkFor(fullProject()), linkFor({ ...fullProject(), scene: largeProject(penTrack().slice(0, 99)).scene })]; // prettier-ignore
      const parts = links.map(partsOf);
      const codes = new Map<string, number>();
      for (let seed = 1; seed <= RUNS; seed += 1) {
        const rng = createRng(seed);
        const index = seed % 2;
        const isForged = rng.unit() < 0.7;
        const link = isForged ? forged(parts[index]!, rng) : mutatedText(links[index]!, rng);
        const read = projectOfLink(link, courses);
        const code = 'problem' in read ? read.problem.code : 'opened';
        codes.set(code, (codes.get(code) ?? 0) + 1);
        if ('problem' in read) expect(read.problem.message).not.toBe('');
      // What opens can be shared again: nothing of it is beyond what a link or a file may hold.
      else expect(projectOfLink(linkFor(read.project), courses), `seed ${String(seed)}`).toMatchObject({ project: read.project }); // prettier-ignore
      }
      for (const code of ['opened', 'damaged', 'invalid']) expect(codes.get(code), code).toBeGreaterThan(RUNS / 200);
    },
    TIME_LIMIT_MS,
  );

  it(
    `never unpack to more than the limit, whatever the deflated bytes are (${String(RUNS)} of them)`,
    () => {
      const deflated = packed(new Uint8Array(100_000));
      for (let seed = 1; seed <= RUNS; seed += 1) {
        const bytes = unpacked(mutatedBytes(deflated, createRng(seed)), 5_000);
        if (typeof bytes !== 'string') expect(bytes.length).toBeLessThanOrEqual(5_000);
      }
    },
    TIME_LIMIT_MS,
  );
});

describe('randomly changed links of WebTigerPython', () => {
  it(
    `open as valid files or give a message, never an exception (${String(RUNS)} links)`,
    () => {
      const files = [{ name: 'main.py', data: 'print("hallo")\n'.repeat(9) }, { name: 'fahren.py', data: 'ü = 1' }]; // prettier-ignore
      const link = `?code=${LZString.compressToBase64(JSON.stringify(files))}&device=micro:bit`;
      for (let seed = 1; seed <= RUNS; seed += 1) {
        const read = programOfLink(mutatedText(link, createRng(seed)));
        if ('problem' in read) expect(read.problem.message).not.toBe('');
        else expect(read.files[0]?.name).toBe('main.py');
      }
    },
    TIME_LIMIT_MS,
  );
});
