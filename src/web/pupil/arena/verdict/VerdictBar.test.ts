// @vitest-environment happy-dom
import { describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import type { SceneObject } from '#scene/scene';
import type { Verdict } from '#simulation/task/verdict';

import { editingPage, press, samples } from '../../../app/testing/editing';
import { byId, isThere } from '../../../app/testing/find';
import { mountOn, named, setWindow, textOf } from '../../../app/testing/mount-on';
import { show, startRun } from '../../../app/testing/run';
import RunControls from '../RunControls.vue';
import ViewControls from '../ViewControls.vue';
import VerdictBar from './VerdictBar.vue';
import { verdictAtStart } from '#simulation/task/verdict-at-start';

/**
 * Mounts the bar below the arena; `tell` delivers the run's next picture, with the changes of its verdict since the
 * start.
 */
async function bar(objects: readonly SceneObject[], seconds: number | null = null, noTouch = false) {
  const page = await editingPage(objects, { task: { seconds, noTouch } });
  page.settings.change({ celebrate: false });
  const shown: unknown[] = [];
  const mounted = mountOn(page, VerdictBar, { onShow: (at: unknown) => shown.push(at) });
  const tell = async (verdict: Partial<Verdict>, timeUs = 0) => {
    await show(page, { timeUs, verdict: { ...verdictAtStart(page.scene()), ...verdict } });
    await nextTick();
  };
  const goals = () => mounted.findAll('.goal').map((it) => textOf(it.element));
  const said = () => textOf(mounted.get('[aria-live="polite"]').element);
  const text = () => textOf(mounted.element);
  return { ...page, mounted, tell, goals, said, text, shown };
}

const two = { ...samples.checkpoint, id: 'two', at: [700, 200], number: 2 } as const;

describe('the bar with the verdict', () => {
  it('tells before the start what there is to do', async () => {
    const { goals, mounted } = await bar([samples.checkpoint, two, samples.target]);
    expect(goals()).toEqual(['Kontrollpunkte 0/2', 'Ziel offen']);
    expect([mounted.attributes('data-state'), mounted.attributes('aria-label')]).toEqual(['open', 'Aufgabe']);
  });

  it('does not say “task” again beside the button that says it, but that it is not done', async () => {
    const page = await editingPage([samples.target]);
    const title = (isNamed: boolean): string => textOf(mountOn(page, VerdictBar, { isNamed }).element.querySelector('.title')); // prettier-ignore
    expect([title(false), title(true)]).toEqual(['Aufgabe', '']);
    await startRun(page);
    await show(page, { verdict: verdictAtStart(page.scene()) });
    page.say({ type: 'program-ended', ended: { kind: 'finished', exception: null, timeUs: 0 }, device: 0 });
    await nextTick();
    expect(title(true)).toBe('Noch nicht geschafft');
  });

  it('follows the course while it is edited', async () => {
    const { goals, editor } = await bar([samples.checkpoint, samples.target]);
    editor.commit({ type: 'remove', ids: ['one'] });
    await nextTick();
    expect(goals()).toEqual(['Ziel offen']);
  });

  it('counts what is done, and says it once for screen readers', async () => {
    const page = await bar([samples.checkpoint, two, samples.target]);
    await startRun(page);
    await page.tell({});
    await page.tell({ checkpoints: { passed: 1, of: 2 } });
    expect([page.goals()[0], page.said()]).toEqual(['Kontrollpunkte 1/2', 'Kontrollpunkte: 1 von 2.']);
    await page.tell({ checkpoints: { passed: 2, of: 2 } });
    expect(page.said()).toBe('Kontrollpunkte: 2 von 2.');
    expect(page.mounted.findAll('.goal--done')).toHaveLength(1);
  });

  it('leaves it to the telling of the drive, where that is switched on, to say what is reached', async () => {
    const page = await bar([samples.checkpoint, two]);
    page.settings.change({ tell: true });
    await startRun(page);
    await page.tell({});
    await page.tell({ checkpoints: { passed: 1, of: 2 } });
    expect([page.goals()[0], page.said()]).toEqual(['Kontrollpunkte 1/2', '']);
    await page.tell({ state: 'passed', atMs: 2000, checkpoints: { passed: 2, of: 2 } });
    expect(page.said()).toBe('Geschafft! Aufgabe gelöst in 2.0 s.');
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

  it('counts the seconds down, and warns in the last five', async () => {
    const page = await bar([samples.target], 20);
    const time = () => page.mounted.get('[data-testid="time-left"]');
    expect(textOf(time().element)).toBe('noch 20 s');
    await startRun(page);
    await page.tell({}, 14_000_000);
    expect([textOf(time().element), time().classes().includes('time--short')]).toEqual(['noch 6 s', false]);
    await page.tell({}, 15_500_000);
    expect([textOf(time().element), time().classes().includes('time--short')]).toEqual(['noch 5 s', true]);
    expect(page.said()).toBe(''); // a ticking clock would drown all else
  });

  it('tells what to keep off where there is nothing else to do, and always that nothing may be touched', async () => {
    expect((await bar([samples.forbidden, samples.spikes])).goals()).toEqual([
      ...['Verbotene Felder meiden', 'Stacheln meiden'],
    ]);
    expect((await bar([samples.forbidden, samples.target])).goals()).toEqual(['Ziel offen']);
    expect((await bar([samples.target], null, true)).goals()).toEqual(['Ziel offen', 'Nichts berühren']);
  });

  it('says how long it took when the task is done', async () => {
    const page = await bar([samples.target]);
    await startRun(page);
    await page.tell({});
    await page.tell({ state: 'passed', atMs: 12_340, targets: { reached: 1, of: 1 } });
    expect(page.text()).toContain('Geschafft! Aufgabe gelöst in 12.3 s.');
    expect(page.said()).toBe('Geschafft! Aufgabe gelöst in 12.3 s.');
    expect(page.mounted.attributes('data-state')).toBe('passed');
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
    expect(page.text()).toContain('nach 4.0 s');
    expect([page.said().includes(what), page.said().includes(todo)]).toEqual([true, true]);
  });

  it('says that checkpoint 2 came before 1, and shows it when the program is over', async () => {
    const page = await bar([samples.checkpoint, two]);
    await startRun(page);
    await page.tell({});
    await page.tell({ early: { id: 'two', number: 2, before: 1 } });
    expect(textOf(page.mounted.get('[data-testid="early"]').element)).toBe('Kontrollpunkt 2 kam vor 1.');
    expect(page.said()).toBe('Kontrollpunkt 2 kam vor 1.');
    expect(page.mounted.find('[data-testid="verdict-show"]').exists()).toBe(false);
    await page.tell({ state: 'failed', atMs: 4000, reason: 'time', early: { id: 'two', number: 2, before: 1 } });
    expect(page.text()).toContain('Die Zeit ist um. Kontrollpunkt 2 kam vor 1.');
    await press('Zeigen, was zu früh kam');
    expect(page.shown).toEqual([{ x: 700, y: 200 }]);
  });

  it('does not praise what the hand has done, nor what a changed course has made easy', async () => {
    const page = await bar([samples.target]);
    await startRun(page);
    await page.tell({ help: ['hand'] });
    expect(textOf(page.mounted.get('[data-testid="help-note"]').element)).toBe('mit Hilfe der Hand');
    await page.tell({ state: 'helped', atMs: 2200, help: ['hand'], targets: { reached: 1, of: 1 } });
    expect(page.mounted.attributes('data-state')).toBe('helped');
    expect(page.text()).toContain('Mit Hilfe der Hand Aufgabe gelöst in 2.2 s. Das zählt nicht');
    expect(page.said()).toBe('Mit Hilfe der Hand: Aufgabe gelöst in 2.2 s. Das zählt nicht: Versuche es ohne Hilfe.');
    expect(page.text()).not.toContain('Geschafft');
    await page.tell({ state: 'helped', atMs: 2200, help: ['hand', 'edits'] });
    expect(page.text()).toContain('Mit Hilfe der Hand, Parcours verändert');
  });

  it('tells help that the task allows beside the praise', async () => {
    const page = await bar([samples.target]);
    await startRun(page);
    await page.tell({ state: 'passed', atMs: 2200, help: ['edits'], targets: { reached: 1, of: 1 } });
    expect(page.text()).toContain('Geschafft! Aufgabe gelöst in 2.2 s. Parcours verändert');
  });

  it('shows where it was, and offers nothing to show where it was the edge or the time', async () => {
    const page = await bar([samples.spikes, samples.target]);
    await startRun(page);
    await page.tell({ state: 'failed', atMs: 4000, reason: 'spikes', by: 'spikes' });
    await press('Zeigen, was im Weg war');
    expect(page.shown).toEqual([{ x: 1050, y: 200 }]);
    await page.tell({ state: 'failed', atMs: 4000, reason: 'time', by: null });
    expect(page.mounted.find('[data-testid="verdict-show"]').exists()).toBe(false);
  });

  it('begins again with everything at the start', async () => {
    const page = await bar([samples.target]);
    await startRun(page);
    await page.tell({ state: 'failed', atMs: 4000, reason: 'time', by: null });
    await press('Nochmals: alles zurück an den Start');
    expect(page.sent.at(-1)?.type).toBe('stop');
  });
});

describe('the buttons of a run', () => {
  const disabled = (name: string) => (named(name) as HTMLButtonElement).disabled;

  it('can start at first, and neither stop nor pause', async () => {
    const page = await editingPage();
    const mounted = mountOn(page, RunControls);
    const off = () => mounted.findAll('button').filter((it) => (it.element as HTMLButtonElement).disabled).map((it) => it.attributes('data-testid')); // prettier-ignore
    expect(off()).toEqual(['stop', 'pause']);
    await startRun(page);
    await show(page);
    expect(off()).not.toContain('stop');
  });

  it('stop the run that is under way', async () => {
    const page = await editingPage();
    const mounted = mountOn(page, RunControls);
    await startRun(page);
    await show(page);
    await mounted.get('[data-testid="stop"]').trigger('click');
    expect(page.sent.at(-1)?.type).toBe('stop');
  });

  it('are fewer on a phone: stop shows only while there is something to stop', async () => {
    setWindow(400);
    const page = await editingPage();
    const mounted = mountOn(page, RunControls);
    const ids = () => mounted.findAll('button').map((it) => it.attributes('data-testid'));
    expect(ids()).toEqual(['run', 'reset']);
    await startRun(page);
    await show(page);
    expect(ids()).toEqual(['run', 'stop', 'reset']);
  });

  it('zoom and fit the arena; the figure of the zoom shows where it has room', async () => {
    setWindow(1400);
    const page = await editingPage();
    const done: string[] = [];
    const listeners = { onZoomIn: () => done.push('in'), onZoomOut: () => done.push('out'), onFit: () => done.push('fit'), onTrueSize: () => done.push('true') }; // prettier-ignore
    const mounted = mountOn(page, ViewControls, { zoomPercent: 125, withPercent: true, ...listeners });
    expect(mounted.find('.zoom').exists()).toBe(true);
    await press('Vergrössern');
    await press('Verkleinern');
    await press('Ganze Arena zeigen');
    expect([done, disabled('Ganze Arena zeigen')]).toEqual([['in', 'out', 'fit'], false]);
    expect(textOf(document.querySelector('.zoom'))).toBe('125 %');
    await press('Vergrösserung wählen');
    await vi.waitFor(() => expect(document.querySelector('[data-testid="zoom-true"]')).not.toBeNull());
    document.querySelector<HTMLElement>('[data-testid="zoom-true"]')?.click();
    expect(done.at(-1)).toBe('true');
  });
});
