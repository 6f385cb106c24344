// @vitest-environment happy-dom
import { beforeAll, describe, expect, it } from 'vitest';
import { shallowRef } from 'vue';

import { Drawings } from '#check/report/drawing';
import { sceneWith, targetAt, taskWith } from '#check/testing/tasks';
import type { Group } from '#hint/groups/groups';

import { mountOn } from '../../../app/testing/mount-on';
import { createPage } from '../../../app/testing/page';
import { loadTexts } from '../../../kit/i18n';
import type { ClassModel, Row } from '../model/class-model';
import GroupView from './GroupView.vue';
import type { GroupsModel } from './groups-model';

const task = taskWith(sceneWith([targetAt(600, 450)]));
const group: Group = {
  ...{ key: 'unmoved', is: { kind: 'unmoved' }, world: null, place: null, region: null, seconds: null, nearCm: null },
  ...{ members: ['a', 'b', 'c'], example: 'a' },
};
beforeAll(() => loadTexts('de'));

/** A group with a hint that holds for two of its three programs. */
function view(ofB = '') {
  const row = (name: string, note = ''): Row => ({ name, shown: name, handIn: null, result: null, note });
  const rows = shallowRef<readonly Row[]>([row('a', 'Schöne Idee.'), row('b', ofB), row('c')]);
  const write = (name: string, note: string): void =>
    void (rows.value = rows.value.map((one) => (one.name === name ? { ...one, note } : one)));
  const model = { rows, write } as unknown as ClassModel;
  const groups = {
    hintsInWords: () => new Map([['a', 'Zeile 3 ist zu viel.'], ['b', 'Zeile 4 ist zu viel.']]),
    ...{ hintOf: () => undefined, handInsOf: () => [], search: () => undefined, stopSearch: () => undefined },
  } as unknown as GroupsModel; // prettier-ignore
  const page = createPage();
  const props = { model, groups, group, task, drawings: new Drawings(task) };
  return { page, rows, shown: mountOn(page, GroupView, props) };
}

describe('the hint to a group', () => {
  it('is written into the notes of those for whose programs it holds, once, and can be taken back', async () => {
    const { page, rows, shown } = view();
    const notes = () => rows.value.map(({ note }) => note);
    const tell = shown.get<HTMLButtonElement>('[data-testid=group-tell]');
    expect(tell.text()).toBe('Tipp in 2 Notizen');
    await tell.trigger('click');
    expect(notes()).toEqual(['Schöne Idee. Zeile 3 ist zu viel.', 'Zeile 4 ist zu viel.', '']);
    expect([tell.text(), tell.element.disabled]).toEqual(['Der Tipp steht in 2 Notizen.', true]);
    page.notices.current.value?.action?.run();
    expect(notes()).toEqual(['Schöne Idee.', '', '']);
  });

  it('is left out of a note that would be longer than a feedback takes, and it is said', async () => {
    const long = 'x'.repeat(490);
    const { page, rows, shown } = view(long);
    expect(shown.get('[data-testid=group-left-out]').text()).toBe('1 Notiz würde zu lang und bleibt, wie sie ist.');
    await shown.get('[data-testid=group-tell]').trigger('click');
    expect(rows.value.map(({ note }) => note)).toEqual(['Schöne Idee. Zeile 3 ist zu viel.', long, '']);
    expect(page.notices.current.value?.values).toEqual({
      text: 'Der Tipp steht in der Notiz. 1 Notiz würde zu lang und bleibt, wie sie ist.',
    });
  });
});
