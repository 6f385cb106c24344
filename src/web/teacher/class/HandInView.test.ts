// @vitest-environment happy-dom
import { beforeAll, describe, expect, it } from 'vitest';

import { Drawings } from '#check/report/drawing';
import { handInOfFiles } from '#check/hand-in/read-hand-in';
import { unreadable } from '#check/result';
import { sceneWith, targetAt, taskWith } from '#check/testing/tasks';

import { mountOn } from '../../app/testing/mount-on';
import { newClass } from '#school-class/school-class';
import { usualScale } from '#school-class/grades';
import { createPage } from '../../app/testing/page';
import { loadTexts } from '../../kit/i18n';
import { classBookOf } from '../class-book/use-class-book';
import HandInView from './HandInView.vue';
import type { Row } from './model/class-model';

const task = taskWith(sceneWith([targetAt(600, 450)]));
const view = (result: Row['result']) => {
  const row: Row = { name: 'Tim_7_assignsubmission_file_', shown: 'Tim', handIn: null, note: '', result };
  return mountOn(createPage(), HandInView, { row, task, drawings: new Drawings(task) });
};
beforeAll(() => loadTexts('de'));

describe('one hand-in', () => {
  it('shows each check with its sign, and none where it could not be read', () => {
    const nothing = unreadable(task.checks, { code: 'zip', params: {} });
    expect(view({ ...nothing, remarks: [] }).findAll('li')).toHaveLength(1);
    const unread = view(nothing);
    expect(unread.findAll('li')).toHaveLength(0);
    expect(unread.text()).toContain('nicht lesbar');
    expect(unread.get('h3').text()).toBe('Tim');
  });

  it('has its program beside it, with the lines marked that the model solution does not have, and the other way round', async () => {
    const main = (text: string) => [{ name: 'main.py', text }];
    const handIn = handInOfFiles(main('a = 1\nb = 2\n'));
    const row: Row = { name: 'Tim', shown: 'Tim', handIn, note: '', result: null };
    const solved = { ...task, solution: main('a = 1\nb = 3\n') };
    const shown = mountOn(createPage(), HandInView, { row, task: solved, drawings: new Drawings(solved) });
    const marked = () => shown.findAll('.lines .unlike').map((line) => line.text());
    expect(shown.findAll('.lines li').map((line) => line.text())).toEqual(['a = 1', 'andere Zeile: b = 2', '']);
    await shown.get('[data-testid=class-solution]').trigger('click');
    expect(marked()).toEqual(['andere Zeile: b = 3']);
    const alone = mountOn(createPage(), HandInView, { row, task, drawings: new Drawings(task) });
    expect(alone.find('[data-testid=class-solution]').exists()).toBe(false);
    expect(alone.findAll('.lines .unlike')).toHaveLength(0);
  });

  it('says from which level it comes', () => {
    const levels = ['Leer', 'Fast fertig'].map((name) => ({ name, text: '', lines: [] }));
    const of = (level: number | undefined) => {
      const handIn = { ...handInOfFiles([{ name: 'main.py', text: '' }]), ...(level !== undefined && { level }) };
      const row: Row = { name: 'Tim', shown: 'Tim', handIn, note: '', result: null };
      return mountOn(createPage(), HandInView, { row, task: { ...task, levels }, drawings: new Drawings(task) });
    };
    expect(of(1).get('[data-testid=class-level]').text()).toBe('Fast fertig');
    for (const level of [undefined, 2]) expect(of(level).find('[data-testid=class-level]').exists()).toBe(false);
  });

  it('takes points by hand within those of the task, and says what is wrong without losing it', async () => {
    const handIn = handInOfFiles([{ name: 'main.py', text: '' }]);
    const result = { ...unreadable(task.checks, { code: 'zip', params: {} }), remarks: [] };
    const row: Row = { name: 'Tim', shown: 'Tim', handIn, note: '', result };
    const shown = mountOn(createPage(), HandInView, { row, task, drawings: new Drawings(task) });
    const field = shown.get<HTMLInputElement>('[data-testid=class-mark]');
    await field.setValue('2');
    expect(shown.get('[data-testid=mark-wrong]').text()).toContain('«2» geht nicht');
    expect(field.element.value).toBe('2');
    expect(shown.emitted('mark')).toBeUndefined();
    for (const typed of ['0,5', '']) await field.setValue(typed);
    expect(shown.emitted('mark')).toEqual([[0.5], [null]]);
    expect(shown.find('[data-testid=mark-wrong]').exists()).toBe(false);
  });

  it('tells the grade for the points that count, by the scale of the class that is open', () => {
    const page = createPage();
    classBookOf(page).add({ ...newClass('8b'), scale: usualScale('ch6') }, true);
    const handIn = handInOfFiles([{ name: 'main.py', text: '' }]);
    const result = { ...unreadable(task.checks, { code: 'zip', params: {} }), remarks: [] };
    const row: Row = { name: 'Tim', shown: 'Tim', handIn, note: '', result, marked: 0.5 };
    const shown = mountOn(page, HandInView, { row, task, drawings: new Drawings(task) });
    expect(shown.get('[data-testid=class-grade]').text()).toBe('Note 3.5, nach der Skala von «8b»');
  });

  it('closes with Escape, before the page does', () => {
    const shown = view(null);
    window.dispatchEvent(new KeyboardEvent('keydown', { key: 'Escape', cancelable: true }));
    expect(shown.emitted('close')).toHaveLength(1);
  });
});
