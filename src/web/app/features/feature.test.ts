// @vitest-environment happy-dom
import { flushPromises } from '@vue/test-utils';
import { afterEach, describe, expect, it, vi } from 'vitest';
import { defineComponent, effectScope, h, nextTick, shallowRef } from 'vue';

import { guideSections } from '../../help/guide/entries';
import {
  collected,
  entriesOf,
  type Contribution,
  type HelpEntry,
  type FeatureEntry,
  type MenuHost,
} from '../../kit/features/feature';
import type { FeaturePage } from '../../kit/features/feature-page';
import type { FeatureWindow } from '../../kit/features/feature-window';
import { itemsAt, type BarItem } from '../../session/layout/bar-item';
import { createRouter } from '../../session/layout/router';
import { allHelpEntries } from '../../help/guide/all-help-entries';
import { mountOn, textOf } from '../testing/mount-on';
import { createPage } from '../testing/page';
import { featurePages } from './feature-pages';
import { featureWindows } from './feature-windows';
import FeatureWindows from './FeatureWindows.vue';

/** A made-up feature: its folder holds these five files, and no other file names it. */
interface MadeUp {
  readonly pages: readonly FeaturePage[];
  readonly contribution: Contribution;
  readonly helpEntries: readonly HelpEntry[];
  readonly windows: readonly FeatureWindow[];
  readonly barItems: readonly BarItem[];
}
/** True while a trophy is handed over. */
const isHanded = shallowRef(false);
const Trophy = defineComponent(() => () => h('p', { class: 'trophy' }, 'Gold'));
const fetchTrophy = vi.fn(() => Promise.resolve({ [Symbol.toStringTag]: 'Module', default: Trophy }));
const files: Readonly<Record<string, MadeUp>> = {
  '../teacher/trophies/': {
    pages: [{ name: 'trophies', hasIds: true, load: () => Promise.reject(new Error('made up')) }],
    contribution: {
      menu: () => [
        {
          group: 'help',
          order: 25,
          entries: () => [
            {
              id: 'trophies',
              testId: 'menu-trophies',
              icon: '',
              title: 'Pokale',
              act: (menu) => menu.leaveFor(open),
            },
          ],
        },
      ],
    },
    helpEntries: [
      {
        ...{ id: 'trophies', section: 'menu', after: 'class', icon: '', covers: ['menu-trophies'] },
        ...{ name: () => 'Pokale', text: () => 'Zeigt alle Pokale.' },
      },
    ],
    windows: [{ layer: 'window', shows: () => () => isHanded.value, load: fetchTrophy }],
    barItems: [{ place: 'work', order: 5, kinds: ['wide'], view: Trophy }],
  },
};
const pages = [...featurePages, ...collected(files).flatMap((feature) => feature.pages)];
const open = (): void =>
  effectScope(true)
    .run(() => createRouter(pages))
    ?.open('trophies', 'gold');
afterEach(() => history.replaceState(null, '', '/'));

describe('a made-up feature', () => {
  it('has an address that the router knows', () => {
    history.replaceState(null, '', '#trophies/gold');
    const router = effectScope().run(() => createRouter(pages));
    expect(router?.page.value).toEqual({ name: 'trophies', id: 'gold' });
  });

  it('has an entry in the main menu, at its place, which opens its page', () => {
    const own = collected(files).flatMap((feature) => feature.contribution.menu());
    const named = (id: string): FeatureEntry => ({ id, title: id, act: () => undefined });
    const before = { group: 'help', order: 20, entries: () => [named('before')] } as const;
    const elsewhere = { group: 'files', order: 10, entries: () => [named('elsewhere')] } as const;
    const entries = entriesOf([...own, before, elsewhere], 'help');
    expect(entries.map(({ id }) => id)).toEqual(['before', 'trophies']);
    const nothing = () => undefined;
    const menu: MenuHost = { leaveFor: (act) => act(), openDialog: nothing, showInside: nothing, showList: nothing };
    entries[1]?.act(menu);
    expect(location.hash).toBe('#trophies/gold');
  });

  it('is explained by the help, after the entry that it names', () => {
    const sections = guideSections([...allHelpEntries, ...collected(files).flatMap((feature) => feature.helpEntries)]);
    const ids = sections.find(({ id }) => id === 'menu')?.entries.map(({ id }) => id) ?? [];
    expect(ids[ids.indexOf('class') + 1]).toBe('trophies');
  });

  it('has its window over the page while it says so, fetched with the first time', async () => {
    const windows = [...featureWindows, ...collected(files).flatMap((feature) => feature.windows)];
    mountOn(createPage(), FeatureWindows, { layers: ['page', 'window'], windows });
    const shown = (): string => textOf(document.querySelector('.trophy'));
    await flushPromises();
    expect([shown(), fetchTrophy.mock.calls.length]).toEqual(['', 0]);
    isHanded.value = true;
    await flushPromises();
    expect([shown(), fetchTrophy.mock.calls.length]).toEqual(['Gold', 1]);
    isHanded.value = false;
    await nextTick();
    expect(shown()).toBe('');
  });

  it('is not drawn in another layer than its own', async () => {
    isHanded.value = true;
    mountOn(createPage(), FeatureWindows, { layers: ['task'], windows: collected(files).flatMap((it) => it.windows) });
    await flushPromises();
    expect(document.querySelector('.trophy')).toBeNull();
  });

  it('stands at its place in the bar, where there is room', () => {
    const before: BarItem = { place: 'work', view: defineComponent(() => () => null) };
    const after: BarItem = { ...before, order: 10 };
    const items = [after, ...collected(files).flatMap((feature) => feature.barItems), before];
    expect(itemsAt(items, 'work', 'wide').map(({ order }) => order)).toEqual([undefined, 5, 10]);
    expect(itemsAt(items, 'work', 'medium').map(({ order }) => order)).toEqual([undefined, 10]);
    expect(itemsAt(items, 'share', 'wide')).toEqual([]);
  });
});
