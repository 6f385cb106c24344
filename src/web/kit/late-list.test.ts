// @vitest-environment happy-dom
import { flushPromises, mount } from '@vue/test-utils';
import { describe, expect, it } from 'vitest';
import { h, type Component } from 'vue';

import { lateList } from './late-list';

/** A module with a list of one course, as `import()` gives it. */
const names = { __esModule: true, default: { render: () => h('ul', [h('li', 'Slalom')]) } };

/** Opens the menu: its list is to be shown. */
const open = (List: Component) => mount({ render: () => h('div', [h(List)]) });

describe('the list of a menu', () => {
  it('is not fetched with the page', () => {
    let fetched = 0;
    lateList(() => Promise.resolve(names).finally(() => (fetched += 1)));
    expect(fetched).toBe(0);
  });

  it('is on its way once its button is pointed at or has the focus', () => {
    let fetched = 0;
    const { soon } = lateList(() => {
      fetched += 1;
      return Promise.resolve(names);
    });
    soon.pointerenter();
    expect(fetched).toBe(1);
    soon.focus();
    expect(fetched).toBe(2);
  });

  it('stands in the menu when it is there', async () => {
    const { List } = lateList(() => Promise.resolve(names));
    const menu = open(List);
    expect(menu.text()).toBe('');
    await flushPromises();
    expect(menu.text()).toBe('Slalom');
  });

  it('is asked for again by the open menu without a connection; pointing at its button does no harm', async () => {
    let asked = 0;
    const { List, soon } = lateList(() => {
      asked += 1;
      return asked === 1 ? Promise.reject(new Error('offline')) : Promise.resolve(names);
    });
    soon.pointerenter();
    await flushPromises();
    const menu = open(List);
    await flushPromises();
    expect(menu.text()).toBe('Slalom');
  });
});
