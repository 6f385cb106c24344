// @vitest-environment happy-dom
import { describe, expect, it, vi } from 'vitest';
import { nextTick, shallowRef } from 'vue';

import { classResult } from '#check/report/class-result';
import { sceneWith, targetAt, taskWith } from '#check/testing/tasks';
import { aResult } from '#school-class/testing/class';

import { mountOn } from '../../app/testing/mount-on';
import { createPage } from '../../app/testing/page';
import { classBookOf } from '../class-book/use-class-book';
import ReportPreview from './ReportPreview.vue';

const task = taskWith(sceneWith([targetAt(600, 450)]));

describe('the report of a class', () => {
  it('counts as saved once it is in a file as a whole; its table, its groups and one hand-in have names of their own', async () => {
    const found = classResult('Weg', [{ name: 'Ada', result: aResult(1) }], 'de');
    const page = createPage();
    await classBookOf(page).ready;
    const saved = vi.fn();
    const names: string[] = [];
    vi.spyOn(HTMLAnchorElement.prototype, 'click').mockImplementation(function (this: HTMLAnchorElement) {
      names.push(this.download);
    });
    const groups = { groups: shallowRef([]) };
    mountOn(page, ReportPreview, { found, task, rows: [], groups, onSaved: saved });
    await nextTick();
    const save = async (who: string): Promise<number> => {
      const choice = document.querySelector<HTMLSelectElement>('[data-testid=report-of]')!;
      choice.value = who;
      choice.dispatchEvent(new Event('change'));
      await nextTick();
      document.querySelector<HTMLElement>('[data-testid=report-save]')!.click();
      return saved.mock.calls.length;
    };
    expect([await save('groups'), await save('table'), await save('0'), await save('')]).toEqual([0, 0, 0, 1]);
    expect(names).toEqual(['Weg – Gruppen, ohne Namen.html', 'Weg – Tabelle.html', 'Weg Ada.html', 'Weg.html']);
  });
});
