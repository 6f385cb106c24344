// @vitest-environment happy-dom
import { expect, it } from 'vitest';

import { editingPage, fill, keyOn } from '../../../app/testing/editing';
import { mountOn, named } from '../../../app/testing/mount-on';
import LabelOptions from './LabelOptions.vue';

it('puts the text by Enter where the mouse has tapped before there was any, once', async () => {
  const { scene, ...page } = await editingPage([]);
  const { editor } = page;
  mountOn(page, LabelOptions, { compact: false });
  const arena = document.createElement('div');
  arena.setAttribute('role', 'application');
  document.body.append(arena);
  editor.pointer.value = { x: 400, y: 300 };
  const more = { bubbles: true, isPrimary: true, pointerType: 'mouse', button: 0, clientX: 5, clientY: 5 };
  for (const type of ['pointerdown', 'pointerup']) arena.dispatchEvent(new PointerEvent(type, more));
  editor.pointer.value = null; // the mouse has left the arena
  await fill('Text', 'Hallo');
  const labels = () => scene().objects.flatMap((it) => (it.type === 'label' ? [[it.text, it.at]] : []));
  await keyOn(named('Text', 'input'), 'Enter');
  expect(labels()).toEqual([['Hallo', [400, 300]]]);
  await keyOn(named('Text', 'input'), 'Enter');
  expect(labels()).toHaveLength(1);
});
