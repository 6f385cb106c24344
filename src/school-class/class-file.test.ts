import { readFileSync } from 'node:fs';

import { describe, expect, it } from 'vitest';

import { addResults } from './add-results';
import { classToText, parseClass } from './class-file';
import { withList } from './class-list';
import { newClass, type SchoolClass } from './school-class';
import { aResult, aTask, found } from './testing/class';

const kept = (): string => readFileSync(new URL('kept/v1.json', import.meta.url), 'utf8');
const read = (text: string): SchoolClass => {
  const parsed = parseClass(text);
  if ('problem' in parsed) throw new Error(parsed.problem);
  return parsed.schoolClass;
};
const changed = (change: Readonly<Record<string, unknown>>): string => JSON.stringify({ ...JSON.parse(kept()), ...change }); // prettier-ignore

describe('the file of a class', () => {
  it('of version 1 is read, and written as it was', () => expect(classToText(read(kept()))).toBe(kept()));

  it('has a line for each pupil, task and result', () => {
    const task = { task: aTask('bend'), found: found('The bend', { Ada: aResult(4) }), day: '2026-11-02' };
    const { schoolClass } = addResults(withList(newClass('8b'), ['Ada Meier']), task);
    const text = classToText(schoolClass);
    expect(text.split('\n').filter((line) => line.startsWith('    {'))).toHaveLength(3);
    expect(read(text)).toEqual(schoolClass);
    expect(read(`\ufeff${text}`)).toEqual(schoolClass);
  });

  it.each([
    ['no JSON', 'class', 'The class file is not JSON: line 1, column 1, at "class".'],
    [
      'another file',
      '{"format": "parcours-series"}',
      'This is not the file of a class: "format" must be "parcours-class".',
    ],
    ['null', 'null', 'This is not the file of a class: "format" must be "parcours-class".'],
    ['a newer file', changed({ version: 3 }), 'Class version 3 is newer than this app (2). Reload the page to update.'],
    ['no version', changed({ version: 'one' }), 'Class version "one" is unknown; this app reads version 2.'],
    ['no name', changed({ name: undefined }), 'name: is missing; it must be a text in quotes.'],
    ['a day that there is not', changed({ tasks: [{ id: 'a', title: '', points: 1, since: '2026-02-30' }], results: [] }), 'tasks[0].since: "2026-02-30" is no day such as "2026-11-30".'], // prettier-ignore
    ['somebody unknown', changed({ pupils: [] }), /^results\[0\]\.pupil: nobody in the class has the id "meier-ada"\. \(and \d+ more\)$/], // prettier-ignore
    ['an id twice', changed({ pupils: [{ id: 'a', name: 'A' }, { id: 'a', name: 'B' }], results: [] }), 'pupils[1].id: another one has the id "a".'], // prettier-ignore
    ['an unknown scale', changed({ scale: { system: 'us' } }), 'scale.system: "us" is unknown. Known: ch6, de6, de15, fr20, it10.'], // prettier-ignore
    ['a key that means something to JavaScript', kept().replace('"name"', '"__proto__": {}, "name"'), /__proto__.*unknown property/], // prettier-ignore
  ])('that is %s is refused with the place and the way out', (_, text, problem) => {
    const parsed = parseClass(text);
    expect('problem' in parsed && parsed.problem).toEqual(typeof problem === 'string' ? problem : expect.stringMatching(problem)); // prettier-ignore
  });
});
