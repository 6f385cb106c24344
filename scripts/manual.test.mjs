import * as v from 'valibot';
import { describe, expect, it } from 'vitest';
import { withTables } from './manual.mjs';

const file = 'Intro\n<!-- ours:start, written by npm run manual -->\nold\n<!-- ours:end -->\nEnd\n';
const message = {
  name: 'seed',
  direction: 'in',
  about: 'Chooses the robot.',
  schema: v.strictObject({
    type: v.literal('seed'),
    seed: v.pipe(v.number(), v.integer(), v.minValue(1), v.maxValue(9999), v.description('Which one.')),
    how: v.exactOptional(v.picklist(['a', 'b'])),
    at: v.array(v.strictObject({ xMm: v.number() })),
    file: v.pipe(v.custom(() => true), v.metadata({ shown: 'project file' })), // prettier-ignore
  }),
};
const written = (messages) => withTables(file, { ours: { title: '', version: '1', messages } });

describe('npm run manual', () => {
  it('writes a table of the fields of each message between the marks and leaves the rest alone', () => {
    const text = written([message]);
    expect(text.split('\n').filter((line) => /^[|#]|^Intro|^End|^old/.test(line))).toEqual([
      'Intro',
      '### From the host to the page',
      '#### `seed`',
      '| Field | type and range | meaning |',
      '| --- | --- | --- |',
      '| `seed` | whole number, 1 … 9,999 | Which one. |',
      '| `how` | `"a"`, `"b"`, may be left out |  |',
      '| `at` | list |  |',
      '| `at[].xMm` | number |  |',
      '| `file` | project file |  |',
      'End',
    ]);
  });

  it('writes what an answer brings below its command', () => {
    const text = written([{ ...message, schema: v.strictObject({}), answer: v.strictObject({ ok: v.boolean() }) }]);
    expect(text).toContain('Its answer brings:\n\n| Field of the answer | type and range | meaning |');
  });

  it('names the version that brought a message which is younger than its dialect', () => {
    expect(written([{ ...message, since: '1.2.0' }])).toContain('Chooses the robot. _Since 1.2.0._');
  });

  it('refuses a file without a place for a dialect', () => {
    expect(() => withTables('Nothing', { ours: { title: '', version: '1', messages: [] } })).toThrow('no place');
  });
});
