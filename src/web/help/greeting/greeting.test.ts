// @vitest-environment happy-dom
import { flushPromises } from '@vue/test-utils';
import { beforeAll, beforeEach, describe, expect, it, vi } from 'vitest';
import { defineComponent, h, nextTick } from 'vue';

import { byId, isThere, tap } from '../../app/testing/find';
import { mountOn, setWindow, textOf } from '../../app/testing/mount-on';
import { createPage, type TestPage } from '../../app/testing/page';
import { startRun } from '../../app/testing/run';
import { firstCourse } from '../../session/work/catalogue/first-course';
import FirstSteps from '../tour/FirstSteps.vue';
import { setUp } from './set-up';
import WelcomeSlot from './WelcomeSlot.vue';

beforeEach(() => {
  localStorage.clear();
  setWindow(1400, 800);
});

describe('the greeting of a first visit', () => {
  beforeAll(() => Promise.all([import('./WelcomeCard.vue'), import('../tour/TourBubble.vue'), import('../../session/layout/stages/change-stage'), import('../../session/work/catalogue/ready-courses')])); // prettier-ignore
  /** A page with the place of the card beside the program, and that above the course of a phone. */
  async function visit(prepare: (page: TestPage) => void = () => undefined): Promise<TestPage> {
    const page = createPage();
    prepare(page);
    page.scope.run(() => setUp(page));
    const Host = defineComponent(() => () => [
      h(WelcomeSlot),
      h('div', { class: 'pane-arena' }, [h(WelcomeSlot, { inArena: true })]),
      h(FirstSteps),
    ]);
    mountOn(page, Host);
    await flushPromises();
    return page;
  }

  it('stands in the place of the card and offers three beginnings', async () => {
    const page = await visit();
    expect(page.layout.card.value).toBe('open');
    expect(byId('welcome').closest('.pane-arena')).toBeNull();
    expect(textOf(byId('welcome').querySelector('h2'))).toBe('Womit möchtest du beginnen?');
    expect([...document.querySelectorAll('.choice')].map(textOf)).toEqual([
      'Fahren lernen12 Missionen',
      'Mikrocomputer',
      'Selber bauen',
    ]);
  });

  it('stands above the course on a phone, which begins there', async () => {
    setWindow(390, 800);
    const page = await visit();
    expect(page.layout.tab.value).toBe('arena');
    expect(byId('welcome').closest('.pane-arena')).not.toBeNull();
  });

  it('stays while somebody writes: it goes with a choice, not with a key', async () => {
    const page = await visit();
    page.work.setText('main.py', 'meins = 1\n');
    await nextTick();
    expect(isThere('welcome')).toBe(true);
  });

  it('is not shown to whoever has been greeted, or looks at a page', async () => {
    await visit((page) => page.settings.change({ welcomed: true }));
    expect(isThere('welcome')).toBe(false);
    await visit((page) => page.router.open('robots'));
    expect(isThere('welcome')).toBe(false);
    history.replaceState(null, '', '/');
    await visit((page) => {
      const { project } = page.work.work.value;
      page.work.openProject({ ...project, task: { version: 1, handedOut: true } }, null);
    });
    expect(isThere('welcome')).toBe(false); // whoever comes for a task of the class has begun already
  });

  it('goes for good with the first run, which leaves the card of the mission', async () => {
    const page = await visit();
    await startRun(page);
    await nextTick();
    expect(isThere('welcome')).toBe(false);
    expect(page.settings.current.value.welcomed).toBe(true);
    expect(page.layout.card.value).toBe('open');
  });

  it('comes back on request, with the keys, until something else is opened', async () => {
    const page = await visit((it) => it.settings.change({ welcomed: true }));
    page.greeting.ask();
    await flushPromises();
    expect(document.activeElement).toBe(byId('welcome').querySelector('h2'));
    page.work.openings.value += 1;
    await nextTick();
    expect(isThere('welcome')).toBe(false);
  });

  it('is never in the way of a task that was handed out', async () => {
    const page = await visit();
    page.work.setTask({ version: 1, checks: [{ type: 'goals' }], handedOut: true });
    page.greeting.ask();
    await nextTick();
    expect(isThere('welcome')).toBe(false);
  });

  it('makes room for a tour, whose last step leads to the first mission', async () => {
    const page = await visit((it) => it.settings.change({ tourStep: 'help', language: 'de' }));
    page.tour.open();
    await flushPromises();
    expect(isThere('welcome')).toBe(false);
    expect(textOf(byId('tour-next'))).toBe('Fertig');
    page.task.close();
    await tap('tour-next');
    expect(isThere('tour')).toBe(false);
    expect(page.settings.current.value.tourStep).toBeNull();
    await vi.waitFor(() => expect(page.task.isOpen.value).toBe(true));
    expect(page.task.text.value.title).toBe('Eine Sekunde vorwärts');
  });

  it('opens a program that needs no robot for the microcomputer, without the arena', async () => {
    const page = await visit();
    await tap('welcome-board');
    await vi.waitFor(() => expect(page.settings.current.value.showArena).toBe(false));
    expect(page.work.find('main.py')?.text).not.toMatch(/maqueen|callibot|mbrobot/i);
    expect(page.layout.tab.value).toBe('code');
    expect(isThere('welcome')).toBe(false);
  });

  it('leads to the first mission', async () => {
    const page = await visit();
    await tap('welcome-robot');
    await vi.waitFor(() => expect(page.settings.current.value.welcomed).toBe(true));
    expect([page.task.text.value.title, page.layout.card.value]).toEqual(['Eine Sekunde vorwärts', 'open']);
  });

  it('leads to the first mission that was not passed yet', async () => {
    const page = await visit((it) => it.task.stars.keep(firstCourse!.id, 1));
    await tap('welcome-robot');
    await vi.waitFor(() => expect(page.task.text.value.title).toBe('Um die Ecke'));
  });

  it('opens an empty floor with the tools for building; the program stays', async () => {
    const page = await visit();
    const program = page.work.find('main.py')?.text;
    await tap('welcome-all');
    await vi.waitFor(() => expect(page.work.scene.value.objects).toEqual([]));
    await vi.waitFor(() => expect(page.mode.current.value).toBe('build'));
    expect(page.work.find('main.py')?.text).toBe(program);
    expect(page.layout.card.value).toBeNull();
  });
});
