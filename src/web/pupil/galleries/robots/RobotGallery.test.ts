// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import { attachmentTypes } from '#attachments/types';
import { findBoard } from '#board/boards/index';
import { robotTypes } from '#robots/index';
import { robotSheets } from '#robots/sheets';

import { byId, idsShown, isThere, tap } from '../../../app/testing/find';
import { goBackAtOnce, mountOn, named, textOf } from '../../../app/testing/mount-on';
import { createPage } from '../../../app/testing/page';
import { loadTexts, showLanguage } from '../../../kit/i18n';
import { LANGUAGES } from '../../../kit/i18n/texts';
import { examplesOf } from '../../../session/work/catalogue/examples';
import RobotGallery from './RobotGallery.vue';

/** The gallery of robots, at the page that the address names. */
async function galleryAt(id?: string) {
  const page = createPage();
  page.settings.change({ language: 'de' });
  page.router.open('robots', id);
  mountOn(page, RobotGallery);
  await nextTick();
  return page;
}
const flat = (text: string): string => text.replace(/\s+/g, ' ').trim();
const title = (): string => textOf(document.querySelector('.gallery h2'));
const sections = (): readonly string[] => [...document.querySelectorAll('.sheet h3')].map(textOf);
const section = (name: string): HTMLElement => {
  const heading = [...document.querySelectorAll('.sheet h3')].find((it) => textOf(it) === name);
  const found = heading?.parentElement ?? null;
  if (found === null) throw new Error(`No section ${name}, only ${sections().join(' · ')}`);
  return found;
};
/** The tables of a section as cells, row by row, without their heads; nothing where there is no such section. */
const rowsIn = (name: string): readonly (readonly string[])[] =>
  sections().includes(name)
    ? [...section(name).querySelectorAll('tbody tr')].map((row) => [...row.children].map(textOf))
    : [];

beforeEach(goBackAtOnce);
afterEach(() => {
  vi.restoreAllMocks();
  history.replaceState(null, '', '/');
});

describe('the cards of the robots', () => {
  it('are one for each robot, with its name, its board and what it can do', async () => {
    await galleryAt();
    expect(idsShown('card-')).toEqual(robotTypes.map(({ id }) => `card-${id}`));
    for (const type of robotTypes) {
      const card = textOf(byId(`card-${type.id}`));
      expect(card).toContain(type.name);
      expect(card).toContain(findBoard(type.board)!.name);
      expect(card).toContain(flat(robotSheets.find(({ robot }) => robot === type.id)!.about.de));
    }
  });

  it.each(LANGUAGES)('speak the language of the page: %s', async (language) => {
    await loadTexts(language);
    showLanguage(language);
    await galleryAt();
    for (const { robot, about } of robotSheets) expect(textOf(byId(`card-${robot}`))).toContain(flat(about[language]));
  });

  it('choose their robot and stay: the mark moves to it, and the button goes', async () => {
    const page = await galleryAt();
    const [first, second] = robotTypes.map(({ id }) => id) as [string, string];
    await tap(isThere(`choose-${first}`) ? `choose-${first}` : `choose-${second}`);
    await tap(isThere(`choose-${first}`) ? `choose-${first}` : `choose-${second}`);
    expect(page.router.page.value).toEqual({ name: 'robots', id: null });
    const inUse = idsShown('in-use-');
    expect(inUse).toHaveLength(1);
    expect(isThere(inUse[0]!.replace('in-use-', 'choose-'))).toBe(false);
    expect(page.settings.current.value.robot).toBe(inUse[0]!.slice('in-use-'.length));
  });

  it('lead to the robot’s page with “Mehr” and with the title', async () => {
    const page = await galleryAt();
    const last = robotTypes.at(-1)!;
    await tap(named(`Mehr über ${last.name}`));
    expect(page.router.page.value).toEqual({ name: 'robots', id: last.id });
    expect(title()).toBe(last.name);
    await tap('gallery-all');
    expect(title()).toBe('Roboter-Galerie');
    await tap(byId(`card-${last.id}`).querySelector('a')!);
    expect(title()).toBe(last.name);
  });

  it('are shown below a word about a robot that nobody knows', async () => {
    await galleryAt('no-such-robot');
    expect(textOf(document.querySelector('.unknown'))).toBe('Diesen Roboter gibt es hier nicht.');
    expect(idsShown('card-')).toHaveLength(robotTypes.length);
  });
});

describe.each(robotTypes.map((type) => [type.name, type] as const))('the sheet of %s', (_, type) => {
  const sheet = robotSheets.find(({ robot }) => robot === type.id)!;

  it('tells its board, its modules, what is plugged in where, its registers and what it can carry', async () => {
    await galleryAt(type.id);
    const facts = textOf(document.querySelector('.sheet dl'));
    expect(facts).toContain(findBoard(type.board)!.name);
    for (const module of type.modules) expect(facts).toContain(module);
    expect(facts).toMatch(/\d+ cm lang, \d+ cm breit/);
    // A section without anything in it is left out.
    expect(rowsIn('Anschlüsse').map(([part, at]) => [part, at])).toEqual(
      sheet.wiring.map(({ part, at }) => [flat(part.de), flat(at)]),
    );
    const words = { R: 'lesen', W: 'schreiben', RW: 'lesen, schreiben' };
    expect(rowsIn('Register am I2C-Bus')).toEqual(
      sheet.registers.flatMap(({ rows }) =>
        rows.map(({ register, access, meaning }) => [flat(register), words[access], flat(meaning.de)]),
      ),
    );
    expect(rowsIn('Was du einrichten kannst').map(([, choices]) => choices)).toEqual(
      type.options.map(({ choices }) => choices.map((choice) => flat(choice.title.de)).join(' · ')),
    );
    const taken = attachmentTypes.filter(({ id }) =>
      type.options.some(({ choices }) => choices.some((choice) => choice.id === id)),
    );
    expect(sections().includes('Anbauteile')).toBe(taken.length > 0);
    for (const { title, about } of taken) {
      expect(textOf(section('Anbauteile'))).toContain(flat(title.de));
      expect(textOf(section('Anbauteile'))).toContain(flat(about.de));
    }
  });

  it('offers each example to read, and to open in the editor', async () => {
    const page = await galleryAt(type.id);
    const examples = examplesOf(type);
    const shown = [...document.querySelectorAll('.examples pre')].map((it) => it.textContent);
    expect(shown).toEqual(examples.map(({ example }) => example.source.de));
    const last = examples.at(-1)!.example;
    await tap(`open-${last.file}`);
    expect(page.router.page.value).toBeNull();
    expect(page.work.find('main.py')?.text).toBe(last.source.de);
  });
});

describe('the sheet of a robot', () => {
  it('puts the robot into the arena', async () => {
    const page = await galleryAt('callibot');
    const choose = robotTypes.map(({ id }) => id).find((id) => id !== page.settings.current.value.robot)!;
    page.router.open('robots', choose);
    await nextTick();
    if (isThere(`choose-${choose}`)) await tap(`choose-${choose}`);
    expect(isThere(`in-use-${choose}`)).toBe(true);
    expect(isThere(`choose-${choose}`)).toBe(false);
  });

  it('warns when its robot stands on the wrong microcomputer, and plugs it in rightly', async () => {
    const page = await galleryAt('callibot');
    page.work.setText('main.py', 'from callibot import *');
    page.settings.change({ device: 'microbit-v2' });
    await nextTick();
    const warning = textOf(document.querySelector('.misplugged'));
    expect(warning).toContain('Calli:bot gehört auf einen');
    await tap(named('Umstecken'));
    expect(document.querySelector('.misplugged')).toBeNull();
    expect(page.settings.current.value.device).not.toBe('microbit-v2');
  });

  it('is printed by the browser', async () => {
    const print = vi.fn();
    vi.stubGlobal('print', print);
    await galleryAt('callibot');
    await tap(named('Blatt drucken'));
    expect(print).toHaveBeenCalledOnce();
  });

  it('shows each program only when it is unfolded', async () => {
    await galleryAt('callibot');
    const programs = [...document.querySelectorAll<HTMLDetailsElement>('.examples details')];
    expect(programs.length).toBeGreaterThan(0);
    expect(programs.every(({ open }) => !open)).toBe(true);
  });
});
