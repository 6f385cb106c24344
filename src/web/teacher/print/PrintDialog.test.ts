// @vitest-environment happy-dom
import { afterEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import { partCourse } from '#editor/parts/part-course';
import { readyPart } from '#editor/parts/ready-parts';
import { fetchDrawing } from '#robots/drawings';
import { robotTypes } from '#robots/index';
import { defaultScene, type Scene } from '#scene/scene';

import { downloads, type Download } from '../../app/testing/downloads';
import { byId, fieldById, idsShown, isThere, tap } from '../../app/testing/find';
import { mountOn, named, textOf } from '../../app/testing/mount-on';
import { createPage } from '../../app/testing/page';
import PrintDialog from './PrintDialog.vue';

// The robot is in the picture from the start.
await Promise.all(robotTypes.map(({ id }) => fetchDrawing(id)));

/** The dialog on a course of this size with a line and a wall. */
async function dialog(change: Partial<Scene> = {}, other: Scene | null = null) {
  const page = createPage();
  page.settings.change({ language: 'de' });
  const scene: Scene = {
    ...defaultScene(),
    name: 'Meine Strecke',
    size: [1200, 900],
    objects: [
      { type: 'stroke', id: 's', points: [[100, 850], [250, 850]], width: 20, color: 'black' }, // prettier-ignore
      { type: 'wall', id: 'w', from: [600, 100], to: [600, 400], thickness: 10 },
    ],
    ...change,
  };
  page.work.openProject({ files: [{ name: 'main.py', text: 'from mbrobot import *\n' }], scene, course: null }, null);
  const closed = vi.fn();
  mountOn(page, PrintDialog, { onClose: closed, other });
  await nextTick();
  return { page, closed };
}
const said = (): string => textOf(byId('print-said'));
const picture = (): string => decodeURIComponent(byId('picture-preview').getAttribute('src')!);
const box = (id: string): HTMLInputElement => fieldById(`picture-${id}`);
const paper = async (id: string): Promise<void> => {
  byId(`paper-${id}`).click();
  byId(`paper-${id}`).dispatchEvent(new Event('change'));
  await nextTick();
};
const sheets = (): number => document.querySelectorAll('.tiles rect').length;

afterEach(() => void vi.restoreAllMocks());

describe('the picture of a course', () => {
  it('shows grid, rulers and the robot at first; a robot that has not driven has left no trail', async () => {
    await dialog();
    expect(['grid', 'rulers', 'robot', 'path'].map((id) => box(id).checked)).toEqual([true, true, true, false]);
    expect(box('path').disabled).toBe(true);
    expect(box('robot').disabled).toBe(false);
  });

  it.each(['grid', 'rulers', 'robot'])('leaves out what is not wanted and brings it back: %s', async (id) => {
    await dialog();
    const whole = picture();
    box(id).click();
    await nextTick();
    expect(picture().length).toBeLessThan(whole.length);
    box(id).click();
    await nextTick();
    expect(picture()).toBe(whole);
  });

  it('has no robot to show for the microcomputer alone', async () => {
    const { page } = await dialog();
    page.settings.change({ robot: 'none' });
    await nextTick();
    expect([box('robot').disabled, box('robot').checked]).toEqual([true, false]);
  });

  it('is saved as a drawing under the course’s name, as the preview shows it', async () => {
    const saved = downloads();
    await dialog();
    const shown = picture();
    await tap(named('SVG: als Zeichnung speichern (für Inkscape und Word)'));
    await vi.waitFor(() => expect(said()).toBe('Meine Strecke.svg ist gespeichert.'));
    expect(saved.map(({ name }) => name)).toEqual(['Meine Strecke.svg']);
    expect(shown).toContain(await saved[0]!.blob.text());
  });

  it('says that it works on it, and takes no second wish meanwhile', async () => {
    downloads();
    await dialog();
    const button = named('SVG: als Zeichnung speichern (für Inkscape und Word)') as HTMLButtonElement;
    await tap(button);
    expect(said()).toBe('Einen Moment …');
    expect(button.disabled).toBe(true);
    await vi.waitFor(() => expect(button.disabled).toBe(false));
  });

  it('says when it could not be made', async () => {
    vi.spyOn(URL, 'createObjectURL').mockImplementation(() => {
      throw new Error('no memory');
    });
    await dialog();
    await tap(named('SVG: als Zeichnung speichern (für Inkscape und Word)'));
    await vi.waitFor(() => expect(said()).toContain('Das hat nicht geklappt.'));
    expect(byId('print-said').classList.contains('said--error')).toBe(true);
  });
});

describe('the task of the course', () => {
  const description = 'Fahre **links** um das Tor.';
  const card = {
    language: 'de',
    title: 'Das Tor',
    hints: ['Nimm left().'],
    translations: [],
    picture: '',
    solution: true,
  };
  const withTask: Partial<Scene> = { description, task: { seconds: 20, noTouch: true, stars: [15, 9], card } };
  const pageCount = async ({ blob }: Download): Promise<number> =>
    (await blob.text()).match(/\/Type \/Page\b/g)?.length ?? 0;

  it('is offered where there is one, neither in the picture nor on paper elsewhere', async () => {
    await dialog();
    expect(isThere('picture-task')).toBe(false);
    await tap('print-print');
    expect(isThere('print-task')).toBe(false);
  });

  it('stands in the picture on request only', async () => {
    await dialog(withTask);
    expect(box('task').checked).toBe(false);
    expect(picture()).not.toContain('Das Tor');
    box('task').click();
    await nextTick();
    expect(picture()).toContain('Das Tor');
    expect(picture()).toMatch(/>links<\/tspan> um das Tor\./);
    expect(picture()).not.toContain('left()');
  });

  it('is printed on a sheet of its own unless it is not wanted', async () => {
    const files = downloads();
    await dialog(withTask);
    await tap('print-print');
    await paper('exact');
    expect(fieldById('print-task').checked).toBe(true);
    await tap('save-pdf');
    await vi.waitFor(() => expect(said()).toContain('gespeichert'), 20_000);
    expect(await pageCount(files[0]!)).toBe(2);
    byId('print-task').click();
    await nextTick();
    expect(isThere('print-hints')).toBe(false);
    await tap('save-pdf');
    await vi.waitFor(() => expect(files).toHaveLength(2), 20_000);
    expect(await pageCount(files[1]!)).toBe(1);
  });
});

describe('the course true to scale', () => {
  it('lies on 25 sheets of A4 for 120 × 90 cm, and the preview shows each of them', async () => {
    await dialog();
    await tap('print-print');
    expect(fieldById('paper-a4-tiles').checked).toBe(true);
    expect(textOf(byId('paper-a4-tiles').parentElement)).toContain('25 Blätter');
    expect(sheets()).toBe(25);
  });

  it('offers the single sheets on which it fits, and one made to measure', async () => {
    await dialog();
    await tap('print-print');
    expect(idsShown('paper-')).toEqual(['paper-a4-tiles', 'paper-a3-tiles', 'paper-exact']);
    expect(textOf(byId('paper-exact').parentElement)).toContain('122 × 92 cm');
    await paper('exact');
    expect(sheets()).toBe(1);
  });

  it('offers A3 and all larger sheets for a small arena', async () => {
    await dialog({ size: [400, 270], objects: [] });
    await tap('print-print');
    expect(idsShown('paper-')).toEqual(
      ['a4-tiles', 'a3-tiles', 'a3', 'a2', 'a1', 'a0', 'exact'].map((id) => `paper-${id}`),
    );
  });

  it('warns of many sheets to glue, and refuses more than 150', async () => {
    await dialog({ size: [2000, 1600], objects: [] });
    await tap('print-print');
    expect(textOf(byId('print-problem'))).toContain('Das sind viele Blätter zum Kleben.');
    await paper('a3-tiles');
    expect(isThere('print-problem')).toBe(false);
  });

  it('begins with another paper where A4 would take too many sheets, and does not print on those', async () => {
    await dialog({ size: [3000, 3000], objects: [] });
    await tap('print-print');
    expect(fieldById('paper-exact').checked).toBe(true);
    await paper('a4-tiles');
    expect(textOf(byId('print-problem'))).toMatch(/^\d{3} Blätter: das sind zu viele\./);
    expect(fieldById('save-pdf').disabled).toBe(true);
    expect(sheets()).toBe(0);
  });

  it('is saved as a PDF with a page for each sheet and one for the plan', async () => {
    const saved = downloads();
    await dialog();
    await tap('print-print');
    await tap('save-pdf');
    await vi.waitFor(() => expect(said()).toBe('Meine Strecke.pdf ist gespeichert.'), 20_000);
    const text = await saved[0]!.blob.text();
    expect(saved[0]!.name).toBe('Meine Strecke.pdf');
    expect(text.startsWith('%PDF-')).toBe(true);
    expect(text.match(/\/Type \/Page\b/g)).toHaveLength(26);
  });

  it('has the outline of walls only on request', async () => {
    const saved = downloads();
    await dialog();
    await tap('print-print');
    await paper('exact');
    await tap('save-pdf');
    await vi.waitFor(() => expect(saved).toHaveLength(1), 20_000);
    await vi.waitFor(() => expect(said()).toContain('gespeichert'));
    const outlines = [...document.querySelectorAll<HTMLInputElement>('input[type="checkbox"]')].at(-1)!;
    outlines.click();
    await nextTick();
    await tap('save-pdf');
    await vi.waitFor(() => expect(saved).toHaveLength(2), 20_000);
    expect(saved[1]!.blob.size).toBeLessThan(saved[0]!.blob.size);
  });

  it('is closed by its button', async () => {
    const { closed } = await dialog();
    await tap(named('Schliessen'));
    expect(closed).toHaveBeenCalledOnce();
  });
});

describe('the worksheet', () => {
  const description = 'Fahre **links** um das Tor.';
  const card = {
    ...{ language: 'de', title: 'Das Tor', hints: ['Nimm left().'], translations: [], picture: '', solution: true },
  } as const;
  const withTask: Partial<Scene> = { description, task: { seconds: 20, noTouch: true, card } };
  const pages = (): readonly string[] =>
    [...document.querySelectorAll('[data-testid="sheet-page"]')].map((page) =>
      decodeURIComponent(page.getAttribute('src')!),
    );
  const sheet = async (change: Partial<Scene> = {}): Promise<string> => {
    await dialog(change);
    await tap('print-sheet');
    await vi.waitFor(() => expect(pages()).not.toEqual([]), 20_000); // its part of the page is fetched
    return pages().join('');
  };
  const wish = async (id: string): Promise<string> => {
    byId(`sheet-${id}`).click();
    await nextTick();
    await nextTick();
    return pages().join('');
  };

  it('has task, course with its scale, a code and lines to write on, on one page', async () => {
    const shown = await sheet(withTask);
    expect(pages()).toHaveLength(1);
    for (const words of ['Das Tor', 'Name', 'Klasse', 'Datum', 'um das Tor.', 'Halte 20 s durch', 'nichts berühren'])
      expect(shown).toContain(words);
    expect(shown).toMatch(/120 × 90 cm, Massstab 1:\d+ \(1 cm auf dem Blatt = \d+ cm\)/);
    expect(shown).toMatch(/So will ich vorgehen.*Das habe ich beobachtet/);
    expect(shown).not.toContain('left()');
  });

  it('has the name of the course for a title where there is no task', async () => {
    expect(await sheet()).toContain('>Meine Strecke<');
    expect(isThere('sheet-hints')).toBe(false);
  });

  it('has the hints, no code and no lines if that is wanted', async () => {
    const before = await sheet(withTask);
    await wish('hints');
    await vi.waitFor(() => expect(pages().join('')).toContain('left()'));
    expect(before).toContain('crispEdges');
    expect(await wish('qr')).not.toContain('crispEdges');
    byId('sheet-space-none').dispatchEvent(new Event('change', { bubbles: true }));
    await nextTick();
    expect(pages().join('')).not.toContain('So will ich vorgehen');
  });

  it('opens the course without the program of the editor, which may be a solution, unless that is wanted', async () => {
    const without = await sheet(withTask);
    expect(fieldById('sheet-program').checked).toBe(false);
    expect(await wish('program')).not.toBe(without);
  });

  it('says that a link is too long to be read from paper, and what to do; the sheet has no code then', async () => {
    const objects = Array.from({ length: 150 }, (_, place) => ({
      ...{ type: 'label', id: String(place), at: [place * 7, (place * 373) % 900] as const, angle: (place * 77) % 360 },
      ...{ text: `Nr. ${String(place * 7919)} ${String((place * 104729) % 99991)}`, height: 20 + (place % 31) },
    })) as Scene['objects'];
    const shown = await sheet({ ...withTask, objects });
    expect(textOf(byId('sheet-no-qr'))).toMatch(
      /^Ohne QR-Code: Der Link hat \d+ Zeichen, .*1628 .*«Als Datei speichern»/,
    );
    expect(shown).not.toContain('crispEdges');
  });

  it('shows names of starts and numbers of checkpoints in 9 pt at least, also of four robots in a large arena', async () => {
    const starts = ['Ada', 'Ben', 'Cem'].map((name, place) => ({
      ...{ type: 'start', id: name, name, at: [3000, 1000 + 1500 * place] as const, heading: 0 },
      ...{ robot: null, options: {}, color: null },
    }));
    const checkpoint = { type: 'checkpoint', id: 'c', at: [6000, 3000], size: [600, 600], angle: 0, round: true, number: 7, blocks: 0 }; // prettier-ignore
    const objects = [...starts, checkpoint] as unknown as Scene['objects'];
    const shown = await sheet({ ...withTask, size: [8000, 6000], objects });
    const scale = Number(/Massstab 1:(\d+)/.exec(shown)![1]);
    for (const words of ['Ada', 'Ben', 'Cem', '7']) {
      const [, size = ''] = new RegExp(`font-size="([\\d.]+)"[^>]*>${words}</text>`).exec(shown)!;
      expect((Number(size) / scale) * (72 / 25.4)).toBeGreaterThanOrEqual(9);
    }
  });
});

describe('a part alone', () => {
  it('is printed at true size on one sheet of A4, under its name, without robot and task', async () => {
    await dialog({ description: 'Fahr ins Ziel.' }, partCourse(readyPart('curve'), 'Kurve'));
    expect(isThere('print-sheet')).toBe(false);
    expect([sheets(), isThere('print-task')]).toEqual([1, false]);
    await tap('print-picture');
    expect([box('robot').disabled, isThere('picture-task')]).toEqual([true, false]);
    await tap('print-print');
    const saved = downloads();
    await tap('save-pdf');
    await vi.waitFor(() => expect(said()).toBe('Kurve.pdf ist gespeichert.'), 20_000);
    const text = await saved[0]!.blob.text();
    expect(text).toMatch(/\/MediaBox \[0 0 595\.2\d+ 841\.8\d+\]/); // 210 × 297 mm in units of 1/72 inch
    expect(text.match(/\/Type \/Page\b/g)).toHaveLength(1);
  });
});

describe('the worksheet', () => {
  it('is what a teacher sees at once who comes for it from the page of the task', async () => {
    const page = createPage();
    mountOn(page, PrintDialog, { isSheet: true });
    await nextTick();
    expect(byId('print-sheet').getAttribute('aria-pressed')).toBe('true');
    await vi.waitFor(() => expect(isThere('sheet-page')).toBe(true), 20_000);
  });
});
