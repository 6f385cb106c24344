// @vitest-environment happy-dom
import { flushPromises } from '@vue/test-utils';
import { beforeAll, beforeEach, describe, expect, it } from 'vitest';

import { byId, isThere, tap } from '../../app/testing/find';
import { mountOn, setWindow, textOf } from '../../app/testing/mount-on';
import { createPage, type TestPage } from '../../app/testing/page';
import { startRun } from '../../app/testing/run';
import { loadTexts } from '../../kit/i18n';
import { fetchAdvice } from './advice/explain';
import ConsoleOutput from './ConsoleOutput.vue';

const DRIVE = 'from mbrobot import *\nforward()\n';

beforeAll(async () => {
  await loadTexts('de');
  await fetchAdvice();
});
beforeEach(() => localStorage.clear());

/** The console of a page on which this robot is chosen, and a program for the Maqueen Lite runs. */
async function running(robot: string): Promise<TestPage> {
  const page = createPage();
  const { scene } = page.work;
  page.work.openProject({ files: [{ name: 'main.py', text: DRIVE }], scene: scene.value, course: null }, null);
  page.settings.bring({ robot });
  mountOn(page, ConsoleOutput);
  await startRun(page);
  return page;
}

/** The program ends as it does where no robot answers. */
async function fail(page: TestPage): Promise<void> {
  const [message, line] = ['Please connect to Maqueen robot and switch it on.', 2];
  const traceback = `Traceback (most recent call last):\n  File "main.py", line 2, in <module>\nRuntimeError: ${message}\n`;
  const exception = { type: 'RuntimeError', message, traceback, line };
  page.say({ type: 'program-ended', device: 0, ended: { kind: 'exception', exception, timeUs: 1000 } });
  await flushPromises();
}

describe('a program for another robot, in the console', () => {
  it('is told as it begins; one tap takes its robot and runs it again, and there is nothing to say', async () => {
    const page = await running('callibot');
    await expect.poll(() => isThere('misplugged')).toBe(true); // it is fetched
    expect(textOf(byId('misplugged'))).toContain(
      'Dieses Programm ist für den Maqueen Lite, gewählt ist der Calli:bot.',
    );
    const before = page.console.run.value;
    await tap('plug-in');
    expect(page.settings.current.value.robot).toBe('auto');
    expect([page.run.phase.value, page.console.run.value]).toEqual(['starting', before + 1]);
    expect(isThere('misplugged')).toBe(false);
  });

  it('is told once: the card of its error says it instead, with the same tap', async () => {
    const page = await running('callibot');
    await fail(page);
    await expect.poll(() => isThere('take-robot')).toBe(true);
    expect(isThere('misplugged')).toBe(false);
    await tap('take-robot');
    expect([page.settings.current.value.robot, page.run.phase.value]).toEqual(['auto', 'starting']);
  });

  it('is offered its robot where none is chosen, once it fails', async () => {
    const page = await running('none');
    expect(isThere('misplugged')).toBe(false);
    await fail(page);
    await expect.poll(() => isThere('take-robot')).toBe(true);
    await tap('take-robot');
    expect(page.settings.current.value).toMatchObject({ robot: 'auto', showArena: true });
  });

  it('is told by a message on a phone, as long as neither console nor arena is in sight', async () => {
    setWindow(390, 844);
    const page = await running('callibot');
    expect([page.layout.tab.value, page.notices.current.value?.key]).toEqual(['code', 'arena.otherRobot']);
    page.layout.tab.value = 'console';
    expect(page.notices.current.value).toBeNull();
    setWindow(1366);
  });

  it('is nothing to speak of where its robot is chosen', async () => {
    await running('maqueen-lite');
    expect(isThere('misplugged')).toBe(false);
  });
});
