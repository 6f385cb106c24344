// @vitest-environment happy-dom
import { describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import { sceneDefaults, type Scene, type TaskCard as Card } from '#scene/scene';
import { briefOf } from '#simulation/task/task-brief';
import type { Verdict } from '#simulation/task/verdict';

import { editingPage, press, samples } from '../../app/testing/editing';
import { mountOn, named, setWindow, textOf } from '../../app/testing/mount-on';
import { show, startRun } from '../../app/testing/run';
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
    expect(texts('.goals li')).toEqual(['Fahre durch den Kontrollpunkt (offen)', 'Fahre dann ins Ziel (offen)']);
    expect(texts('.rules li')).toEqual(['ohne Hilfe der Hand']);
  });

  it('ticks the goals while the robot drives, and shows a rule that was not kept', async () => {
    const page = await card({});
    await startRun(page);
    page.task.open();
    await page.tell({ checkpoints: { passed: 1, of: 1 } });
    expect(page.texts('.goals .ok')).toEqual(['Fahre durch den Kontrollpunkt (geschafft)']);
    await page.tell({ state: 'helped', help: ['hand'], atMs: 9 });
    expect(page.texts('.rules .broken')).toEqual(['ohne Hilfe der Hand (nicht eingehalten)']);
  });

  it('opens its hints one by one', async () => {
    const { texts, find, task } = await card({ hints: ['Wie **weit**?', 'Zurück.'] });
    expect(texts('[data-testid="hint"]')).toEqual([]);
    expect(textOf(find('[data-testid="next-hint"]').element)).toBe('Tipp 1 zeigen von 2');
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

  it('goes with “Los geht’s”, with its cross and with Escape', async () => {
    const { task, find } = await card({});
    await press('Los geht’s');
    expect(task.isOpen.value).toBe(false);
    task.open();
    await press('Aufgabe schliessen');
    expect(task.isOpen.value).toBe(false);
    task.open();
    await find('.body').trigger('keydown', { key: 'Escape' });
    expect(task.isOpen.value).toBe(false);
  });

  it('shows the course of a phone beside it, and its goals alone while the robot drives', async () => {
    setWindow(390, 844);
    const page = await editingPage([samples.target], { description: 'Los.' });
    await startRun(page);
    page.task.open();
    const mounted = mountOn(page, TaskCard);
    await nextTick();
    expect(page.layout.tab.value).toBe('arena');
    expect([mounted.find('.markup').exists(), mounted.find('.goals').exists()]).toEqual([false, true]);
    await press('Ganze Aufgabe und Tipps');
    expect([mounted.find('.markup').exists(), named('Los geht’s') !== null]).toEqual([true, true]);
    page.layout.tab.value = 'code';
    await nextTick();
    expect(page.task.isOpen.value).toBe(false);
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
