// @vitest-environment happy-dom
import { expect, it, vi } from 'vitest';

import { editingPage, keyOn, samples } from '../../../app/testing/editing';
import { mountOn } from '../../../app/testing/mount-on';
import EditorActions from '../EditorActions.vue';

it('turns what is selected by R as by E, and chooses the tool where nothing is', async () => {
  const page = await editingPage([samples.wall, samples.block]);
  const { editor, object, steps } = page;
  mountOn(page, EditorActions);
  document.body.insertAdjacentHTML('beforeend', '<div data-editor-keys><button>Tool</button></div>');
  const beside = document.querySelector('[data-editor-keys] button')!;
  editor.choose('select');
  editor.select({ ids: ['block'], robot: false });
  await keyOn(beside, 'r');
  await vi.waitFor(() => expect(steps()).toBe(1));
  expect([object('block', 'block').angle, editor.tool.value]).toEqual([315, 'select']);
  editor.select({ ids: [], robot: false });
  await keyOn(beside, 'r');
  expect([editor.tool.value, steps()]).toEqual(['rotate', 1]);
});
