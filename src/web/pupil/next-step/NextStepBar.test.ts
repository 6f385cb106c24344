// @vitest-environment happy-dom
import { beforeAll, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import type { SceneObject } from '#scene/scene';
import type { Verdict } from '#simulation/task/verdict';

import { editingPage, press, samples } from '../../app/testing/editing';
import { ladderOf } from '#catalogue/missions';
import type { MissionCourse } from '#catalogue/mission';
import { byId, isThere, tap } from '../../app/testing/find';
import { mountOn, setWindow, textOf } from '../../app/testing/mount-on';
import { createPage } from '../../app/testing/page';
import { show, startRun } from '../../app/testing/run';
import { useCourses } from '../../session/work/use-courses';
import '../../session/work/catalogue/ready-courses';
import { fetchAdvice } from '../console/advice/explain';
import NextStepBar from './NextStepBar.vue';
import { verdictAtStart } from '#simulation/task/verdict-at-start';

/**
 * Mounts the bar at the arena's foot on a page that somebody knows; `tell` delivers the run's next picture, with the changes of its verdict since the
 * start.
 */
async function bar(objects: readonly SceneObject[], seconds: number | null = null, noTouch = false) {
  const page = await editingPage(objects, { task: { seconds, noTouch } });
  page.settings.change({ celebrate: false, welcomed: true, showTools: false });
  const shown: unknown[] = [];
  const mounted = mountOn(page, NextStepBar, { onShow: (at: unknown) => shown.push(at) });
  const tell = async (verdict: Partial<Verdict>, timeUs = 0) => {
    await show(page, { timeUs, verdict: { ...verdictAtStart(page.scene()), ...verdict } });
    await nextTick();
  };
  const goals = () => mounted.findAll('.goal').map((it) => it.attributes('aria-label'));
  const said = () => textOf(mounted.get('[aria-live="polite"]').element);
  const text = () => textOf(mounted.get('.say').element);
  const end = async () => {
    page.say({ type: 'program-ended', ended: { kind: 'finished', exception: null, timeUs: 0 }, device: 0 });
    await nextTick();
  };
  return { ...page, mounted, tell, end, goals, said, text, shown };
}

const two = { ...samples.checkpoint, id: 'two', at: [700, 200], number: 2 } as const;

describe('the bar at the foot of the arena', () => {
  beforeAll(() => import('./StepGoals.vue')); // comes late; here it is there at once

  it('tells before the start what there is to do, and starts', async () => {
    const page = await bar([samples.checkpoint, two, samples.target]);
    expect(page.text()).toBe('BereitFahr der Reihe nach durch die Kontrollpunkte 1 bis 2 · Fahr dann ins Ziel');
    expect(byId('verdict').dataset['state']).toBe('open');
    await press('Los geht’s');
    expect(page.run.phase.value).toBe('starting');
  });

  it('follows the course while it is edited', async () => {
    const { text, editor } = await bar([samples.checkpoint, samples.target]);
    editor.apply({ type: 'remove', ids: ['one'] });
    await nextTick();
    expect(text()).toBe('BereitErreiche das Ziel');
  });

  it('counts what is done, and says it once for screen readers', async () => {
    const page = await bar([samples.checkpoint, two, samples.target]);
    await startRun(page);
    await page.tell({});
    await page.tell({ checkpoints: { passed: 1, of: 2 } });
    expect([page.goals(), page.said()]).toEqual([
      ['Kontrollpunkte: 1 von 2', 'Ziel: 0 von 1'],
      'Kontrollpunkte: 1 von 2.',
    ]);
    await page.tell({ checkpoints: { passed: 2, of: 2 } });
    expect(page.said()).toBe('Kontrollpunkte: 2 von 2.');
    expect(page.mounted.findAll('.sign--done')).toHaveLength(2);
  });

  it('leaves it to the telling of the drive, where that is switched on, to say what is reached', async () => {
    const page = await bar([samples.checkpoint, two]);
    page.settings.change({ tell: true });
    await startRun(page);
    await page.tell({});
    await page.tell({ checkpoints: { passed: 1, of: 2 } });
    expect([page.text(), page.said()]).toEqual(['Kontrollpunkte: 1 von 2.', '']);
    await page.tell({ state: 'passed', atMs: 2000, checkpoints: { passed: 2, of: 2 } });
    expect(page.said()).toBe('Geschafft! Aufgabe gelöst in 2.0 s. Nochmals');
  });

  it('shows the stars that were won, and none where the task gives none', async () => {
    const page = await bar([samples.target]);
    await startRun(page);
    await page.tell({ state: 'passed', atMs: 900, stars: null });
    await vi.dynamicImportSettled();
    expect(isThere('verdict-stars')).toBe(false);
    await page.tell({ state: 'passed', atMs: 1000, stars: 2 });
    await vi.dynamicImportSettled();
    expect(byId('verdict-stars').getAttribute('aria-label')).toBe('2 von 3 Sternen');
  });

  it('hands in a task of a series before it leads on, and keeps that in mind until another work is opened', async () => {
    const page = await bar([samples.target]);
    const { task, work } = page;
    work.setTask({ version: 1, id: 'A', handedOut: true });
    work.setHandIn({ version: 1, series: { series: 'week', task: '1' } });
    await startRun(page);
    await page.tell({ state: 'passed', atMs: 900 });
    expect(textOf(byId('step-hand-in'))).toBe('Abgeben');
    await tap('step-hand-in');
    expect(task.handIn.isOpen.value).toBe(true);
    task.handIn.done();
    await nextTick();
    expect(isThere('step-hand-in')).toBe(false); // now the series has its way on there
    work.openProject({ ...work.work.value.project }, null);
    expect(task.handIn.isDone.value).toBe(false);
  });

  it('counts the seconds down, and warns in the last five', async () => {
    const page = await bar([samples.target], 20);
    const time = () => page.mounted.get('[data-testid="time-left"]');
    await startRun(page);
    await vi.dynamicImportSettled();
    await page.tell({}, 14_000_000);
    expect([textOf(time().element), time().classes().includes('time--short')]).toEqual(['noch 6 s', false]);
    expect(textOf(page.mounted.get('.clock').element)).toBe('0:14.0');
    await page.tell({}, 15_500_000);
    expect([textOf(time().element), time().classes().includes('time--short')]).toEqual(['noch 5 s', true]);
    expect(page.said()).toBe(''); // a ticking clock would drown all else
  });

  it.each([
    ['time', null, 'Die Zeit ist um.', 'Fahr schneller'],
    ['forbidden', 'forbidden', 'auf ein verbotenes Feld', 'in weiterem Bogen'],
    ['spikes', 'spikes', 'Der Roboter hat Stacheln berührt.', 'weiche aus'],
    ['touched', 'wall', 'Der Roboter hat eine Wand berührt.', 'lenke früher ein'],
    ['touched', 'fixed', 'Der Roboter hat einen festen Block berührt.', 'lenke früher ein'],
    ['touched', null, 'Der Roboter hat den Rand der Arena berührt.', 'lenke früher ein'],
  ] as const)('says why it failed (%s, %s) and what helps', async (reason, by, what, todo) => {
    const page = await bar([samples.target, samples.forbidden, samples.spikes, samples.wall, samples['fixed-block']]);
    await startRun(page);
    await page.tell({});
    await page.tell({ state: 'failed', atMs: 4000, reason, by });
    expect(page.text()).toContain(what);
    expect([page.said().includes(what), page.said().includes(todo)]).toEqual([true, true]);
  });

  it('says on a phone why it failed, and leaves the advice to the hints', async () => {
    setWindow(390, 844);
    const page = await bar([samples.target, samples.wall]);
    await startRun(page);
    await page.tell({ state: 'failed', atMs: 4000, reason: 'touched', by: 'wall' });
    expect(page.said()).toBe('Noch nicht geschafft. Der Roboter hat eine Wand berührt.');
  });

  it('says that checkpoint 2 came before 1, and shows it when the program is over', async () => {
    const page = await bar([samples.checkpoint, two]);
    await startRun(page);
    await page.tell({});
    await page.tell({ early: { id: 'two', number: 2, before: 1 } });
    expect([page.text(), page.said()]).toEqual(['Kontrollpunkt 2 kam vor 1.', 'Kontrollpunkt 2 kam vor 1.']);
    expect(isThere('verdict-show')).toBe(false);
    await page.tell({ state: 'failed', atMs: 4000, reason: 'time', early: { id: 'two', number: 2, before: 1 } });
    expect(page.text()).toContain('Die Zeit ist um. Kontrollpunkt 2 kam vor 1.');
    await tap('verdict-show');
    expect(page.shown).toEqual([{ x: 700, y: 200 }]);
  });

  it('names the goals that are open when the program is over', async () => {
    const page = await bar([samples.checkpoint, two, samples.target]);
    await startRun(page);
    await page.tell({ checkpoints: { passed: 1, of: 2 } });
    await page.end();
    expect(page.text()).toBe('Noch nicht geschafftNoch offen: Kontrollpunkte 1 von 2, Ziel.');
  });

  it('does not praise what the hand has done, nor what a changed course has made easy', async () => {
    const page = await bar([samples.target]);
    await startRun(page);
    await page.tell({ state: 'helped', atMs: 2200, help: ['hand'], targets: { reached: 1, of: 1 } });
    expect(byId('verdict').dataset['state']).toBe('helped');
    expect(page.said()).toBe(
      'Mit Hilfe der Hand. Aufgabe gelöst in 2.2 s. Das zählt nicht: Versuche es ohne Hilfe. Nochmals',
    );
    await page.tell({ state: 'helped', atMs: 2200, help: ['hand', 'edits'] });
    expect(page.text()).toContain('Mit Hilfe der Hand, Parcours verändert');
  });

  it('tells help that the task allows beside the praise', async () => {
    const page = await bar([samples.target]);
    await startRun(page);
    await page.tell({ state: 'passed', atMs: 2200, help: ['edits'], targets: { reached: 1, of: 1 } });
    expect(page.text()).toBe('Geschafft!Aufgabe gelöst in 2.2 s. Parcours verändert');
  });

  it('shows where it was, and offers nothing to show where it was the time', async () => {
    const page = await bar([samples.spikes, samples.target]);
    await startRun(page);
    await page.tell({ state: 'failed', atMs: 4000, reason: 'spikes', by: 'spikes' });
    await tap('verdict-show');
    expect(page.shown).toEqual([{ x: 1050, y: 200 }]);
    await page.tell({ state: 'failed', atMs: 4000, reason: 'time', by: null });
    expect(isThere('verdict-show')).toBe(false);
  });

  it('begins again with everything at the start', async () => {
    const page = await bar([samples.target]);
    await startRun(page);
    await page.tell({ state: 'passed', atMs: 4000 });
    await press('Nochmals');
    expect(page.sent.at(-1)?.type).toBe('stop');
  });

  it('says while building how large the course is and what is in it, and tries it out', async () => {
    const page = await bar([samples.target, samples.wall]);
    page.mode.enter('build');
    await nextTick();
    expect(page.text()).toBe('Gesichert120 × 90 cm · 2 Dinge');
    await press('Ausprobieren');
    expect([page.mode.current.value, page.run.phase.value]).toEqual(['drive', 'starting']);
  });

  it('names the line of an error, and leads to it on a phone', async () => {
    setWindow(390, 844);
    const page = await bar([]);
    await startRun(page);
    const exception = {
      ...{ type: 'NameError', message: "name 'forwart' isn't defined", line: 3 },
      traceback: 'Traceback (most recent call last):\n  File "main.py", line 3, in <module>\n',
    };
    page.say({ type: 'program-ended', ended: { kind: 'exception', exception, timeUs: 0 }, device: 0 });
    await nextTick();
    expect(page.text()).toBe('Zeile 3 hat einen FehlerUnter dem Programm steht, wie du ihn behebst.');
    page.layout.tab.value = 'arena';
    await press('Ändern');
    expect([page.layout.tab.value, page.jump.target.value?.line]).toEqual(['code', 3]);
  });

  it('names and leads to the line in which a bracket opens, though the device notices it lines below', async () => {
    setWindow(390, 844);
    const page = await bar([]);
    page.work.setText('main.py', 'print(1\n\nx = 3');
    await fetchAdvice();
    await startRun(page);
    const exception = {
      ...{ type: 'SyntaxError', message: 'invalid syntax', line: 3 },
      traceback: 'Traceback (most recent call last):\n  File "main.py", line 3\n',
    };
    page.say({ type: 'program-ended', ended: { kind: 'exception', exception, timeUs: 0 }, device: 0 });
    await nextTick();
    expect(page.text()).toMatch(/^Zeile 1 hat/);
    page.layout.tab.value = 'arena';
    await press('Ändern');
    expect(page.jump.target.value?.line).toBe(1);
  });
});

describe('in a mission', () => {
  const begin = async (course: MissionCourse) => {
    const page = createPage();
    page.settings.change({ celebrate: false, welcomed: true, showTools: false });
    useCourses(page).openWhole(course);
    mountOn(page, NextStepBar);
    await startRun(page);
    return page;
  };
  const solve = async (course: MissionCourse) => {
    const page = await begin(course);
    await show(page, { verdict: { ...verdictAtStart(page.work.scene.value), state: 'passed', atMs: 1000 } });
    await vi.dynamicImportSettled();
    await nextTick();
    return page;
  };

  it('a program that has not done it leads to the hints, one after the other', async () => {
    const page = await begin(ladderOf('callibot')[1]!);
    await show(page, { verdict: verdictAtStart(page.work.scene.value) });
    page.say({ type: 'program-ended', ended: { kind: 'finished', exception: null, timeUs: 0 }, device: 0 });
    await nextTick();
    await press('Tipp ansehen');
    expect([page.task.isOpen.value, page.task.hints.value, textOf(byId('step-hint'))]).toEqual([
      ...[true, 1, 'Tipp 2 ansehen'],
    ]);
  });

  it('the next one is opened, for the same robot; what stands there then takes no press within a second', async () => {
    const page = await solve(ladderOf('callibot')[0]!);
    expect(textOf(byId('next-mission'))).toBe('Nächste Mission');
    await tap('next-mission');
    await vi.dynamicImportSettled();
    await vi.waitFor(() => expect(page.work.work.value.project.course).toBe('corner-callibot'));
    expect(page.work.find('main.py')?.text).toContain('from callibot import *');
    await tap('step-run');
    expect(page.run.phase.value).not.toBe('starting');
  });

  it('the last one leads to all of them, for the stars that are missing', async () => {
    const page = await solve(ladderOf('maqueen-plus-v2').at(-1)!);
    await press('Sterne holen');
    expect(page.router.page.value).toEqual({ name: 'missions', id: 'maqueen-plus-v2' });
    page.router.close();
  });
});
