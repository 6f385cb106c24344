// @vitest-environment happy-dom
import { flushPromises } from '@vue/test-utils';
import { beforeAll, describe, expect, it, vi } from 'vitest';

import { defineComponent, h } from 'vue';

import { chosenLevel } from '#check/task/chosen-level';
import { levelsOf, locksOf } from '#check/task/read-task';
import { withoutSecrets } from '#check/task/write-task';
import { MAIN } from '#project/project';

import { byId, fieldById, isThere, tap, write } from '../../app/testing/find';
import { mountOn, textOf } from '../../app/testing/mount-on';
import { createPage, type TestPage } from '../../app/testing/page';
import { loadTexts } from '../../kit/i18n';
import TaskChecks from '../../session/task/TaskChecks.vue';
import { useWork } from '../../session/work/model/parts';
import LevelFields from './levels/LevelFields.vue';
import { useTaskMaker } from './use-task-maker';

beforeAll(() => loadTexts('de'));

const projectOn = ({ work }: TestPage) => work.work.value.project;
const textOn = (page: TestPage): string | undefined => page.work.find(MAIN)?.text;
const levelsOn = (page: TestPage) => levelsOf(projectOn(page).task);

/** The levels of the task that is open. */
const Levels = defineComponent({
  setup() {
    const { task } = useTaskMaker(useWork());
    return () => task.value && h(LevelFields, { task: task.value });
  },
});

async function make(hints: readonly string[] = []): Promise<TestPage> {
  const page = createPage();
  const { scene, ...project } = projectOn(page);
  const card = { language: '', title: '', hints, translations: [], picture: '', solution: false };
  if (hints.length > 0) page.work.openProject({ ...project, course: null, scene: { ...scene, task: { ...scene.task, card } } }, null); // prettier-ignore
  page.work.setText(MAIN, '', true);
  mountOn(page, Levels);
  await tap('maker-level-add');
  page.work.setText(MAIN, '# oben\n\nstop()\n', true);
  page.work.setTask({ ...projectOn(page).task, version: 1, locks: { lines: [1] } });
  await flushPromises();
  await tap('maker-level-add');
  return page;
}

describe('levels on the page that makes a task', () => {
  it('are start programs taken from the editor, with their locked lines and names of the teacher', async () => {
    const page = await make();
    expect(levelsOn(page)).toEqual([
      { name: 'leer', text: '', lines: [] },
      { name: 'Lücken', text: '# oben\n\nstop()\n', lines: [1] },
    ]);
    expect(fieldById('maker-level-add').disabled).toBe(true); // it is one already
    await write(byId('maker-level-1'), ' mit Rahmen ');
    byId('maker-level-1').dispatchEvent(new Event('change'));
    await flushPromises();
    expect(levelsOn(page).map(({ name }) => name)).toEqual(['leer', 'mit Rahmen']);
  });

  it('come back into the editor, are replaced by what is there, and go', async () => {
    const page = await make();
    await tap('maker-level-show-0');
    expect([textOn(page), locksOf(projectOn(page).task!).lines]).toEqual(['', []]);
    page.work.setText(MAIN, 'x = 1\n', true);
    await flushPromises();
    await tap('maker-level-renew-1');
    expect(levelsOn(page)[1]).toEqual({ name: 'Lücken', text: 'x = 1\n', lines: [] });
    await tap('maker-level-remove-1');
    await tap('maker-level-remove-0');
    expect(projectOn(page).task).not.toHaveProperty('levels');
  });
});

describe('levels of a task whose card has hints', () => {
  it('allow all or fewer of them, and may begin with the same program', async () => {
    const page = await make(['Eins', 'Zwei']);
    expect(fieldById('maker-level-add').disabled).toBe(true); // all hints, too: nothing would be different
    await write(byId('maker-level-hints-1').querySelector('input')!, '1');
    byId('maker-level-hints-1').querySelector('input')!.dispatchEvent(new Event('change'));
    await flushPromises();
    expect(levelsOn(page).map(({ hints }) => hints)).toEqual([undefined, 1]);
    await tap('maker-level-add');
    expect(levelsOn(page).map(({ text, hints }) => [text, hints])).toEqual([
      ['', undefined],
      ['# oben\n\nstop()\n', 1],
      ['# oben\n\nstop()\n', undefined],
    ]);
  });

  it('show as many on the card of a pupil, whose program stays from one to the other', async () => {
    const project = withoutSecrets(projectOn(await make(['Eins', 'Zwei'])));
    const levels = levelsOf(project.task);
    const page = createPage();
    page.work.openProject({ ...project, task: { ...project.task!, levels: [levels[1], { ...levels[1], name: 'ohne', hints: 0 }] } }, null); // prettier-ignore
    await vi.waitFor(() => expect(page.work.locks.task.value).not.toBeNull());
    mountOn(page, defineComponent({ setup: () => () => h(TaskChecks, { project: projectOn(page) }) }));
    await tap('task-level-0');
    expect(page.task.text.value.hints).toEqual(['Eins', 'Zwei']);
    page.work.setText(MAIN, '# oben\nforward()\nstop()\n', true);
    await flushPromises();
    await tap('task-level-1');
    expect(page.task.text.value.hints).toEqual([]);
    expect(textOn(page)).toBe('# oben\nforward()\nstop()\n');
    expect(page.work.work.value.previous).toEqual([]);
  });
});

describe('levels on the card of a pupil', () => {
  async function given(): Promise<TestPage> {
    const project = withoutSecrets(projectOn(await make()));
    const page = createPage();
    page.work.openProject(project, null);
    await vi.waitFor(() => expect(page.work.locks.task.value).not.toBeNull());
    mountOn(page, defineComponent({ setup: () => () => h(TaskChecks, { project: projectOn(page) }) }));
    return page;
  }

  it('are asked for once; the choice brings its program, and its locked lines hold', async () => {
    const page = await given();
    expect(textOf(byId('task-levels'))).toBe('Womit beginnst du?leerLücken');
    await tap('task-level-1');
    expect([textOn(page), chosenLevel(projectOn(page).task)]).toEqual(['# oben\n\nstop()\n', 1]);
    expect(textOf(byId('task-levels'))).toBe('Deine StufeleerLücken');
    page.work.setText(MAIN, 'stop()\n', true);
    expect(textOn(page)).toBe('# oben\n\nstop()\n');
  });

  it('lead back to the start program, and what was written is kept aside', async () => {
    const page = await given();
    await tap('task-level-1');
    page.work.setText(MAIN, '# oben\nforward()\n\nstop()\n', true);
    await flushPromises();
    expect(isThere('task-level-start')).toBe(true);
    await tap('task-level-start');
    expect(textOn(page)).toBe('# oben\n\nstop()\n');
    expect(page.work.work.value.previous.map(({ project }) => project.files[0]!.text)).toEqual([
      '# oben\nforward()\n\nstop()\n',
    ]);
    await tap('task-level-0');
    expect([textOn(page), page.work.work.value.previous.length]).toEqual(['', 1]);
    expect(locksOf(projectOn(page).task!).lines).toEqual([]);
  });
});
