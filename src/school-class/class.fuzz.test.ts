import { readFileSync } from 'node:fs';

import { describe, expect, it } from 'vitest';

import { createRng } from '#core/rng';
import { fuzzRuns } from '#core/testing/fuzz-runs';
import { mutatedText, mutatedTree } from '#scene/testing/mutate';
import { classToText, parseClass } from './class-file';
import { mergeClasses } from './merge';
import { rowsOf } from './progress';

/** Only against an endless loop. */
const TIME_LIMIT_MS = 60_000 + 20 * fuzzRuns;

describe('randomly changed files of a class', () => {
  it(
    `open as something valid or give a message, never an exception (${String(fuzzRuns)} files)`,
    () => {
      const text = readFileSync(new URL('kept/v1.json', import.meta.url), 'utf8');
      const value: unknown = JSON.parse(text);
      const counts = { read: 0, refused: 0 };
      for (let seed = 1; seed <= fuzzRuns; seed += 1) {
        const rng = createRng(seed);
        const file = rng.unit() < 0.3 ? mutatedText(text, rng) : (JSON.stringify(mutatedTree(value, rng, false)) ?? '');
        const read = parseClass(file);
        counts['problem' in read ? 'refused' : 'read'] += 1;
        if ('problem' in read) expect(read.problem, `seed ${String(seed)}`).not.toBe('');
        else {
          const { schoolClass } = read;
          expect(parseClass(classToText(schoolClass)), `seed ${String(seed)}`).toEqual({ schoolClass });
          expect(rowsOf(schoolClass, '2026-11-30')).toHaveLength(schoolClass.pupils.length);
          const merged = mergeClasses(schoolClass, schoolClass);
          expect(mergeClasses(merged, schoolClass), `seed ${String(seed)}`).toEqual(merged);
        }
      }
      for (const count of Object.values(counts)) expect(count).toBeGreaterThan(fuzzRuns / 100);
    },
    TIME_LIMIT_MS,
  );
});
