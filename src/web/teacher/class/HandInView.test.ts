// @vitest-environment happy-dom
import { beforeAll, describe, expect, it } from 'vitest';

import { Drawings } from '#check/report/drawing';
import { unreadable } from '#check/result';
import { sceneWith, targetAt, taskWith } from '#check/testing/tasks';

import { mountOn } from '../../app/testing/mount-on';
import { createPage } from '../../app/testing/page';
import { loadTexts } from '../../kit/i18n';
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

  it('closes with Escape, before the page does', () => {
    const shown = view(null);
    window.dispatchEvent(new KeyboardEvent('keydown', { key: 'Escape', cancelable: true }));
    expect(shown.emitted('close')).toHaveLength(1);
  });
});
