// @vitest-environment happy-dom
import { beforeEach, describe, expect, it } from 'vitest';
import { nextTick } from 'vue';

import { targetAt } from '#check/testing/tasks';

import { mountOn } from '../app/testing/mount-on';
import { createPage } from '../app/testing/page';
import { ClassModel } from './model/class-model';
import TaskChoice from './TaskChoice.vue';

/** A page, and a class of which nothing is handed in. */
function classOn() {
  const page = createPage();
  const model = new ClassModel({ starter: () => Promise.reject(new Error()), every: () => () => undefined, lanes: 1 });
  return { page, model };
}
const objectsOf = (model: ClassModel): number => model.task.value?.task.project.scene.objects.length ?? -1;

beforeEach(() => sessionStorage.clear());

describe('the task that a class is checked for', () => {
  it('is that of the open work, also when another one is open as the page comes back', () => {
    const { page, model } = classOn();
    mountOn(page, TaskChoice, { model });
    const before = objectsOf(model);
    page.work.edit({ type: 'add', objects: [targetAt(300, 300, 'second')] });
    mountOn(page, TaskChoice, { model });
    expect(objectsOf(model)).toBe(before + 1);
  });

  it('stays as it is while the open work does', () => {
    const { page, model } = classOn();
    mountOn(page, TaskChoice, { model });
    const { value } = model.task;
    mountOn(page, TaskChoice, { model });
    expect(model.task.value).toBe(value);
  });

  it('is none where the open course has nothing to check, and that is said', async () => {
    const { page, model } = classOn();
    mountOn(page, TaskChoice, { model });
    page.work.edit({ type: 'remove', ids: page.work.scene.value.objects.map(({ id }) => id) });
    const shown = mountOn(page, TaskChoice, { model });
    await nextTick();
    expect(model.task.value).toBeNull();
    expect(shown.get('[role="alert"]').text()).toContain('gibt es nichts zu prüfen');
  });

  it('is still the ready course that was chosen', async () => {
    const { page, model } = classOn();
    const shown = mountOn(page, TaskChoice, { model });
    await shown.get('select').setValue('closed-line');
    const again = mountOn(page, TaskChoice, { model });
    expect(again.get<HTMLSelectElement>('select').element.value).toBe('closed-line');
    expect(model.task.value?.name).toBe('Geschlossene Linie');
  });
});
