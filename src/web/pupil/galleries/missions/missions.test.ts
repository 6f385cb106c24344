// @vitest-environment happy-dom
import { beforeAll, beforeEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import { byId, tap } from '../../../app/testing/find';
import { mountOn, setWindow, textOf } from '../../../app/testing/mount-on';
import { createPage, type TestPage } from '../../../app/testing/page';
import { loadTexts } from '../../../kit/i18n';
import { ladderOf } from '#catalogue/missions';
import '../../../session/work/catalogue/ready-courses';
import MissionGallery from './MissionGallery.vue';

beforeAll(() => loadTexts('de'));
beforeEach(() => {
  localStorage.clear();
  setWindow(1366, 768);
});

async function gallery(prepare: (page: TestPage) => void = () => undefined): Promise<TestPage> {
  const page = createPage();
  page.router.open('missions');
  prepare(page);
  mountOn(page, MissionGallery);
  await nextTick();
  await nextTick();
  return page;
}
const cards = (): readonly HTMLElement[] => [...document.querySelectorAll<HTMLElement>('.mission')];
const names = (): readonly (string | undefined)[] =>
  cards().map((card) => card.querySelector('h3')?.textContent?.trim());

describe('the missions', () => {
  it('show the ladder of the robot on the table, none locked', async () => {
    await gallery();
    expect(names()).toEqual(ladderOf('maqueen-lite').map(({ texts }) => texts.de.name));
    expect(document.querySelectorAll('.mission button:disabled').length).toBe(0);
  });

  it('are followed by courses with colour and light', async () => {
    await gallery();
    await vi.waitFor(() => expect(byId('after-missions')).not.toBeNull());
    const after = [...byId('after-missions').querySelectorAll('h3')].map(textOf);
    expect(after).toEqual(['Zwei Ampeln', 'Zum Licht', 'Der Tunnel', 'Nach Farben sortieren']);
    expect(names().length).toBe(12);
    // They come later: the button before them stays where it is.
    const order = byId('mission-next').compareDocumentPosition(byId('after-missions'));
    expect(order & Node.DOCUMENT_POSITION_FOLLOWING).not.toBe(0);
  });

  it('change to another robot, which the address then names', async () => {
    await gallery();
    await tap('missions-callibot');
    expect(location.hash).toBe('#missions/callibot');
    expect(byId('missions-callibot').getAttribute('aria-pressed')).toBe('true');
  });

  it('show the stars that were won, and frame the first that was not passed', async () => {
    await gallery(({ task }) => {
      task.stars.keep('forward-maqueen-lite', 3);
      task.stars.keep('corner-maqueen-lite', 1);
      task.stars.keep('corner-callibot', 3); // of another robot
    });
    expect(byId('mission-stars').getAttribute('aria-label')).toBe('4 von 36 Sternen');
    expect(cards().map((card) => card.getAttribute('aria-current'))).toEqual([
      null,
      null,
      'step',
      ...Array<null>(9).fill(null),
    ]);
    expect(textOf(byId('mission-next'))).toContain('Als Nächstes: Ein Quadrat');
  });

  it('open the next one by its button, and any by its card; the gallery makes room', async () => {
    const page = await gallery();
    await tap('mission-open-next');
    expect(page.work.work.value.project.course).toBe('forward-maqueen-lite');
    expect(page.router.page.value).toBeNull();
    page.router.open('missions');
    await nextTick();
    cards()[10]?.querySelector('button')?.click();
    expect(page.work.work.value.project.course).toBe('line-maqueen-lite');
  });

  it('say so when all are passed', async () => {
    await gallery(({ task }) => ladderOf('maqueen-lite').forEach(({ id }) => task.stars.keep(id, 1)));
    expect(textOf(byId('mission-next'))).toContain('Alle Missionen geschafft');
  });
});
