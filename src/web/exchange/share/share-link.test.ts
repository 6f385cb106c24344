// @vitest-environment happy-dom
import { flushPromises } from '@vue/test-utils';
import { afterEach, describe, expect, it } from 'vitest';
import { nextTick } from 'vue';

import { packLevels } from '#scene/background';
import { projectOfLink } from '#project/link/link';
import { defaultScene, type Background } from '#scene/scene';

import { mountOn, textOf } from '../../app/testing/mount-on';
import { createPage } from '../../app/testing/page';
import { loadTexts, showLanguage } from '../../kit/i18n';
import { readyScene } from '../../session/work/catalogue/ready-courses';
import ShareDialog from './ShareDialog.vue';

const link = (): string => document.querySelector<HTMLInputElement>('[data-testid="share-link"]')?.value ?? '';
const warnings = (): readonly string[] => [...document.querySelectorAll('.callout--warn')].map(textOf);
/** The project that opening the shown link gives. */
function received() {
  const read = projectOfLink(link().slice(link().indexOf('#')), readyScene);
  if ('problem' in read) throw new Error(read.problem.message);
  return read.project;
}
/** Digits without any order: a text that no compression makes short. */
function noise(characters: number): string {
  let [state, text] = [1, ''];
  while (text.length < characters) {
    state = Math.imul(state ^ (state << 13), 0x5bd1e995) ^ (state >>> 15);
    text += (state >>> 0).toString(36);
  }
  return text.slice(0, characters);
}
/** The open dialog for a course with this background. */
async function shared(background: Background | null = null) {
  const page = createPage();
  page.settings.change({ language: 'de' });
  page.work.openProject(
    {
      files: [{ name: 'main.py', text: 'x = 1\n' }],
      scene: { ...defaultScene(), name: 'Mein Kurs', background },
      course: null,
    },
    null,
  );
  mountOn(page, ShareDialog);
  await flushPromises();
  return page;
}

describe('the link that is shared', () => {
  afterEach(() => history.replaceState(null, '', '/'));

  it('brings along what the program runs on, and nothing of how this person likes the page', async () => {
    const page = await shared();
    page.settings.change({ device: 'calliope-mini-3', reality: 0.5, theme: 'dark', speed: 4, muted: true });
    await nextTick();
    const { settings } = received();
    expect(settings).toMatchObject({ device: 'calliope-mini-3', reality: 0.5 });
    for (const name of ['theme', 'speed', 'muted', 'language']) expect(settings).not.toHaveProperty(name);
  });

  it('leads to this page, without what its address asks of it here', async () => {
    history.replaceState(null, '', '/app/?lang=fr&show=board#courses');
    await shared();
    expect(link()).toMatch(/^http:\/\/localhost:3000\/app\/#p=[\w.-]+$/);
  });

  it('is always that of the present work', async () => {
    const page = await shared();
    page.work.setText('main.py', 'print("später")\n');
    page.work.create('turn.py', 'left = 1\n');
    await nextTick();
    expect(received().files).toEqual([
      { name: 'main.py', text: 'print("später")\n' },
      { name: 'turn.py', text: 'left = 1\n' },
    ]);
  });

  const cells = [40, 30] as const;
  const background: Background = {
    ...{ at: [0, 0], size: [1200, 900], cells, picture: '' },
    levels: packLevels(Uint8Array.from({ length: cells[0] * cells[1] }, (_, cell) => (cell % 40 < 20 ? 0 : 15))),
  };

  it('has the floor that the sensors read in it, and says nothing where all has room', async () => {
    await shared(background);
    expect(received().scene.background).toEqual(background);
    expect(warnings()).toEqual([]);
  });

  it('says that a picture has no room: the floor comes along as the sensors read it', async () => {
    await shared({ ...background, picture: `data:image/png;base64,${noise(12_000)}` });
    expect(warnings()).toEqual([expect.stringMatching(/^Das Hintergrundbild hat im Link keinen Platz: Der Boden/)]);
    expect(received().scene.background).toMatchObject({ levels: background.levels, picture: '' });
  });

  it('says that the whole background has no room, and that the file has', async () => {
    const [columns, rows] = [160, 160];
    const digits = noise(columns * rows);
    const levels = packLevels(Uint8Array.from(digits, (digit) => parseInt(digit, 36) % 16));
    await shared({ ...background, cells: [columns, rows], levels });
    expect(warnings()).toEqual([
      expect.stringMatching(/^Das Hintergrundbild hat im Link keinen Platz\. .*als Datei weiter\.$/),
    ]);
    expect(received().scene.background).toBeNull();
  });

  it('is explained in all four languages, with every number filled in', async () => {
    await shared();
    const titles = new Set<string>();
    for (const language of ['de', 'fr', 'it', 'en'] as const) {
      await loadTexts(language);
      showLanguage(language);
      await nextTick();
      titles.add(textOf(document.querySelector('.share h2')));
      expect(textOf(document.querySelector('.share'))).toContain(String(link().length));
      expect(textOf(document.querySelector('.share'))).not.toMatch(/[{}]/);
    }
    expect(titles.size).toBe(4);
  });
});
