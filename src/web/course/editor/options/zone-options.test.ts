// @vitest-environment happy-dom
import { expect, it } from 'vitest';
import { nextTick } from 'vue';

import { editingPage, press } from '../../../app/testing/editing';
import { mountOn } from '../../../app/testing/mount-on';
import ZoneOptions from './ZoneOptions.vue';

it('sets the colour of the blocks that the next target wants, once it wants any', async () => {
  const page = await editingPage([]);
  const { options, setOptions } = page.editor;
  const mounted = mountOn(page, ZoneOptions, { compact: false });
  const names = () => mounted.findAll('button').map((it) => it.attributes('aria-label'));
  expect(names()).not.toContain('Farbe der Blöcke: beliebig');
  setOptions({ zoneBlocks: 2 });
  await nextTick();
  await press('Farbe der Blöcke: beliebig');
  await press('Rot');
  expect(options.value.zoneBlockColor).toBe('red');
  expect(names()).toContain('Farbe der Blöcke: Rot');
});
