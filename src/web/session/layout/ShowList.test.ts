// @vitest-environment happy-dom
import { afterEach, describe, expect, it } from 'vitest';
import { nextTick } from 'vue';

import { mountOn, named, setWindow } from '../../app/testing/mount-on';
import { createPage } from '../../app/testing/page';
import { newBoard } from '../../pupil/several-devices/new-device';
import ShowList from './ShowList.vue';

const SWITCHES = ['cone', 'spots', 'centre', 'trace', 'follow', 'tell', 'celebrate'] as const;

/** The menu of what the arena shows, for a robot or the bare board. */
function menu(robot = 'maqueen-lite') {
  const page = createPage();
  page.settings.change({ robot, device: 'microbit-v2', ...Object.fromEntries(SWITCHES.map((id) => [id, false])) });
  let done = 0;
  const mounted = mountOn(page, ShowList, { onDone: () => (done += 1) });
  const item = (id: string) => mounted.get<HTMLElement>(`[data-testid="show-${id}"]`);
  return { page, mounted, item, done: () => done };
}

describe('what the arena shows', () => {
  afterEach(() => document.documentElement.classList.remove('arena-alone'));

  it('is a menu of switches with a name and a few words each', () => {
    const { mounted } = menu();
    named('Zeigen, was der Roboter spürt', '[role="menu"]');
    expect(mounted.findAll('[role="menuitemcheckbox"] .page-list-item-title').map((it) => it.text())).toEqual([
      'Messkegel',
      'Liniensensoren',
      'Drehpunkt',
      'Spur',
      'Dem Roboter folgen',
      'Fahrt ansagen',
      'Konfetti',
    ]);
    expect(mounted.get('[data-testid="show-trace"]').text()).toContain('Wo er seit dem Start durchgefahren ist');
  });

  it.each(SWITCHES)('%s is switched on and off again, and nothing else', async (id) => {
    const { page, item, done } = menu();
    expect(item(id).attributes('aria-checked')).toBe('false');
    item(id).element.click();
    await nextTick();
    expect(item(id).attributes('aria-checked')).toBe('true');
    expect(SWITCHES.filter((other) => page.settings.current.value[other])).toEqual([id]);
    item(id).element.click();
    expect(SWITCHES.filter((other) => page.settings.current.value[other])).toEqual([]);
    expect(done()).toBe(0); // the menu stays open
  });

  it('shows what is sent by radio where there are several devices, with a robot or without', async () => {
    const { page, mounted, item } = menu('none');
    expect(mounted.find('[data-testid="show-packets"]').exists()).toBe(false);
    page.work.addDevice({ ...newBoard(page), name: 'Zwei' }, 'Eins');
    await nextTick();
    item('packets').element.click();
    await nextTick();
    expect(page.settings.current.value.packets).toBe(true);
  });

  it('has the tones of the drive beside its words: on with them, and off alone', async () => {
    const { page, mounted, item } = menu();
    expect(mounted.find('[data-testid="show-tones"]').exists()).toBe(false);
    item('tell').element.click();
    await nextTick();
    expect(item('tones').attributes('aria-checked')).toBe('true');
    item('tones').element.click();
    await nextTick();
    expect(item('tones').attributes('aria-checked')).toBe('false');
    expect([page.settings.current.value.tell, page.settings.current.value.tones]).toEqual([true, false]);
  });

  it('cannot be switched without a robot', () => {
    const { mounted } = menu('none');
    expect(mounted.findAll('[role="menuitemcheckbox"].page-list-item--disabled')).toHaveLength(SWITCHES.length);
  });

  it('can be the arena alone on a phone: the menu closes', async () => {
    setWindow(390, 800);
    const { page, item, mounted, done } = menu();
    item('fullscreen').element.click();
    expect(page.alone.isAlone.value).toBe(true);
    expect(done()).toBe(1);
    await nextTick();
    expect(mounted.find('[data-testid="show-fullscreen"]').exists()).toBe(false);
  });

  it.each([390, 1024])('leads to the projector view on a page of %i px, also out of the arena alone', async (width) => {
    setWindow(width, 800);
    const { page, item, mounted, done } = menu();
    page.layout.tab.value = 'arena';
    page.alone.enter();
    await nextTick();
    item('projector').element.click();
    await nextTick();
    expect([page.alone.isAlone.value, page.alone.hasSide.value, done()]).toEqual([true, true, 1]);
    expect(mounted.find('[data-testid="show-projector"]').exists()).toBe(false);
    page.alone.leave();
  });

  it('has no such point on a larger screen, where it is a button of its own', () => {
    expect(menu().mounted.find('[data-testid="show-fullscreen"]').exists()).toBe(false);
  });
});
