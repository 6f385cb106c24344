import { describe, expect, it } from 'vitest';

import type { CheckResult } from '#check/result';
import { addResults } from './add-results';
import { classToText, parseClass } from './class-file';
import { withList } from './class-list';
import { usualScale } from './grades';
import { mergeClasses } from './merge';
import { missingIn, rowsOf } from './progress';
import { classReport } from './report/html';
import { newClass, type SchoolClass } from './school-class';
import { aResult, aTask, found } from './testing/class';

const list = withList({ ...newClass('8b'), scale: usualScale('ch6') }, ['Ada Meier', 'Ben Huber', 'Cleo Roth']);
const add = (to: SchoolClass, task: string, day: string, results: Readonly<Record<string, CheckResult>>): SchoolClass =>
  addResults(to, { task: aTask(task), found: found(`Task ${task}`, results), day }).schoolClass;
const table = (of: SchoolClass, day = '2026-11-30'): readonly string[] =>
  rowsOf(of, day).map(
    ({ pupil, cells, points, most, grade }) =>
    [pupil.name, ...cells.map(({ state, points: own, tries }) => `${state} ${String(own)} (${String(tries)})`), `${String(points)}/${String(most)}`, grade].join(' · '), // prettier-ignore
  );

const first = add(list, 'bend', '2026-11-02', { 'Ada Meier': aResult(4), ben: aResult(2), Cleo: aResult(null) });
const second = add(first, 'garage', '2026-11-09', { 'ada meier': aResult(3), 'Cleo Roth': aResult(0) });

describe('the progress of a class', () => {
  it('has a row for each pupil: what could not be read gives no points, what is missing gives none of four', () =>
    expect(table(second)).toEqual([
      'Ada Meier · passed 4 (1) · partly 3 (1) · 7/8 · 5.5',
      'Ben Huber · partly 2 (1) · missing 0 (0) · 2/8 · 2.5',
      'Cleo Roth · unread 0 (1) · failed 0 (1) · 0/4 · 1',
    ]));

  it('counts the best hand-in, and each different one once', () => {
    const again = add(second, 'bend', '2026-11-16', { Ben: aResult(1), 'Ben Huber': aResult(2), Cleo: aResult(4) });
    const better = add(again, 'bend', '2026-11-16', { Ben: aResult(3) });
    expect(table(better).slice(1)).toEqual([
      'Ben Huber · partly 3 (3) · missing 0 (0) · 3/8 · 3',
      'Cleo Roth · passed 4 (2) · failed 0 (1) · 4/8 · 3.5',
    ]);
  });

  it('leaves a task open until its last day is over', () => {
    const due = { ...second, tasks: second.tasks.map((task) => ({ ...task, due: '2026-11-30' })) };
    expect(table(due, '2026-11-30')[1]).toBe('Ben Huber · partly 2 (1) · open 0 (0) · 2/4 · 3.5');
    expect(table(due, '2026-12-01')[1]).toBe('Ben Huber · partly 2 (1) · missing 0 (0) · 2/8 · 2.5');
    expect(missingIn(rowsOf(due, '2026-11-30'), 1).map(({ name }) => name)).toEqual(['Ben Huber']);
  });

  it('does not take the same hand-ins twice, and keeps its day, title and points up to date', () => {
    const twice = addResults(second, {
      task: aTask('bend'),
      found: found('The sharp bend', { 'Ada Meier': aResult(4), ben: aResult(2) }),
      day: '2026-11-20',
    });
    expect(twice.count).toBe(0);
    expect(twice.schoolClass.results).toEqual(second.results);
    expect(twice.schoolClass.tasks[0]).toMatchObject({ id: 'bend', title: 'The sharp bend', since: '2026-11-02' });
  });

  it('counts points set by hand instead, also for a hand-in that it has, and a file of version 2 keeps them', () => {
    const marked = (points: number) =>
      found('Bend', { ben: aResult(2) }).handIns.map((one) => ({ ...one, marked: points }));
    const mark = (to: SchoolClass, points: number): SchoolClass =>
      addResults(to, { task: aTask('bend'), found: { task: 'Bend', handIns: marked(points) }, day: '2026-11-20' })
        .schoolClass;
    const changed = mark(mark(first, 3.5), 2.5);
    expect(table(changed)[1]).toBe('Ben Huber · partly 2.5 (1) · 2.5/4 · 4');
    const text = classToText(changed);
    expect(text).toContain('"version": 2');
    expect(parseClass(text)).toEqual({ schoolClass: changed });
    expect(classReport(changed, '2026-11-30', 'de')).toContain('◐ 2.5 / 4 ✎');
    // Checked once more on the command line, which knows of no points by hand.
    expect(table(add(changed, 'bend', '2026-11-21', { ben: aResult(2) }))[1]).toContain('partly 2.5 (1)');
    expect(classToText(first)).toContain('"version": 1');
  });

  it('says who is not on the list; without a list all are', () => {
    const task = { task: aTask('bend'), found: found('', { Zoe: aResult(4), Ada: aResult(4) }), day: '2026-11-02' };
    expect(addResults(list, task).strangers).toEqual(['Zoe']);
    expect(addResults(newClass('8b'), task).strangers).toEqual([]);
  });
});

describe('two copies of a class', () => {
  const one = add(second, 'maze', '2026-11-16', { Ada: aResult(4), Zoe: aResult(1) });
  const two = add(add(second, 'maze', '2026-11-17', { Ada: aResult(4), Ben: aResult(2), Zoe: aResult(1) }), 'ring', '2026-11-18', { Cleo: aResult(3) }); // prettier-ignore

  it('are one with all that is in either of them, and nothing twice', () => {
    const merged = mergeClasses(one, two);
    expect(table(merged)).toEqual([
      'Ada Meier · passed 4 (1) · partly 3 (1) · passed 4 (1) · missing 0 (0) · 11/16 · 4.5',
      'Ben Huber · partly 2 (1) · missing 0 (0) · partly 2 (1) · missing 0 (0) · 4/16 · 2.5',
      'Cleo Roth · unread 0 (1) · failed 0 (1) · missing 0 (0) · partly 3 (1) · 3/12 · 2.5',
      'Zoe · missing 0 (0) · missing 0 (0) · partly 1 (1) · missing 0 (0) · 1/16 · 1.5',
    ]);
    expect(merged.tasks.map(({ since }) => since)).toEqual(['2026-11-02', '2026-11-09', '2026-11-16', '2026-11-18']);
  });

  it('are the same in whatever order, and again', () => {
    const merged = mergeClasses(one, two);
    expect(table(mergeClasses(two, one))).toEqual(table(merged));
    expect(mergeClasses(merged, one)).toEqual(merged);
    expect(mergeClasses(one, one)).toEqual(one);
  });

  it('keep both notes on one hand-in, and both spellings of a name', () => {
    const noted = (note: string): SchoolClass => ({
      ...second,
      results: second.results.map((result, place) => (place === 0 ? { ...result, note } : result)),
    });
    expect(mergeClasses(noted('slower'), noted('good')).results[0]!.note).toBe('slower\ngood');
    const renamed = withList(second, ['Ada Sophie Meier', 'Ben Huber', 'Cleo Roth']);
    const merged = mergeClasses(renamed, second);
    expect(merged.pupils.map(({ name }) => name)).toEqual(['Ada Sophie Meier', 'Ben Huber', 'Cleo Roth']);
    expect(merged.results).toHaveLength(second.results.length);
  });
});
