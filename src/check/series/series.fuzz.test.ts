import { describe, expect, it } from 'vitest';

import { createRng } from '#core/rng';
import { fuzzRuns } from '#core/testing/fuzz-runs';
import { mutatedText, mutatedTree } from '#scene/testing/mutate';
import { parseSeries } from './read-series';
import { seriesLimits } from './series';
import { seriesLinkOf, seriesOfLink } from './series-link';
import { aSeries, readyCourses } from './testing/series';
import { seriesForPupils, seriesToText } from './write-series';

/** Only against an endless loop. */
const TIME_LIMIT_MS = 60_000 + 20 * fuzzRuns;

describe('randomly changed series', () => {
  it(
    `open as something valid or give a message, never an exception (${String(fuzzRuns)} files)`,
    () => {
      const text = seriesToText(aSeries());
      const value: unknown = JSON.parse(text);
      const counts = { whole: 0, partly: 0, refused: 0 };
      for (let seed = 1; seed <= fuzzRuns; seed += 1) {
        const rng = createRng(seed);
        const file = rng.unit() < 0.3 ? mutatedText(text, rng) : (JSON.stringify(mutatedTree(value, rng, false)) ?? '');
        const read = parseSeries(file, readyCourses);
        if ('problem' in read) {
          expect(read.problem, `seed ${String(seed)}`).not.toBe('');
          counts.refused += 1;
          continue;
        }
        const { tasks } = read.series;
        expect(tasks.length).toBeLessThanOrEqual(seriesLimits.tasks.max);
        expect(new Set(tasks.map(({ id }) => id)).size, `seed ${String(seed)}`).toBe(tasks.length);
        counts[tasks.some(({ from }) => from.kind === 'unread') ? 'partly' : 'whole'] += 1;
        const given = seriesForPupils(read.series);
        expect(parseSeries(seriesToText(given), readyCourses), `seed ${String(seed)}`).toEqual({ series: given });
      }
      for (const count of Object.values(counts)) expect(count).toBeGreaterThan(fuzzRuns / 100);
    },
    TIME_LIMIT_MS,
  );

  it(
    'and links are whole or say what is wrong',
    () => {
      const { fragment } = seriesLinkOf(seriesForPupils(aSeries()), readyCourses)!;
      for (let seed = 1; seed <= fuzzRuns; seed += 1) {
        const link = mutatedText(fragment, createRng(seed));
        const read = seriesOfLink(link, readyCourses);
        if (!('series' in read)) expect('fault' in read ? read.fault : read.problem).not.toBe('');
      }
    },
    TIME_LIMIT_MS,
  );
});
