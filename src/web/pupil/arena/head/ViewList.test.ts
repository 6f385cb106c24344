// @vitest-environment happy-dom
import { afterEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import { mountOn, named, setWindow } from '../../../app/testing/mount-on';
import { createPage } from '../../../app/testing/page';
import { newBoard } from '../../several-devices/new-device';
import ViewList from './ViewList.vue';

const SWITCHES = ['trace', 'centre', 'follow', 'celebrate'] as const;

/** The menu of what the arena shows, for a robot or the bare board. */
function menu(robot = 'maqueen-lite') {
  const page = createPage();
  page.settings.change({ robot, device: 'microbit-v2', ...Object.fromEntries(SWITCHES.map((id) => [id, false])) });
  let done = 0;
  const view = { fit: vi.fn(), near: vi.fn(), selected: vi.fn(), trueSize: vi.fn() };
  const mounted = mountOn(page, ViewList, { view, onDone: () => (done += 1) });
  const item = (id: string) => mounted.get<HTMLElement>(`[data-testid="show-${id}"]`);
  const point = (id: string) => mounted.get<HTMLElement>(`[data-testid="${id}"]`).element.click();
  return { page, mounted, item, point, view, done: () => done };
}

describe('the view of the arena', () => {
  afterEach(() => document.documentElement.classList.remove('arena-alone'));

  it('is a menu of sizes, and of switches for what is shown', () => {
    const { mounted } = menu();
    named('Ansicht', '[role="menu"]');
    expect(mounted.findAll('.page-list-item-title').map((it) => it.text())).toEqual([
      ...['Ganze Arena', 'Nahe beim Roboter', 'Wahre Grösse', 'Grosse Arena', 'Ganzer Bildschirm'],
      ...['Spur', 'Drehpunkt', 'Dem Roboter folgen', 'Konfetti'],
    ]);
  });

  it('brings the whole arena, the robot or the true size into sight, and closes', () => {
    const { point, view, done } = menu();
    for (const id of ['fit', 'near', 'zoom-true']) point(id);
    expect([view.fit, view.near, view.trueSize].map((it) => it.mock.calls.length)).toEqual([1, 1, 1]);
    expect(done()).toBe(3);
  });

  it('shows what is selected while something is built, and no larger arena, which has the room already', () => {
    const { mounted, page } = menu();
    expect(mounted.find('[data-testid="zoom-selected"]').exists()).toBe(false);
    page.mode.enter('build');
    return nextTick(() => {
      expect(mounted.find('[data-testid="zoom-selected"]').exists()).toBe(true);
      expect(mounted.find('[data-testid="cinema"]').exists()).toBe(false);
    });
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

  it('has the tones of the drive where it is told in words', async () => {
    const { page, mounted, item } = menu();
    expect(mounted.find('[data-testid="show-tones"]').exists()).toBe(false);
    page.settings.change({ tell: true });
    await nextTick();
    expect(item('tones').attributes('aria-checked')).toBe('true');
    item('tones').element.click();
    expect(page.settings.current.value.tones).toBe(false);
  });

  it('cannot be switched without a robot', () => {
    const { mounted } = menu('none');
    expect(mounted.findAll('[role="menuitemcheckbox"].page-list-item--disabled')).toHaveLength(SWITCHES.length);
  });

  it('is the arena alone on the screen, and leads back', async () => {
    const { page, point, done } = menu();
    point('fullscreen');
    expect([page.alone.isAlone.value, done()]).toEqual([true, 1]);
    await nextTick();
    point('fullscreen');
    expect(page.alone.isAlone.value).toBe(false);
  });

  it('has the robot’s view on a phone, whose head has no room for it', async () => {
    setWindow(390, 800);
    const { page, item } = menu();
    page.settings.change({ cone: false, spots: false });
    await nextTick();
    item('sight').element.click();
    expect(page.settings.current.value).toMatchObject({ cone: true, spots: true });
    setWindow(1280, 800);
  });
});
