// @vitest-environment happy-dom
import { describe, expect, it } from 'vitest';

import { editingPage } from '../app/testing/editing';
import { createPage } from '../app/testing/page';
import { startRun } from '../app/testing/run';
import { useToldProblems } from './use-told-problems';

describe('what is not right with a course', () => {
  it('is told to who only opens a course of somebody’s own, until it runs', async () => {
    const page = await editingPage();
    const { hasEdited, isTold } = useToldProblems(page);
    expect([hasEdited.value, isTold.value]).toEqual([false, true]);
    await startRun(page);
    expect(isTold.value).toBe(false);
  });

  it('is not looked for in a ready course that is only driven', () => {
    expect(useToldProblems(createPage()).isTold.value).toBe(false);
  });

  it('is told to who edits, also while it runs', async () => {
    const page = await editingPage();
    const { hasEdited, isTold } = useToldProblems(page);
    page.editor.choose('select');
    await startRun(page);
    expect([hasEdited.value, isTold.value]).toEqual([true, true]);
  });
});
