// @vitest-environment happy-dom
import { describe, expect, it } from 'vitest';

import { editingPage } from '../../app/testing/editing';
import { createPage } from '../../app/testing/page';
import { startRun } from '../../app/testing/run';
import { useToldProblems } from './use-told-problems';

describe('what is not right with a course', () => {
  it('is told to who only opens a course of somebody’s own, by a sign alone, also while it runs', async () => {
    const page = await editingPage();
    const { hasEdited, isTold, isQuiet } = useToldProblems(page);
    expect([hasEdited.value, isTold.value, isQuiet.value]).toEqual([false, true, true]);
    await startRun(page);
    expect([isTold.value, isQuiet.value]).toEqual([true, true]);
  });

  it('is not looked for in a ready course that is only driven', () => {
    expect(useToldProblems(createPage()).isTold.value).toBe(false);
  });

  it('is told to who edits, also while it runs', async () => {
    const page = await editingPage();
    const { hasEdited, isTold, isQuiet } = useToldProblems(page);
    page.editor.choose('select');
    await startRun(page);
    expect([hasEdited.value, isTold.value, isQuiet.value]).toEqual([true, true, false]);
  });
});
