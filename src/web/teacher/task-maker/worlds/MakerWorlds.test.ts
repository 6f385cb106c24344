// @vitest-environment happy-dom
import type { VueWrapper } from '@vue/test-utils';
import { beforeAll, describe, expect, it } from 'vitest';
import { h, shallowRef } from 'vue';

import type { ClassTask } from '#check/task/task';
import { sceneWith, targetAt, taskWith } from '#check/testing/tasks';

import { mountOn } from '../../../app/testing/mount-on';
import { createPage } from '../../../app/testing/page';
import { loadTexts } from '../../../kit/i18n';
import MakerWorlds from './MakerWorlds.vue';

beforeAll(() => loadTexts('de'));

/** The worlds of a task; what they ask for is done. */
function worldsOf(start: ClassTask): VueWrapper {
  const task = shallowRef(start);
  const onChange = (part: Partial<ClassTask>): void => void (task.value = { ...task.value, ...part });
  const given = { result: null, isOld: false, equals: [], onChange };
  return mountOn(createPage(), () => h(MakerWorlds, { ...given, task: task.value }), {});
}

describe('the worlds of a task', () => {
  const arenas = (shown: VueWrapper): number => shown.findAll('[data-testid=maker-arena]').length;
  const press = (shown: VueWrapper, on: string, name: string, more: object = {}): Promise<void> =>
    shown.get(on).trigger('keydown', { key: name, ctrlKey: true, ...more });

  it('come back and go again step by step, by buttons and by keys', async () => {
    const shown = worldsOf(taskWith(sceneWith([targetAt(600, 450)])));
    expect(shown.find('[data-testid=maker-undo]').exists()).toBe(false);
    for (let more = 0; more < 2; more += 1) await shown.get('[data-testid=maker-add-world]').trigger('click');
    expect(arenas(shown)).toBe(3);
    await shown.get('[data-testid=maker-undo]').trigger('click');
    await press(shown, '[data-testid=maker-arena]', 'z');
    expect(arenas(shown)).toBe(1);
    await press(shown, '[data-testid=maker-arena]', 'z');
    await press(shown, '[data-testid=maker-arena]', 'y');
    expect(arenas(shown)).toBe(2);
    await press(shown, '[data-testid=maker-arena]', 'Z', { shiftKey: true });
    expect(arenas(shown)).toBe(3);
    expect(shown.get('[data-testid=maker-redo]').attributes('disabled')).toBeDefined();
  });

  it('cannot go on to what was undone once something else was changed', async () => {
    const shown = worldsOf(taskWith(sceneWith([targetAt(600, 450)])));
    await shown.get('[data-testid=maker-add-world]').trigger('click');
    await shown.get('[data-testid=maker-undo]').trigger('click');
    await shown.get('[data-testid=maker-add-world]').trigger('click');
    expect(shown.get('[data-testid=maker-redo]').attributes('disabled')).toBeDefined();
    expect(arenas(shown)).toBe(2);
  });
});
