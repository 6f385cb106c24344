// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import { sceneDefaults, type Scene } from '#scene/scene';
import { briefOf } from '#simulation/task/task-brief';
import type { RobotVerdict, Verdict } from '#simulation/task/verdict';

import { verdictAtStart } from '#simulation/task/verdict-at-start';
import { editingPage, keyOn, press, samples } from '../../app/testing/editing';
import { byId, isThere, tap } from '../../app/testing/find';
import { mountOn, named, setWindow, textOf } from '../../app/testing/mount-on';
import { show, startRun } from '../../app/testing/run';
import { newBoard } from '../../pupil/several-devices/new-device';
import ProjectorView from './ProjectorView.vue';

const OBJECTS = [samples.checkpoint, samples.target];

/** The projector view of a course with a task, as it opens. */
async function projector(more: Partial<Scene> = {}, objects: Parameters<typeof editingPage>[0] = OBJECTS) {
  const task = { ...sceneDefaults.task, ...more.task, card: { ...sceneDefaults.card, title: 'Einparken' } };
  const page = await editingPage(objects, { description: 'Fahr **los**.', ...more, task });
  page.alone.hasSide.value = true;
  page.alone.enter();
  const mounted = mountOn(page, ProjectorView);
  await vi.dynamicImportSettled();
  const texts = (css: string) => mounted.findAll(css).map((it) => textOf(it.element));
  const tell = async (verdict: Partial<Verdict>, timeUs = 0) => {
    const { checkpoints } = briefOf(page.scene());
    expect(checkpoints.length).toBe(objects?.includes(samples.checkpoint) ? 1 : 0);
    await show(page, { timeUs, verdict: { ...verdictAtStart(page.scene()), ...verdict } });
    await nextTick();
  };
  return { ...page, mounted, texts, tell };
}

const timer = (): string => textOf(byId('timer'));
const said = (): string => textOf(byId('timer-said'));

describe('the projector view', () => {
  beforeEach(() => {
    setWindow(1280, 720);
    vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout', 'Date'] });
  });
  afterEach(() => {
    vi.useRealTimers();
    document.documentElement.className = '';
  });

  it('has the task in words, its goals and its rules', async () => {
    const { texts } = await projector();
    expect(texts('h2')).toEqual(['Einparken']);
    expect(textOf(byId('projector-text'))).toBe('Fahr los.');
    expect(texts('.goals li')).toEqual(['Fahr durch den Kontrollpunkt (offen)', 'Fahr dann ins Ziel (offen)']);
    expect(texts('.rules li')).toEqual(['ohne Hilfe der Hand']);
  });

  it('says so where there is no task, and keeps its clocks', async () => {
    const { texts } = await projector({ description: '' }, []);
    expect(texts('.nothing')).toEqual(['Dieser Parcours stellt keine Aufgabe.']);
    expect([timer(), textOf(byId('run-clock'))]).toEqual(['10:00', '0:00.0']);
  });

  it('ticks the goals and shows the clock of the run while the robot drives', async () => {
    const page = await projector();
    await startRun(page);
    await page.tell({ checkpoints: { passed: 1, of: 1 } }, 62_340_000);
    expect(page.texts('.goals .ok')).toEqual(['Fahr durch den Kontrollpunkt (geschafft)']);
    expect(textOf(byId('run-clock'))).toBe('1:02.3');
    expect(isThere('projector-result')).toBe(false);
  });

  it('says how many seconds the task leaves', async () => {
    const page = await projector({ task: { ...sceneDefaults.task, seconds: 20 } });
    await startRun(page);
    await page.tell({}, 15_500_000);
    expect(page.texts('.label .short')).toEqual(['· noch 5 s']);
  });

  it('has the verdict in the place of the text: passed, when, touches, stars', async () => {
    const page = await projector({ task: { ...sceneDefaults.task, stars: [20, 30] } });
    await startRun(page);
    await page.tell({ state: 'passed', atMs: 12_340, touches: 2, stars: 3 });
    expect(textOf(byId('projector-word'))).toBe('Geschafft!');
    expect(page.texts('.figures li')).toEqual(['12.3 s', '2 Berührungen']);
    expect(page.mounted.get('.result .stars').attributes('aria-label')).toBe('3 von 3 Sternen');
    expect(isThere('projector-text')).toBe(false);
  });

  it('says why it was not', async () => {
    const page = await projector();
    await startRun(page);
    await page.tell({ state: 'failed', reason: 'touched', by: null, atMs: 4000, touches: 1 });
    expect(textOf(byId('projector-word'))).toBe('Noch nicht geschafft');
    expect(page.texts('.figures li')).toEqual(['4.0 s', '1 Berührung']);
    expect(page.texts('.why')).toEqual([
      'Der Roboter hat den Rand der Arena berührt.',
      'Bremse früher oder lenke früher ein.',
    ]);
  });

  it('says that help does not count', async () => {
    const page = await projector();
    await startRun(page);
    await page.tell({ state: 'helped', help: ['hand'], atMs: 4000 });
    expect(textOf(byId('projector-word'))).toBe('Mit Hilfe der Hand');
    expect(page.texts('.why')).toEqual(['Das zählt nicht: Versuche es ohne Hilfe.']);
  });

  it('shows the error of a program that broke off', async () => {
    const page = await projector();
    await startRun(page);
    await page.tell({});
    const exception = {
      type: 'ZeroDivisionError',
      message: 'divide by zero',
      line: 2,
      traceback:
        'Traceback (most recent call last):\n  File "main.py", line 2, in <module>\nZeroDivisionError: divide by zero\n',
    };
    page.say({ type: 'program-ended', ended: { kind: 'exception', exception, timeUs: 1000 }, device: 0 });
    await nextTick();
    expect(textOf(byId('projector-word'))).toBe('Noch nicht geschafft');
    expect(page.texts('.why')[0]).toMatch(/^Fehler/);
  });

  it('has the task again as soon as all is back at the start', async () => {
    const page = await projector();
    await startRun(page);
    await page.tell({ state: 'passed', atMs: 1000 });
    await page.run.reset();
    await nextTick();
    expect([isThere('projector-result'), isThere('projector-text')]).toEqual([false, true]);
  });

  it('says of each robot how it did, and when', async () => {
    const page = await projector({ task: { ...sceneDefaults.task, robots: 'all' } });
    page.work.addDevice({ ...newBoard(page), name: 'Ben' }, 'Ada');
    const robot = (device: string, more: Partial<RobotVerdict>): RobotVerdict => ({
      ...{ device, state: 'passed', atMs: 9000, reason: null, by: null, place: null, touches: 0 },
      ...{ checkpoints: { passed: 1, of: 1 }, targets: { reached: 1, of: 1 } },
      ...more,
    });
    await startRun(page);
    const robots = [robot('Ada', {}), robot('Ben', { state: 'failed', reason: 'touched', atMs: 4500 })];
    await page.tell({ state: 'failed', reason: 'touched', atMs: 9000, robots });
    await vi.dynamicImportSettled();
    expect(page.texts('.robots li')).toEqual(['1Ada angekommen nach 9.0 s', '2Ben angestossen nach 4.5 s']);
  });

  describe('its timer', () => {
    it('is set, started, paused and put back', async () => {
      await projector();
      await press('Timer auf 5 min stellen');
      await press('1 min mehr');
      expect(timer()).toBe('6:00');
      await press('1 min weniger');
      await press('Start', '.acts button');
      await vi.advanceTimersByTimeAsync(2000);
      expect(timer()).toBe('4:58');
      await press('Pause', '.acts button');
      await vi.advanceTimersByTimeAsync(5000);
      expect(timer()).toBe('4:58');
      await press('Weiter', '.acts button');
      await vi.advanceTimersByTimeAsync(1000);
      expect(timer()).toBe('4:57');
      await press('Timer zurücksetzen');
      expect(timer()).toBe('5:00');
    });

    it('tells a screen reader the full minutes and the end, and nothing else', async () => {
      await projector();
      await tap('timer-5');
      await tap('timer-start');
      await vi.advanceTimersByTimeAsync(59_000);
      expect(said()).toBe('');
      await vi.advanceTimersByTimeAsync(1000);
      expect(said()).toBe('Noch 4 Minuten');
      await vi.advanceTimersByTimeAsync(180_000);
      expect(said()).toBe('Noch 1 Minute');
      await vi.advanceTimersByTimeAsync(60_000);
      expect([said(), timer(), byId('timer').dataset['phase']]).toEqual(['Die Zeit ist um', '0:00', 'over']);
      expect(textOf(document.querySelector('.clock--over .label'))).toBe('Die Zeit ist um');
    });

    it('goes on while the view is left, and after a reload', async () => {
      const page = await projector();
      await tap('timer-10');
      await tap('timer-start');
      page.mounted.vm.$.appContext.app.unmount();
      await vi.advanceTimersByTimeAsync(30_000);
      mountOn(page, ProjectorView);
      expect(timer()).toBe('9:30');
      document.body.innerHTML = '<section id="menus"></section>';
      await vi.advanceTimersByTimeAsync(30_000);
      await projector(); // another page of the same tab
      expect(timer()).toBe('9:00');
    });

    it('asks for a sound only when it is switched on, and then unmutes the page', async () => {
      const page = await projector();
      page.settings.change({ muted: true });
      const asked = vi.spyOn(page.sound, 'output').mockReturnValue(null);
      await nextTick();
      named('Ton am Ende').click();
      await nextTick();
      expect([page.settings.current.value.muted, named('Ton am Ende').getAttribute('aria-pressed')]).toEqual([
        false,
        'true',
      ]);
      expect(asked).toHaveBeenCalled();
    });
  });

  describe('its keys', () => {
    it('start, pause and go on with Space, and go back with page up, as on a remote', async () => {
      const page = await projector();
      const begun = async (count: number): Promise<void> => {
        await vi.waitFor(() => expect(page.sent.filter(({ type }) => type === 'run')).toHaveLength(count));
        page.say({ type: 'started' });
        await nextTick();
        expect(page.run.phase.value).toBe('running');
      };
      await keyOn(document.body, ' ');
      await begun(1);
      await keyOn(document.body, ' ');
      expect(page.run.phase.value).toBe('paused');
      await keyOn(document.body, ' ');
      expect(page.run.phase.value).toBe('running');
      await keyOn(document.body, 'PageUp');
      await vi.waitFor(() => expect(page.run.phase.value).toBe('ready'));
      await keyOn(document.body, 'PageDown');
      await begun(2);
    });

    it('start and pause the timer with T', async () => {
      await projector();
      await keyOn(document.body, 't');
      await vi.advanceTimersByTimeAsync(1000);
      await keyOn(document.body, 'T');
      expect([timer(), byId('timer').dataset['phase']]).toEqual(['9:59', 'paused']);
    });

    it('leave Space to a button that has the keyboard', async () => {
      const page = await projector();
      const event = await keyOn(byId('timer-20'), ' ');
      expect([event.defaultPrevented, page.run.phase.value]).toEqual([false, 'ready']);
    });

    it('lead back with Escape; the arena alone remains with its own button', async () => {
      const page = await projector();
      await tap('projector-hide');
      expect([page.alone.isAlone.value, page.alone.hasSide.value]).toEqual([true, false]);
      page.alone.hasSide.value = true;
      await nextTick();
      await keyOn(document.body, 'Escape');
      expect([page.alone.isAlone.value, page.alone.hasSide.value]).toEqual([false, false]);
    });
  });
});
