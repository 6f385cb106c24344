// @vitest-environment happy-dom
import { beforeEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import { projectOf } from '#catalogue/course';
import { courses } from '#catalogue/courses';
import { handInOf, handInOfFiles } from '#check/hand-in/read-hand-in';
import { unread } from '#check/hand-in/unread';
import { seriesLinkOf } from '#check/series/series-link';
import { aSeries, readyCourses } from '#check/series/testing/series';
import { targetAt } from '#check/testing/tasks';
import type { Content } from '#intake/contents';
import { defaultScene } from '#scene/scene';
import { serializeScene } from '#scene/serialize';

import { mountOn } from '../../app/testing/mount-on';
import { createPage } from '../../app/testing/page';
import { ClassModel } from './model/class-model';
import { offerLink, offerSeries } from './task-series';
import TaskChoice from './TaskChoice.vue';

/** A page, and a class of which nothing is handed in. */
function classOn() {
  const page = createPage();
  const model = new ClassModel({ starter: () => Promise.reject(new Error()), every: () => () => undefined, lanes: 1, language: () => 'de' }); // prettier-ignore
  return { page, model };
}
const objectsOf = (model: ClassModel): number => model.task.value?.task.project.scene.objects.length ?? -1;

beforeEach(() => sessionStorage.clear());

describe('the task that a class is checked for', () => {
  it('is that of the open work, also when another one is open as the page comes back', () => {
    const { page, model } = classOn();
    page.work.edit({ type: 'add', objects: [targetAt(300, 300, 'second')] });
    mountOn(page, TaskChoice, { model });
    const before = objectsOf(model);
    page.work.edit({ type: 'add', objects: [targetAt(400, 300, 'third')] });
    mountOn(page, TaskChoice, { model });
    expect(objectsOf(model)).toBe(before + 1);
  });

  it('is none on a first visit: nobody has chosen the course that is open then', () => {
    const { page, model } = classOn();
    const shown = mountOn(page, TaskChoice, { model });
    expect(model.task.value).toBeNull();
    expect(shown.get('select').element.selectedOptions[0]?.text).toBe('Aufgabe wählen …');
  });

  it('is offered where most hand-ins know another one, and taken by one tap', async () => {
    const { page, model } = classOn();
    const shown = mountOn(page, TaskChoice, { model });
    const project = { ...projectOf(courses.find(({ id }) => id === 'closed-line')!, 'de'), files: [{ name: 'main.py', text: 'x = 1' }] }; // prettier-ignore
    const read = handInOf(project);
    const whole: Content = 'handIn' in read ? read : unread('kind');
    const alone: Content = { handIn: handInOfFiles([{ name: 'main.py', text: 'x' }]) };
    await model.add(['Ada', 'Ben', 'Cem'].map((name) => ({ name, read: () => (name === 'Cem' ? alone : whole) })));
    await nextTick();
    expect(shown.get('[data-testid="class-meant"]').text()).toContain(
      '2 von 3 Abgaben gehören zu «Geschlossene Linie».',
    );
    await shown.get('[data-testid="class-take-meant"]').trigger('click');
    expect([model.task.value?.name, model.task.value?.from]).toEqual(['Geschlossene Linie', 'closed-line']);
    await nextTick();
    expect(shown.find('[data-testid="class-meant"]').exists()).toBe(false);
    await shown.get('select').setValue('slalom');
    expect(shown.find('[data-testid="class-meant"]').exists()).toBe(true);
  });

  it('stays as it is while the open work does', () => {
    const { page, model } = classOn();
    page.work.edit({ type: 'add', objects: [targetAt(300, 300, 'second')] });
    mountOn(page, TaskChoice, { model });
    const { value } = model.task;
    expect(value).not.toBeNull();
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

  it('is that of another file as soon as that is chosen, and until then what it was', async () => {
    const { page, model } = classOn();
    const shown = mountOn(page, TaskChoice, { model });
    const { element } = shown.get<HTMLSelectElement>('select');
    const picker = shown.get<HTMLInputElement>('input[type="file"]').element;
    for (const name of ['one', 'two']) {
      let asked = 0;
      picker.addEventListener('click', () => (asked += 1), { once: true });
      const before = element.value;
      await shown.get('select').setValue('pick');
      expect([asked, element.value]).toEqual([1, before]);
      const text = serializeScene({ ...defaultScene(), name, objects: [targetAt(300, 300)] });
      Object.defineProperty(picker, 'files', { value: [new File([text], `${name}.json`)], configurable: true });
      picker.dispatchEvent(new Event('change'));
      await vi.waitFor(() => expect(model.task.value?.name).toBe(name));
    }
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

describe('a series for a class', () => {
  const parts = (shown: ReturnType<typeof mountOn>) => {
    const [from, task] = shown.findAll('select').map(({ element }) => element);
    return {
      from: from?.selectedOptions[0]?.text.trim(),
      tasks: [...(task?.options ?? [])].map(({ text, disabled }) => (disabled ? `${text} –` : text)),
      task: task?.selectedOptions[0]?.text,
    };
  };

  it('has its first task checked, and offers the others', async () => {
    const { page, model } = classOn();
    const shown = mountOn(page, TaskChoice, { model });
    offerSeries(model, { kind: 'series', series: aSeries() });
    await nextTick();
    expect(parts(shown)).toEqual({
      from: 'Serie: Woche 3: Linien',
      tasks: ['1. Geschlossene Linie', '2. Ans Ziel', '3. Ohne Aufgabe'],
      task: '1. Geschlossene Linie',
    });
    expect(model.task.value).toMatchObject({ name: 'Geschlossene Linie', from: 'series' });
    await shown.get('[data-testid="class-series-task"]').setValue('b');
    expect(model.task.value).toMatchObject({ name: 'ziel', from: 'series' });
    expect(model.task.value?.task.worlds.map(({ id }) => id)).toEqual(['visible', 'geheim']);
  });

  it('is still there when the page comes back, with the task that was chosen', async () => {
    const { page, model } = classOn();
    const shown = mountOn(page, TaskChoice, { model });
    offerSeries(model, { kind: 'series', series: aSeries() });
    await nextTick();
    await shown.get('[data-testid="class-series-task"]').setValue('3');
    expect(parts(mountOn(page, TaskChoice, { model })).task).toBe('3. Ohne Aufgabe');
  });

  it('is in a link, whatever stands around it; a damaged one says so and leaves the task', async () => {
    const { page, model } = classOn();
    const shown = mountOn(page, TaskChoice, { model });
    const { fragment } = seriesLinkOf(aSeries(), readyCourses)!;
    const before = model.task.value;
    expect(offerLink(model, `Reihe: https://example.org/#${fragment.slice(0, -9)}`)).toBe(true);
    await nextTick();
    expect(shown.get('[role="alert"]').text()).toContain('Der Link ist beschädigt');
    expect(model.task.value).toBe(before);
    expect(offerLink(model, `Reihe: https://example.org/#${fragment}, viel Spass`)).toBe(true);
    await nextTick();
    expect(parts(shown).task).toBe('1. Geschlossene Linie');
    expect(shown.find('[role="alert"]').exists()).toBe(false);
    expect(offerLink(model, 'https://example.org/#p=2.abc')).toBe(false);
    offerLink(model, `#${fragment.slice(0, -9)}`);
    await nextTick();
    expect(parts(shown).task).toBe('1. Geschlossene Linie');
    expect(shown.find('[role="alert"]').exists()).toBe(true);
  });

  it('begins with the first task that can be had; without one there is nothing to check', async () => {
    const { page, model } = classOn();
    const shown = mountOn(page, TaskChoice, { model });
    const gone = { id: 'x', title: 'Weg', from: { kind: 'file', file: 'weg.json' } } as const;
    offerSeries(model, { kind: 'series', series: { ...aSeries(), tasks: [gone, ...aSeries().tasks.slice(1)] } });
    await nextTick();
    expect(parts(shown)).toMatchObject({
      tasks: ['1. Weg (nicht lesbar) –', '2. Ans Ziel', '3. Ohne Aufgabe'],
      task: '2. Ans Ziel',
    });
    offerSeries(model, { kind: 'series', series: { ...aSeries(), tasks: [gone] } });
    await nextTick();
    expect(model.task.value).toBeNull();
    expect(shown.get('[role="alert"]').text()).toContain('keine Aufgabe, die sich lesen lässt');
  });
});
