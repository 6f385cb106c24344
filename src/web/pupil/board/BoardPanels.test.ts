// @vitest-environment happy-dom
import { describe, expect, it } from 'vitest';
import { nextTick } from 'vue';

import { mountOn, named } from '../../app/testing/mount-on';
import { createPage } from '../../app/testing/page';
import BoardPanels from './BoardPanels.vue';

/** The four buttons below the board. */
function panels() {
  const page = createPage();
  page.settings.change({ panel: null });
  const mounted = mountOn(page, BoardPanels);
  const press = async (name: string) => {
    named(name, '.tabs button').click();
    await nextTick();
  };
  const unfolded = () => mounted.findAll('.tabs button').map((it) => it.attributes('aria-expanded'));
  return { page, mounted, press, unfolded };
}

describe('what can be unfolded below the board', () => {
  it('is called sensors, radio, data log and in the hand; at first all is folded', () => {
    const { mounted, unfolded } = panels();
    expect(mounted.findAll('.tabs button').map((it) => it.text())).toEqual([
      ...['Sensoren', 'Funk', 'Datenlog', 'In der Hand'],
    ]);
    expect(unfolded()).toEqual(['false', 'false', 'false', 'false']);
    named('Sensoren, Funk, Datenlog und In der Hand', '[role="group"]');
  });

  it('is one thing at a time, and the page remembers which', async () => {
    const { page, press, unfolded } = panels();
    await press('Funk');
    expect(unfolded()).toEqual(['false', 'true', 'false', 'false']);
    expect(page.settings.current.value.panel).toBe('radio');
    await press('Datenlog');
    expect(unfolded()).toEqual(['false', 'false', 'true', 'false']);
    expect(page.settings.current.value.panel).toBe('log');
  });

  it('is folded by a second press', async () => {
    const { page, press, unfolded } = panels();
    await press('Sensoren');
    await press('Sensoren');
    expect(unfolded()).toEqual(['false', 'false', 'false', 'false']);
    expect(page.settings.current.value.panel).toBeNull();
  });

  it('is a region that its button names for screen readers', async () => {
    const { press } = panels();
    await press('Funk');
    const region = named('Funk', 'section');
    expect(named('Funk', '.tabs button').getAttribute('aria-controls')).toBe(region.id);
    expect(named('Datenlog', '.tabs button').getAttribute('aria-controls')).toBeNull();
  });

  it('has a dot at what holds something that is not in sight', async () => {
    const { page, press, mounted } = panels();
    const dots = () => mounted.findAll('.tabs button').map((it) => it.find('.badge').exists());
    expect(dots()).toEqual([false, false, false, false]);
    page.radio.send('hallo');
    page.dataLog.take([{ type: 'row', headings: ['x'], values: ['1'], timeUs: 0 }]);
    await nextTick();
    expect(dots()).toEqual([false, true, true, false]);
    await press('Funk');
    expect(dots()).toEqual([false, false, true, false]);
  });
});
