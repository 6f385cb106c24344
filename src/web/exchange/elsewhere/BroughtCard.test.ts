// @vitest-environment happy-dom
import LZString from 'lz-string';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { nextTick } from 'vue';

import { linkSamples } from '#project/webtigerpython/testing/links';

import { byId, isThere, tap } from '../../app/testing/find';
import { mountOn, textOf } from '../../app/testing/mount-on';
import { createPage, type TestPage } from '../../app/testing/page';
import { openAddress } from '../share/open-address';
import { commandsOf } from '../share/use-commands';
import BroughtCard from './BroughtCard.vue';
import { elsewhereOf } from './parts';

const packed = (value: unknown): string => encodeURIComponent(LZString.compressToBase64(JSON.stringify(value)));
const code = (...texts: readonly string[]): string =>
  `code=${packed(texts.map((data, index) => ({ name: index === 0 ? 'main.py' : `part${String(index)}.py`, data })))}`;
const world = { StartBox: [500, 600, 2], Wallobjects: [[600, 600, 100, 0]], playgroundSize: [2000, 1000] };
const inAddress = (value: object): string => `&device=micro%3Abit&playground=${packed(value)}`;
const loops = 'from mbrobot import *\n\nrepeat 4:\n    forward()\nrepeat:\n    stop()\n';
const rewritten = loops.replace('repeat 4:', 'for _ in range(4):').replace('repeat:', 'while True:');

let page: TestPage;
beforeEach(() => {
  page = createPage();
  page.settings.change({ language: 'de' });
  document.body.insertAdjacentHTML('beforeend', '<section class="pane-code"></section>');
});
afterEach(() => page.scope.stop());

/** Opens an address or a text, and shows the card. */
async function open(address: string): Promise<void> {
  expect(openAddress(page, address)).toBeNull();
  mountOn(page, BroughtCard);
  await nextTick();
}
const came = (): readonly string[] => [...byId('brought-came').querySelectorAll('li')].map(textOf);
const told = (): readonly string[] => (isThere('brought-told') ? [...byId('brought-told').querySelectorAll('li')].map(textOf) : []); // prettier-ignore
const text = (): string => page.work.open.value.text;

describe('the card about work from WebTigerPython', () => {
  it('ticks what came off, and stays small where nothing was changed', async () => {
    await open(`?${code('from mbrobot import *\n')}${inAddress(world)}`);
    expect(came()).toEqual(['Programm main.py', 'Welt: 1 Wand, Start, 200 × 100 cm', 'Roboter: Maqueen Lite, wegen import']); // prettier-ignore
    expect(isThere('brought-changed')).toBe(false);
    expect(told()).toEqual(['Nicht im Link: Stiftlinien, Grösse des Roboters.']);
  });

  it('brings the robot of the imports, whichever was chosen before', () => {
    page.settings.change({ robot: 'callibot' });
    expect(openAddress(page, `?${code('from mbrobot import *\n')}${inAddress(world)}`, 'held')).toBeNull();
    expect(page.settings.current.value.robot).toBe('auto');
  });

  it('names no robot where no import is the reason for it', async () => {
    await open(`?${code('print(1)\n')}${inAddress(world)}`);
    expect(came()).toHaveLength(2);
  });

  it('shows each line that was rewritten, and has the editor mark it', async () => {
    await open(`?${code(loops)}${inAddress(world)}`);
    expect(text()).toBe(rewritten);
    const lines = [...byId('brought-changed').querySelectorAll('p')].map(textOf);
    expect(lines).toEqual(['Zeile 3: repeat 4: heisst hier for _ in range(4):', 'Zeile 5: repeat: heisst hier while True:']); // prettier-ignore
    expect(page.jump.changed.value.map(({ line }) => line)).toEqual([3, 5]);
  });

  it('takes the rewriting back as one step, and has it again when that is undone', async () => {
    await open(`?${code(loops)}${inAddress(world)}`);
    await tap('brought-take-back');
    expect(page.jump.mending.value).toEqual({ file: 'main.py', before: rewritten, after: loops });
    page.work.setText('main.py', loops, true);
    await nextTick();
    expect(isThere('brought-changed')).toBe(false);
    expect(page.jump.changed.value).toEqual([]);
    page.work.setText('main.py', rewritten, true);
    await nextTick();
    expect(isThere('brought-changed')).toBe(true);
  });

  it('takes it back in files that are not in sight, too', async () => {
    await open(`?${code(loops, loops)}`);
    expect(byId('brought-changed').textContent).toMatch(/part1\.py, Zeile 3.*und 1 weitere/);
    await tap('brought-take-back');
    expect(page.work.find('part1.py')?.text).toBe(loops);
  });

  it('says what could not be read, what was moved and what is not there', async () => {
    const odd = { ...world, StartBox: [0, 500, 0], Lines: [] };
    await open(`?${code('from mbrobot import *\n')}${inAddress(odd).replace('micro%3Abit', 'Oxocard')}`);
    expect(told()).toEqual([
      expect.stringContaining('Lines'),
      expect.stringMatching(/^Bei \(0, 500\)/),
      expect.stringContaining('Oxocard'),
    ]);
  });

  it('says that a world is broken, beside the program that is not', async () => {
    await open(linkSamples.find(({ playground }) => playground === null)?.link ?? '');
    expect(came()).toContain('Programm main.py');
    expect(told()[0]).toMatch(/^Die Welt im Link/);
    expect(told().join()).not.toContain('Stiftlinien');
  });

  it('tells of a course file, dropped or pasted, without speaking of a link', async () => {
    await open(JSON.stringify(world));
    expect([came(), told()]).toEqual([['Welt: 1 Wand, Start, 200 × 100 cm'], []]);
    elsewhereOf(page).brought.close();
    commandsOf(page).take([new File([JSON.stringify({ ...world, playgroundSize: [900, 900] })], 'mylevel.json')]);
    await expect.poll(() => elsewhereOf(page).brought.shown.value?.isLink).toBe(false);
    await nextTick();
    expect(came()).toEqual(['Welt: 1 Wand, Start, 90 × 90 cm']);
  });

  it('is closed for good, and takes the marks along', async () => {
    await open(`?${code(loops)}${inAddress(world)}`);
    await tap('brought-close');
    expect(isThere('brought')).toBe(false);
    expect(page.jump.changed.value).toEqual([]);
    const { project } = page.work.work.value;
    page.work.openProject({ ...project, files: [{ name: 'main.py', text: rewritten }] }, null);
    expect(elsewhereOf(page).brought.shown.value).toBeNull();
  });

  it('goes with its work: another program is none of its business', async () => {
    await open(`?${code(loops)}${inAddress(world)}`);
    const { project } = page.work.work.value;
    page.work.openProject({ ...project, files: [{ name: 'main.py', text: rewritten }] }, 'before');
    await nextTick();
    expect(isThere('brought')).toBe(false);
  });

  it('is not there for a program alone that came as it was', () => {
    expect(openAddress(page, `?${code('print(1)\n')}`)).toBeNull();
    expect(elsewhereOf(page).brought.shown.value).toBeNull();
  });
});
