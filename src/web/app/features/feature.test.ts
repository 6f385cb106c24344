// @vitest-environment happy-dom
import { afterEach, describe, expect, it } from 'vitest';
import { effectScope } from 'vue';

import { guideSections } from '../../help/guide/entries';
import {
  collected,
  menuGroups,
  type Contribution,
  type HelpEntry,
  type MenuEntry,
  type MenuHost,
} from '../../kit/features/feature';
import type { FeaturePage } from '../../kit/features/feature-page';
import { createRouter } from '../../session/layout/router';
import { allHelpEntries } from './all-help-entries';
import { featurePages } from './feature-pages';

/** A made-up feature: its folder holds these three files, and no other file names it. */
interface MadeUp {
  readonly pages: readonly FeaturePage[];
  readonly contribution: Contribution;
  readonly helpEntries: readonly HelpEntry[];
}
const files: Readonly<Record<string, MadeUp>> = {
  '../teacher/trophies/': {
    pages: [{ name: 'trophies', hasIds: true, load: () => Promise.reject(new Error('made up')) }],
    contribution: {
      menu: () => [
        {
          group: 'pages',
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
    const before = { group: 'pages', order: 20, entries: (): readonly MenuEntry[] => [] } as const;
    const [group] = menuGroups([...own, before]);
    expect([group?.name, group?.parts.map(({ order }) => order)]).toEqual(['pages', [20, 25]]);
    const menu: MenuHost = { leaveFor: (act) => act(), openDialog: () => undefined, showInside: () => undefined };
    for (const entry of group?.parts[1]?.entries() ?? []) entry.act(menu);
    expect(location.hash).toBe('#trophies/gold');
  });

  it('is explained by the help, after the entry that it names', () => {
    const sections = guideSections([...allHelpEntries, ...collected(files).flatMap((feature) => feature.helpEntries)]);
    const ids = sections.find(({ id }) => id === 'menu')?.entries.map(({ id }) => id) ?? [];
    expect(ids[ids.indexOf('class') + 1]).toBe('trophies');
  });
});
