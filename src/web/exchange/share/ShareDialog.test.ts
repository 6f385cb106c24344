// @vitest-environment happy-dom
import { afterEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import { sceneWith, targetAt } from '#check/testing/tasks';
import { isProjectLink, projectOfLink } from '#project/link/link';
import { defaultScene } from '#scene/scene';

import { downloads } from '../../app/testing/downloads';
import { byId, fieldById, isThere, tap, write } from '../../app/testing/find';
import { mountOn, named, textOf } from '../../app/testing/mount-on';
import { createPage, type TestPage } from '../../app/testing/page';
import { readyScene } from '../../session/work/catalogue/ready-courses';
import { courses } from '#catalogue/courses';
import { openAddress } from './open-address';
import OpenDialog from './OpenDialog.vue';
import { qrPath, QR_CHARACTERS } from '../../kit/links/qr-code';
import ShareDialog from './ShareDialog.vue';

/** A text that nothing makes shorter: the same on each run. */
function noise(length: number): string {
  let state = 12345;
  let text = '';
  while (text.length < length) {
    state = (Math.imul(state, 1103515245) + 12345) >>> 0;
    text += String.fromCharCode(35 + ((state >>> 16) % 56)); // no quotation mark and no backslash
  }
  return text;
}
/** A page with a program of its own in a course of its own. */
function pageWith(text: string): TestPage {
  const page = createPage();
  page.settings.change({ language: 'de' });
  page.work.openProject({ files: [{ name: 'main.py', text }], scene: page.work.scene.value, course: null }, null);
  return page;
}
afterEach(() => void vi.restoreAllMocks());

describe('the dialog for sharing', () => {
  it('leads to handing in where there is something to reach, and not elsewhere', async () => {
    const page = pageWith('print(1)\n');
    page.work.setScene(defaultScene(), null);
    mountOn(page, ShareDialog);
    expect(isThere('hand-in')).toBe(false);
    page.work.setScene(sceneWith([targetAt(700, 450)]), null);
    await nextTick();
    await tap('hand-in');
    expect(page.task.handIn.isOpen.value).toBe(true);
  });

  const link = (): string => fieldById('share-link').value;
  /** Opens the dialog on a program; `closed` counts what it asked for. */
  async function share(text: string) {
    const page = pageWith(text);
    const closed = vi.fn();
    mountOn(page, ShareDialog, { onClose: closed });
    await nextTick();
    return { page, closed };
  }
  /** Opens its link elsewhere, as somebody who has received it. */
  function received(): TestPage {
    const other = createPage();
    expect(openAddress(other, link())).toBeNull();
    return other;
  }

  it('shows a link that opens the same program in the same course elsewhere', async () => {
    const { page } = await share('print("Grüezi")\n');
    expect(link().startsWith(`${location.origin}${location.pathname}#p=`)).toBe(true);
    const other = received();
    expect(other.work.files.value).toEqual(page.work.files.value);
    expect(other.work.scene.value).toEqual(page.work.scene.value);
  });

  it('says how long the link is', async () => {
    await share('print(1)\n');
    expect(textOf(byId('share-dialog').querySelector('.num'))).toContain(`${String(link().length)} Zeichen`);
  });

  it('leaves the program out on request: the receiver has the arena with an empty program', async () => {
    await share('geheim = 1\n');
    const whole = link();
    byId('share-program').click();
    await nextTick();
    expect(link().length).toBeLessThan(whole.length);
    const other = received();
    expect(other.work.files.value.map(({ name, text }) => [name, text.includes('geheim')])).toEqual([
      ['main.py', false],
    ]);
    byId('share-program').click();
    await nextTick();
    expect(link()).toBe(whole);
  });

  it('copies the link and says so; a changed link is not said to be copied', async () => {
    const copied: string[] = [];
    vi.spyOn(navigator.clipboard, 'writeText').mockImplementation((text) => Promise.resolve(void copied.push(text)));
    await share('print(1)\n');
    await tap('share-copy');
    await vi.waitFor(() => expect(textOf(byId('share-said'))).toBe('Der Link ist kopiert.'));
    expect(copied).toEqual([link()]);
    byId('share-program').click();
    await nextTick();
    expect(textOf(byId('share-said'))).toBe('');
  });

  it('marks the link where the browser forbids copying, and says how it is done by hand', async () => {
    vi.spyOn(navigator.clipboard, 'writeText').mockRejectedValue(new Error('forbidden'));
    await share('print(1)\n');
    await tap('share-copy');
    await vi.waitFor(() => expect(textOf(byId('share-said'))).toContain('Kopiere ihn mit Ctrl+C'));
    const field = fieldById('share-link');
    expect(document.activeElement).toBe(field);
    expect([field.selectionStart, field.selectionEnd]).toEqual([0, link().length]);
  });

  it('draws the link as a QR code, which is shown large and small again', async () => {
    await share('print(1)\n');
    const drawn = byId('share-qr').querySelector('path')?.getAttribute('d');
    expect(drawn).toBe(qrPath(link())?.path);
    named('QR-Code des Links');
    await tap('share-large');
    expect(textOf(byId('share-large'))).toBe('Wieder klein');
    expect(byId('share-dialog').classList.contains('share--large')).toBe(true);
    await tap('share-large');
    expect(textOf(byId('share-large'))).toBe('Gross zeigen');
  });

  it('draws another QR code for another link', async () => {
    await share('print("mit Programm")\n');
    const drawn = (): string => byId('share-qr').querySelector('path')!.getAttribute('d')!;
    const before = drawn();
    byId('share-program').click();
    await nextTick();
    expect(drawn()).not.toBe(before);
  });

  it('says that a link is too long for a QR code, and with what limit', async () => {
    await share(`text = """${noise(4000)}"""\n`);
    expect(link().length).toBeGreaterThan(QR_CHARACTERS);
    expect(isThere('share-qr')).toBe(false);
    expect(textOf(byId('share-no-qr'))).toBe(
      `Für einen QR-Code ist der Link zu lang: ${String(link().length)} Zeichen, höchstens 2953.`,
    );
  });

  it('warns of a link that chats cut off, and not of a shorter one', async () => {
    await share(`text = """${noise(12_000)}"""\n`);
    expect(textOf(byId('share-dialog'))).toContain(`Der Link ist lang (${String(link().length)} Zeichen).`);
    byId('share-program').click();
    await nextTick();
    expect(textOf(byId('share-dialog'))).not.toContain('Der Link ist lang');
  });

  it('offers only a file for a project that no link can hold', async () => {
    const saved = downloads();
    const page = pageWith('print(1)\n');
    for (const name of ['a.py', 'b.py', 'c.py', 'd.py', 'e.py', 'f.py', 'g.py', 'h.py', 'i.py', 'j.py'])
      page.work.create(name, noise(60_000));
    mountOn(page, ShareDialog);
    await nextTick();
    expect(isThere('share-link')).toBe(false);
    expect(isThere('share-qr')).toBe(false);
    expect(textOf(byId('share-too-long'))).toBe(
      'Dieses Projekt ist zu gross für einen Link. Speichere es als Datei und gib sie weiter.',
    );
    await tap(named('Als Datei speichern'));
    expect(saved).toHaveLength(1);
  });

  it('saves the project as a file, which holds what the link holds', async () => {
    const saved = downloads();
    const { page } = await share('print("Datei")\n');
    await tap(named('Als Datei speichern'));
    expect(saved.map(({ name }) => name)).toEqual([expect.stringMatching(/\.parcours\.json$/)]);
    const kept = JSON.parse(await saved[0]!.blob.text()) as { readonly files: unknown };
    expect(JSON.stringify(kept.files)).toContain('Datei');
    expect(page.notices.current.value?.key).toBe('files.saved');
  });

  it('has a link for WebTigerPython, too, above which stands what is lost on the way there', async () => {
    const text = 'from mbrobot import *\nforward()\n';
    const { page } = await share(text);
    const { robot } = page.work.scene.value;
    const wall = { type: 'wall', id: 'wall-1', from: [100, 100], to: [300, 100], thickness: 10 } as const;
    page.work.setScene(
      { ...defaultScene(), name: 'Halle', robot: { ...robot, type: 'callibot' }, objects: [wall] },
      null,
    );
    await nextTick();
    expect(isThere('elsewhere-link')).toBe(false);
    const details = byId('share-elsewhere') as HTMLDetailsElement;
    details.open = true;
    details.dispatchEvent(new Event('toggle'));
    await nextTick();
    expect([...byId('share-elsewhere-lost').querySelectorAll('li')].map(textOf)).toEqual([
      'Name und Beschreibung des Parcours fallen weg.',
      'Welcher Roboter fährt, entscheiden dort die Importe des Programms, und sie meinen nicht Calli:bot.',
    ]);
    expect(byId('share-elsewhere-lost').compareDocumentPosition(byId('elsewhere-link'))).toBe(4); // it follows
    const other = createPage();
    expect(openAddress(other, fieldById('elsewhere-link').value)).toBeNull();
    expect(other.work.files.value).toEqual([{ name: 'main.py', text }]);
    expect(other.work.scene.value.objects).toEqual([wall]);
  });

  it('is closed by its button', async () => {
    const { closed } = await share('print(1)\n');
    await tap('share-close');
    expect(closed).toHaveBeenCalledOnce();
  });

  it('puts the keyboard on the link, all of it marked', async () => {
    await share('print(1)\n');
    await vi.waitFor(() => expect(document.activeElement).toBe(byId('share-link')));
    const { selectionStart, selectionEnd } = fieldById('share-link');
    expect([selectionStart, selectionEnd]).toEqual([0, link().length]);
  });

  it('names a ready course instead of sending it', async () => {
    const page = createPage();
    openAddress(page, '?task=slalom');
    mountOn(page, ShareDialog);
    await nextTick();
    const fragment = link().slice(link().indexOf('#'));
    expect(isProjectLink(fragment)).toBe(true);
    const read = projectOfLink(fragment, readyScene);
    expect('project' in read && read.project.course).toBe('slalom');
  });
});

describe('the dialog that opens a link', () => {
  /** The dialog over a page with this program. */
  async function dialog(text = 'meins = 1\n') {
    const page = pageWith(text);
    const closed = vi.fn();
    mountOn(page, OpenDialog, { onClose: closed });
    await nextTick();
    const open = async (address: string): Promise<void> => {
      await write(byId('open-link'), address);
      byId('open-dialog').dispatchEvent(new Event('submit', { cancelable: true }));
      await nextTick();
    };
    const problem = (): string => textOf(document.querySelector('#open-link-problem'));
    return { page, closed, open, problem };
  }

  it('has nothing to open before something is written', async () => {
    await dialog();
    const button = fieldById('open-link-now');
    expect(button.disabled).toBe(true);
    await write(byId('open-link'), '   ');
    expect(button.disabled).toBe(true);
    await write(byId('open-link'), 'x');
    expect(button.disabled).toBe(false);
  });

  it('opens a shared project, closes, and keeps the pupil’s work', async () => {
    const sender = pageWith('print("geteilt")\n');
    mountOn(sender, ShareDialog);
    await nextTick();
    const address = fieldById('share-link').value;
    const { page, closed, open } = await dialog('meins = 1\n');
    await open(address);
    expect(page.work.find('main.py')?.text).toBe('print("geteilt")\n');
    expect(closed).toHaveBeenCalledOnce();
    expect(page.work.work.value.previous.map(({ project }) => project.files[0]?.text)).toEqual(['meins = 1\n']);
  });

  it.each([
    ['https://example.org/', 'Das ist kein Link zu einem Projekt.'],
    ['?world=no-such-course', 'Den Parcours «no-such-course» gibt es hier nicht. Lade die Seite neu.'],
    ['#p=2!!!', 'Der Link ist beschädigt: Ein Teil fehlt oder ist verändert. Kopiere ihn nochmals ganz.'],
  ])('says why it cannot open %s, and changes nothing', async (address, words) => {
    const { page, closed, open, problem } = await dialog();
    const before = page.work.work.value;
    await open(address);
    expect(problem()).toBe(words);
    expect(closed).not.toHaveBeenCalled();
    expect(page.work.work.value).toBe(before);
    expect(byId('open-link').getAttribute('aria-invalid')).toBe('true');
    expect(document.activeElement).toBe(byId('open-link'));
  });

  it('takes its complaint back as soon as the link is changed', async () => {
    const { open, problem } = await dialog();
    await open('nichts');
    expect(problem()).not.toBe('');
    await write(byId('open-link'), 'etwas');
    expect(problem()).toBe('');
    expect(byId('open-link').getAttribute('aria-invalid')).toBe('false');
  });

  it('says that a link with its end cut off is damaged', async () => {
    const sender = pageWith(`print("${noise(300)}")\n`);
    mountOn(sender, ShareDialog);
    await nextTick();
    const whole = fieldById('share-link').value;
    const { open, problem, page } = await dialog();
    await open(whole.slice(0, -20));
    expect(problem()).toContain('beschädigt');
    expect(page.work.find('main.py')?.text).toBe('meins = 1\n');
  });

  it.each(['slalom', 'carry'])('opens the ready course %s, with its program or the arena alone', async (id) => {
    const course = courses.find((it) => it.id === id)!;
    const alone = await dialog('meins = 1\n');
    await alone.open(`${location.origin}/?world=${id}`);
    expect(alone.page.work.scene.value).toEqual(course.scene);
    expect(alone.page.work.find('main.py')?.text).toBe('meins = 1\n');
    const whole = pageWith('meins = 1\n');
    expect(openAddress(whole, `${location.origin}/?task=${id}`)).toBeNull();
    expect(whole.work.find('main.py')?.text).toBe(course.program.de);
  });
});

describe('a QR code', () => {
  it('has a quiet rim of four squares, as readers want it', () => {
    const { path, size } = qrPath('https://example.org/#p=1')!;
    const runs = [...path.matchAll(/M(\d+) (\d+)h(\d+)/g)].map(([, x, y, length]) => [x, y, length].map(Number));
    expect(Math.min(...runs.map(([x]) => x!))).toBe(4);
    expect(Math.min(...runs.map(([, y]) => y!))).toBe(4);
    expect(Math.max(...runs.map(([x, , length]) => x! + length!))).toBe(size - 4);
  });

  it('holds 2953 characters and not one more', () => {
    expect(qrPath('x'.repeat(2953))?.size).toBe(177 + 8);
    expect(qrPath('x'.repeat(2954))).toBeNull();
  });
});
