// @vitest-environment happy-dom
import { flushPromises } from '@vue/test-utils';
import { describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import { sceneDefaults, type Scene, type TaskCard as Card } from '#scene/scene';
import { briefOf } from '#simulation/task/task-brief';
import type { Verdict } from '#simulation/task/verdict';

import { editingPage, press, samples } from '../../app/testing/editing';
import { mountOn, setWindow, textOf } from '../../app/testing/mount-on';
import { createPage } from '../../app/testing/page';
import { show, startRun } from '../../app/testing/run';
import { firstCourse } from '../work/catalogue/first-course';
import TaskCard from './TaskCard.vue';

const PICTURE = 'data:image/png;base64,iVBORw0KGgo=';

async function card(part: Partial<Card>, more: Partial<Scene> = {}, stars?: readonly [number, number]) {
  const task = {
    ...sceneDefaults.task,
    ...more.task,
    card: { ...sceneDefaults.card, ...part },
    ...(stars && { stars }),
  };
  const page = await editingPage([samples.checkpoint, samples.target], { name: 'Parken', description: 'Los.', ...more, task }); // prettier-ignore
  page.task.open();
  const mounted = mountOn(page, TaskCard);
  await nextTick();
  const find = (css: string) => mounted.find(css);
  const texts = (css: string) => mounted.findAll(css).map((it) => textOf(it.element));
  const tell = async (verdict: Partial<Verdict>) => {
    const { checkpoints, robotTargets } = briefOf(page.scene());
    const start: Verdict = {
      ...{ state: 'open', atMs: null, reason: null, by: null, place: null, help: [], early: null, touches: 0 },
      ...{ checkpoints: { passed: 0, of: checkpoints.length }, targets: { reached: 0, of: robotTargets.length } },
      ...{ blocks: { delivered: 0, of: 0 }, robots: [], stars: stars === undefined ? null : 0 },
    };
    await show(page, { verdict: { ...start, ...verdict } });
    await nextTick();
  };
  return { ...page, mounted, find, texts, tell };
}

describe('the card of a task', () => {
  it('has title, text, goals and rules in words', async () => {
    const { texts, find } = await card({ title: 'Einparken' }, { description: 'Fahr **los**.\n\n- `a`\n- b' });
    expect(texts('h2')).toEqual(['Einparken']);
    expect(texts('.markup p')).toEqual(['Fahr los.']);
    expect(texts('.markup li')).toEqual(['a', 'b']);
    expect([textOf(find('strong').element), textOf(find('code').element)]).toEqual(['los', 'a']);
    expect(texts('.goals li')).toEqual(['Fahr durch den Kontrollpunkt (offen)', 'Fahr dann ins Ziel (offen)']);
    expect(texts('.rules li')).toEqual(['ohne Hilfe der Hand']);
  });

  it('ticks the goals while the robot drives, and shows a rule that was not kept', async () => {
    const page = await card({});
    await startRun(page);
    page.task.open();
    await page.tell({ checkpoints: { passed: 1, of: 1 } });
    expect(page.texts('.goals .ok')).toEqual(['Fahr durch den Kontrollpunkt (geschafft)']);
    await page.tell({ state: 'helped', help: ['hand'], atMs: 9 });
    expect(page.texts('.rules .broken')).toEqual(['ohne Hilfe der Hand (nicht eingehalten)']);
  });

  it('opens its hints one by one', async () => {
    const { texts, find, task } = await card({ hints: ['Wie **weit**?', 'Zurück.'] });
    expect(texts('[data-testid="hint"]')).toEqual([]);
    const next = () => find('[data-testid="next-hint"]');
    expect([textOf(next().element), next().attributes('aria-label')]).toEqual(['Tipp', 'Tipp 1 zeigen von 2']);
    await find('[data-testid="next-hint"]').trigger('click');
    expect(texts('[data-testid="hint"]')).toEqual(['Tipp 1Wie weit?']);
    await find('[data-testid="next-hint"]').trigger('click');
    await nextTick();
    expect(texts('[data-testid="hint"]')).toEqual(['Tipp 1Wie weit?', 'Tipp 2Zurück.']);
    expect(document.activeElement?.textContent).toContain('Zurück.');
    expect([find('[data-testid="next-hint"]').exists(), task.hints.value]).toEqual([false, 2]);
  });

  it('has stars where the task gives them, the slower time first', async () => {
    const page = await card({}, {}, [20, 30]);
    expect(page.texts('.times li')).toEqual(['geschafft', 'unter 30 s', 'unter 20 s']);
    const earned = () => page.find('header .stars').attributes('aria-label');
    expect(earned()).toBe('0 von 3 Sternen');
    await startRun(page);
    await page.tell({ state: 'passed', atMs: 25_000, stars: 2 });
    expect(earned()).toBe('2 von 3 Sternen');
    expect((await card({})).find('.times').exists()).toBe(false);
  });

  it('has its picture where the text wants it, otherwise at the end', async () => {
    const at = async (description: string) =>
      (await card({ picture: PICTURE }, { description })).mounted
        .findAll('.markup > *')
        .map((it) => it.element.tagName);
    expect(await at('Eins\n\n![Plan](picture)\n\nZwei')).toEqual(['P', 'IMG', 'P']);
    expect(await at('Eins')).toEqual(['P', 'IMG']);
    const { find } = await card({ picture: PICTURE }, { description: '![Der Plan](picture)' });
    expect([find('img').attributes('alt'), find('img').attributes('src')]).toEqual(['Der Plan', PICTURE]);
    expect((await card({}, { description: '![Plan](picture)' })).find('img').exists()).toBe(false);
  });

  it('makes no element of what is written in it', async () => {
    const evil =
      '<script>alert(1)</script>\n\n[x](javascript:alert(1))\n\n<img src=x onerror=alert(1)>\n\n![x](https://a.b/c)';
    const { mounted, find } = await card({ title: evil, hints: [evil] }, { description: evil });
    await find('[data-testid="next-hint"]').trigger('click');
    expect(mounted.findAll('script, img, a, iframe, [onerror]')).toHaveLength(0);
    expect(textOf(mounted.element)).toContain('<script>alert(1)</script>');
  });

  it('folds to its title line and unfolds again, but not by Escape: it covers nothing', async () => {
    const { task, find, texts } = await card({});
    await find('.body').trigger('keydown', { key: 'Escape' });
    expect(task.isOpen.value).toBe(true);
    await press('Aufgabe einklappen');
    expect([task.isOpen.value, find('.body').exists(), texts('h2')]).toEqual([false, false, ['Parken']]);
    await press('Aufgabe aufklappen');
    expect([task.isOpen.value, find('.body').exists()]).toEqual([true, true]);
  });

  it('leaves the keys to whoever writes already when it comes', async () => {
    const { work, scene, find } = await card({});
    const program = document.body.appendChild(document.createElement('textarea'));
    program.focus();
    work.setScene({ ...scene(), description: 'Und jetzt zurück.' }, null);
    await flushPromises();
    expect(document.activeElement).toBe(program);
    expect(textOf(find('[role="status"]').element)).toContain('Und jetzt zurück.');
    program.remove();
  });

  it('takes the keys when a task is opened, and says title, text and goals', async () => {
    const { work, scene, find } = await card({});
    work.setScene({ ...scene(), description: 'Und jetzt zurück.' }, null);
    await flushPromises();
    expect(document.activeElement).toBe(find('h2').element);
    expect(textOf(find('[role="status"]').element)).toMatch(
      /^Parken.*Und jetzt zurück\..*Fahr durch den Kontrollpunkt/,
    );
  });

  it('says which mission it is, what is new in it, and the stars that were won before', async () => {
    const page = createPage();
    page.task.stars.keep(firstCourse!.id, 2);
    const mounted = mountOn(page, TaskCard);
    expect(textOf(mounted.find('[data-testid="task-kick"]').element)).toBe('Mission 1 von 12');
    expect(textOf(mounted.find('[data-testid="task-news"]').element)).toBe('neu: forward()');
    expect(mounted.find('header .stars').attributes('aria-label')).toBe('2 von 3 Sternen');
    await mounted.find('[data-testid="task-missions"]').trigger('click');
    expect(page.router.page.value).toEqual({ name: 'missions', id: 'maqueen-lite' });
  });

  it('has the goals and a hint alone above the course of a phone once it was read', async () => {
    setWindow(390, 844);
    const page = await editingPage([samples.target], { description: 'Los.', task: { ...sceneDefaults.task, card: { ...sceneDefaults.card, hints: ['Weiter!'] } } }); // prettier-ignore
    const mounted = mountOn(page, TaskCard, { inArena: true });
    const seen = () => ['.markup', '.goals', '[data-testid="hint"]'].map((css) => mounted.find(css).exists());
    expect(seen()).toEqual([true, true, false]);
    await mounted.find('[data-testid="next-hint"]').trigger('click');
    expect(mounted.find('[data-testid="task-text"]').exists()).toBe(false);
    expect(seen()).toEqual([true, true, true]);
    await press('Ganze Aufgabe und Tipps');
    expect(mounted.find('[data-testid="task-text"]').exists()).toBe(true);
  });

  it('lists what a teacher has checked besides the goals, with points', async () => {
    const { work, texts, find } = await card({});
    expect(find('[data-testid="task-checks"]').exists()).toBe(false);
    const checks = [
      { type: 'goals' },
      { type: 'touches', most: 2, points: 3 },
      { type: 'calls', name: 'irLeft', needed: false },
    ];
    work.setTask({ version: 1, checks });
    await vi.dynamicImportSettled();
    expect(texts('[data-testid="task-checks"] li')).toEqual([
      'höchstens 2 Berührungen 3 Punkte',
      'ruft irLeft auf 1 Punkt, freiwillig',
    ]);
  });
});
