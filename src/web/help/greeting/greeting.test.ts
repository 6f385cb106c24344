// @vitest-environment happy-dom
import { flushPromises } from '@vue/test-utils';
import { beforeAll, beforeEach, describe, expect, it, vi } from 'vitest';
import { defineComponent, h, nextTick } from 'vue';

import { byId, isThere, tap } from '../../app/testing/find';
import { mountOn, named, setWindow, textOf } from '../../app/testing/mount-on';
import { createPage, type TestPage } from '../../app/testing/page';
import { startRun } from '../../app/testing/run';
import FirstSteps from '../tour/FirstSteps.vue';
import { useGreeting } from './use-greeting';
import WelcomeCard from './WelcomeCard.vue';

beforeEach(() => setWindow(1400, 800));

describe('the greeting of a first visit', () => {
  beforeAll(() => Promise.all([import('../tour/TourBubble.vue'), import('../../session/layout/stages/change-stage'), import('../../session/work/catalogue/ready-courses')])); // prettier-ignore
  /** A page with the places where the greeting stands. */
  async function visit(prepare: (page: TestPage) => void = () => undefined): Promise<TestPage> {
    document.body.insertAdjacentHTML(
      'beforeend',
      '<div class="app"><div class="pane-console"></div><div class="pane-code"></div></div>',
    );
    const page = createPage();
    prepare(page);
    const Host = defineComponent(() => {
      const isGreeted = useGreeting(page);
      return () => [isGreeted.value ? h(WelcomeCard) : null, h(FirstSteps)];
    });
    mountOn(page, Host);
    await flushPromises();
    return page;
  }

  it('stands in the empty console and offers three beginnings', async () => {
    await visit();
    expect(byId('welcome').closest('.pane-console')).not.toBeNull();
    named('Willkommen! Womit möchtest du beginnen?');
    expect([...document.querySelectorAll('.stage b')].map(textOf)).toEqual([
      '1. Mikrocomputer',
      '2. Roboter',
      '3. Parcours bauen',
    ]);
  });

  it('stands below the program on a phone, and only there', async () => {
    setWindow(390, 800);
    const page = await visit();
    expect(byId('welcome').closest('.pane-code')).not.toBeNull();
    page.layout.tab.value = 'arena';
    await nextTick();
    expect(isThere('welcome')).toBe(false);
  });

  it('is not shown to whoever has been greeted, has written something, or looks at a page', async () => {
    await visit((page) => page.settings.change({ welcomed: true }));
    expect(isThere('welcome')).toBe(false);
    await visit((page) => page.work.setText('main.py', 'meins = 1\n'));
    expect(isThere('welcome')).toBe(false);
    await visit((page) => page.router.open('robots'));
    expect(isThere('welcome')).toBe(false);
    history.replaceState(null, '', '/');
  });

  it('does not come over the output of a run whose program was then taken back', async () => {
    const page = await visit();
    const { text } = page.work.open.value;
    page.work.setText('main.py', 'meins = 1\n');
    await startRun(page);
    await page.run.reset();
    page.work.setText('main.py', text);
    await nextTick();
    expect(page.settings.current.value.welcomed).toBe(false);
    expect(isThere('welcome')).toBe(false);
  });

  it('goes for good with “Gleich loslegen”', async () => {
    const page = await visit();
    await tap('welcome-start');
    expect(isThere('welcome')).toBe(false);
    expect(page.settings.current.value.welcomed).toBe(true);
  });

  it('goes for good with the first run', async () => {
    const page = await visit();
    await startRun(page);
    await nextTick();
    expect(isThere('welcome')).toBe(false);
    expect(page.settings.current.value.welcomed).toBe(true);
  });

  it('begins the tour', async () => {
    const page = await visit();
    await tap('welcome-tour');
    await flushPromises();
    expect(page.tour.isOpen.value).toBe(true);
    expect(isThere('tour')).toBe(true);
    expect(isThere('welcome')).toBe(false);
  });

  it('makes room for a tour that is done at its last step and begins anew the next time', async () => {
    const page = await visit((it) => it.settings.change({ tourStep: 'help', language: 'de' }));
    page.tour.open();
    await flushPromises();
    expect(textOf(byId('tour-next'))).toBe('Fertig');
    await tap('tour-next');
    expect(isThere('tour')).toBe(false);
    expect(page.settings.current.value.tourStep).toBeNull();
  });

  it('opens a program that needs no robot for the microcomputer, without the arena', async () => {
    const page = await visit();
    await tap('welcome-board');
    await vi.waitFor(() => expect(page.settings.current.value.showArena).toBe(false));
    expect(page.work.find('main.py')?.text).not.toMatch(/maqueen|callibot|mbrobot/i);
    expect(page.layout.tab.value).toBe('code');
    expect(isThere('welcome')).toBe(false);
  });

  it.each([
    ['robot', false],
    ['all', true],
  ] as const)('shows the arena for “%s”, the tools for building: %s', async (stage, tools) => {
    const page = await visit();
    await tap(`welcome-${stage}`);
    await vi.waitFor(() => expect(page.settings.current.value.showTools).toBe(tools));
    expect(page.settings.current.value.showArena).toBe(true);
  });

  it('opens the task of the first mission for “robot”', async () => {
    const page = await visit();
    await tap('welcome-robot');
    await vi.waitFor(() => expect(page.task.isOpen.value).toBe(true));
    expect(page.task.text.value.title).toBe('Eine Sekunde vorwärts');
  });

  it('opens an empty floor for “all”, the pen in hand; the program stays', async () => {
    const page = await visit();
    const program = page.work.find('main.py')?.text;
    await tap('welcome-all');
    await vi.waitFor(() => expect(page.editor.tool.value).toBe('pen'));
    expect(page.work.scene.value.objects).toEqual([]);
    expect(page.work.find('main.py')?.text).toBe(program);
    expect(page.task.isOpen.value).toBe(false);
  });
});
