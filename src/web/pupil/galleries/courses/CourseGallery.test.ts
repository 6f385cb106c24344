// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import { lightColors } from '#picture/colors';
import { withoutSecrets } from '#check/task/write-task';
import { defaultScene } from '#scene/scene';
import { byId, fieldById, idsShown, isThere, pressKey, tap, write } from '../../../app/testing/find';
import { goBackAtOnce, leavePage, mountOn, named, textOf } from '../../../app/testing/mount-on';
import { createPage } from '../../../app/testing/page';
import { loadTexts, showLanguage, shownLanguage } from '../../../kit/i18n';
import { LANGUAGES } from '../../../kit/i18n/texts';
import { courses } from '#catalogue/courses';
import CourseGallery from './CourseGallery.vue';

/** The gallery of courses, at the page that the address names. */
async function galleryAt(id?: string) {
  const page = createPage();
  page.settings.change({ language: shownLanguage() });
  page.router.open('courses', id);
  mountOn(page, CourseGallery);
  await nextTick();
  const title = (): string => textOf(document.querySelector('.gallery h2'));
  return { page, title };
}
/** As `textOf` shows it: narrow spaces are spaces. */
const flat = (text: string): string => text.replace(/\s+/g, ' ').trim();
const cards = (): readonly Element[] => [...document.querySelectorAll('.gallery li.card')];
const shownCourses = (): readonly string[] => idsShown('course-').map((id) => id.slice('course-'.length));
const idsOf = (kind: string): readonly string[] => courses.filter((it) => it.kind === kind).map(({ id }) => id);

beforeEach(() => {
  goBackAtOnce();
});
afterEach(() => {
  vi.restoreAllMocks();
  history.replaceState(null, '', '/');
});

describe('the cards of all courses', () => {
  it('are one for each ready course, in the order of the list, and two made from a number', async () => {
    await galleryAt();
    expect(shownCourses()).toEqual(courses.map(({ id }) => id));
    expect(idsShown('random-')).toEqual(['random-maze', 'random-track']);
    expect(cards()).toHaveLength(courses.length + 2);
  });

  it('each say the name, the task, how hard it is and for which robot, and have an address for another tab', async () => {
    await galleryAt();
    for (const course of courses) {
      const card = byId(`course-${course.id}`);
      const text = textOf(card);
      expect(text).toContain(course.texts.de.name);
      expect(text).toContain(flat(course.texts.de.task));
      expect(text).toContain(`Schwierigkeit: ${['leicht', 'mittel', 'schwer'][course.level - 1]!}`);
      expect(text).toMatch(/Roboter: (Maqueen|Calli:bot)/);
      expect(card.querySelectorAll('.level circle.on'), course.id).toHaveLength(course.level);
      expect(card.querySelector('h3 a')?.getAttribute('href')).toBe(
        new URL(`#courses/${course.id}`, location.href).href,
      );
    }
  });

  it('show the picture of their own arena: its size and its walls', async () => {
    await galleryAt();
    await tap('filter-maze');
    const { scene } = courses.find(({ id }) => id === 'small-maze')!;
    const picture = byId('course-small-maze').querySelector('svg.preview')!;
    expect(picture.getAttribute('viewBox')).toBe(`0 0 ${String(scene.size[0])} ${String(scene.size[1])}`);
    const walls = scene.objects.filter(({ type }) => type === 'wall');
    expect(walls.length).toBeGreaterThan(3);
    expect(picture.querySelectorAll(`rect[fill="${lightColors.wall}"]`)).toHaveLength(walls.length);
  });

  it.each(LANGUAGES)('are in the language of the page: %s', async (language) => {
    await loadTexts(language);
    showLanguage(language);
    await galleryAt();
    await tap('filter-obstacles');
    for (const course of courses.filter(({ kind }) => kind === 'obstacles')) {
      const card = byId(`course-${course.id}`);
      expect(textOf(card.querySelector('h3'))).toBe(flat(course.texts[language].name));
      expect(textOf(card)).toContain(flat(course.texts[language].task));
    }
  });
});

describe('the filters of the courses', () => {
  const filters = ['all', 'free', 'line', 'drive', 'obstacles', 'maze', 'blocks', 'random'];
  const pressed = (): readonly string[] =>
    idsShown('filter-').filter((id) => byId(id).getAttribute('aria-pressed') === 'true');

  it('are one for each kind, and all courses are shown at first', async () => {
    await galleryAt();
    expect(new Set(idsShown('filter-'))).toEqual(new Set(filters.map((one) => `filter-${one}`)));
    expect(pressed()).toEqual(['filter-all']);
  });

  it.each(['line', 'drive', 'obstacles', 'blocks'])('show only the courses of their kind: %s', async (kind) => {
    await galleryAt();
    await tap(`filter-${kind}`);
    expect(idsOf(kind).length).toBeGreaterThan(0);
    expect(shownCourses()).toEqual(idsOf(kind));
    expect(pressed()).toEqual([`filter-${kind}`]);
  });

  it('show the random maze among the mazes and the random line among the lines', async () => {
    await galleryAt();
    await tap('filter-maze');
    expect(idsShown('random-')).toEqual(['random-maze']);
    await tap('filter-line');
    expect(idsShown('random-')).toEqual(['random-track']);
    await tap('filter-blocks');
    expect(idsShown('random-')).toEqual([]);
  });

  it('show the two random courses alone', async () => {
    await galleryAt();
    await tap('filter-random');
    expect(shownCourses()).toEqual([]);
    expect(idsShown('random-')).toEqual(['random-maze', 'random-track']);
  });

  it('say to a screen reader how many courses are left', async () => {
    await galleryAt();
    const said = (): string => textOf(document.querySelector('.overview [role="status"]'));
    expect(said()).toBe(`${String(courses.length + 2)} Parcours`);
    await tap('filter-maze');
    expect(said()).toBe(`${String(idsOf('maze').length + 1)} Parcours`);
  });

  it('are one stop for the Tab key; the arrow keys lead round from one to the next', async () => {
    await galleryAt();
    const stops = (): readonly string[] => idsShown('filter-').filter((id) => byId(id).tabIndex === 0);
    expect(stops()).toEqual(['filter-all']);
    byId('filter-all').focus();
    await pressKey('ArrowLeft');
    expect([stops(), document.activeElement]).toEqual([['filter-random'], byId('filter-random')]);
    await pressKey('ArrowRight');
    await pressKey('ArrowRight');
    expect(document.activeElement).toBe(byId(idsShown('filter-')[1]!));
    expect(pressed()).toEqual([idsShown('filter-')[1]]);
  });

  it('stay as they were while the gallery is closed and opened again', async () => {
    const { page } = await galleryAt();
    await tap('filter-blocks');
    page.router.open('courses', 'carry');
    await nextTick();
    page.router.open('courses');
    await nextTick();
    expect(pressed()).toEqual(['filter-blocks']);
    expect(shownCourses()).toEqual(idsOf('blocks'));
  });
});

describe('a card', () => {
  it('opens its course, with its program, and the gallery goes away', async () => {
    const { page } = await galleryAt();
    await tap('open-slalom');
    const slalom = courses.find(({ id }) => id === 'slalom')!;
    expect(page.work.work.value.project.course).toBe('slalom');
    expect(page.work.scene.value).toEqual(slalom.scene);
    expect(page.work.find('main.py')?.text).toBe(slalom.program.de);
    expect(page.router.page.value).toBeNull();
  });

  it('of the course in the arena says so and offers to open it once more', async () => {
    const { page } = await galleryAt();
    await tap('open-slalom');
    page.router.open('courses');
    await nextTick();
    const card = byId('course-slalom');
    expect(textOf(card)).toContain('Jetzt offen');
    expect(textOf(card)).not.toContain('Mehr');
    named('Noch einmal öffnen: Slalom');
    expect(cards().filter((it) => textOf(it).includes('Jetzt offen'))).toEqual([card]);
  });

  it('leads to the course’s page with “Mehr” and with its title, without leaving this tab', async () => {
    const { page } = await galleryAt();
    await tap(named('Mehr über Slalom'));
    expect(page.router.page.value).toEqual({ name: 'courses', id: 'slalom' });
    page.router.open('courses');
    await nextTick();
    const link = byId('course-slalom').querySelector('a')!;
    const click = new MouseEvent('click', { bubbles: true, cancelable: true });
    link.dispatchEvent(click);
    expect(click.defaultPrevented).toBe(true);
    expect(page.router.page.value).toEqual({ name: 'courses', id: 'slalom' });
  });
});

describe('the frame of the gallery', () => {
  it('names the course that is shown, and leads back to all of them', async () => {
    const { title, page } = await galleryAt('slalom');
    expect(title()).toBe('Slalom');
    await tap('gallery-all');
    expect(page.router.page.value).toEqual({ name: 'courses', id: null });
    expect(title()).toBe('Alle Parcours');
    expect(isThere('gallery-all')).toBe(false);
  });

  it('puts a screen reader on the heading of another page', async () => {
    await galleryAt();
    await tap(named('Mehr über Slalom'));
    expect(textOf(document.activeElement)).toBe('Slalom');
  });

  it('is closed by its button', async () => {
    const { page } = await galleryAt('slalom');
    await tap('gallery-close');
    expect(page.router.page.value).toBeNull();
  });

  it('gives the keyboard back to what had it', async () => {
    const button = document.body.appendChild(document.createElement('button'));
    button.focus();
    const page = createPage();
    page.router.open('courses');
    const gallery = mountOn(page, CourseGallery);
    await nextTick();
    byId('gallery-close').focus();
    expect(document.documentElement.classList.contains('shows-gallery')).toBe(true);
    leavePage(gallery);
    expect(document.activeElement).toBe(button);
    expect(document.documentElement.classList.contains('shows-gallery')).toBe(false);
  });

  it('says that a course is unknown, and shows all others', async () => {
    const { title } = await galleryAt('no-such-course');
    expect(textOf(byId('unknown-course'))).toBe('Diesen Parcours gibt es hier nicht.');
    expect(title()).toBe('Alle Parcours');
    expect(shownCourses()).toHaveLength(courses.length);
  });
});

describe('the page of a course', () => {
  const facts = (): Readonly<Record<string, string>> =>
    Object.fromEntries(
      [...document.querySelectorAll('.sheet dt')].map((dt) => [textOf(dt), textOf(dt.nextElementSibling)]),
    );

  it.each(['empty', 'distance', 'slalom', 'large-maze', 'carry'])(
    '%s tells its text, its task, its arena and its rules',
    async (id) => {
      const course = courses.find((it) => it.id === id)!;
      await galleryAt(id);
      const sheet = textOf(document.querySelector('.sheet'));
      expect(sheet).toContain(flat(course.texts.de.text));
      expect(textOf(document.querySelector('.task p'))).toBe(flat(course.texts.de.task));
      const told = facts();
      const [width, height] = course.scene.size;
      expect(told['Arena']).toBe(`${String(width / 10)} × ${String(height / 10)} cm`);
      const { seconds, noTouch } = course.scene.task;
      expect(told['Zeit']).toBe(seconds === null ? undefined : `höchstens ${String(seconds)} s`);
      expect(told['Regel']).toBe(noTouch ? 'nirgends anstossen' : undefined);
    },
  );

  it('opens the course with its beginning, or with its solution', async () => {
    const slalom = courses.find(({ id }) => id === 'slalom')!;
    expect(slalom.solution.de).not.toBe(slalom.program.de);
    const first = await galleryAt('slalom');
    await tap('open-slalom');
    expect(first.page.work.find('main.py')?.text).toBe(slalom.program.de);
    first.page.router.open('courses', 'slalom');
    await nextTick();
    await tap('open-solved');
    expect(first.page.work.find('main.py')?.text).toBe(slalom.solution.de);
    expect(first.page.router.page.value).toBeNull();
  });

  it('keeps the solution folded until it is asked for, with the advice to try first', async () => {
    await galleryAt('slalom');
    const solution = document.querySelector<HTMLDetailsElement>('details.solution')!;
    expect(solution.open).toBe(false);
    expect(textOf(solution)).toContain('Versuche es zuerst selbst');
    expect(solution.querySelector('pre')?.textContent).toBe(courses.find(({ id }) => id === 'slalom')!.solution.de);
  });

  it('offers no solution where the course begins with it', async () => {
    const whole = courses.find(({ program, solution }) => program.en === solution.en)!;
    await galleryAt(whole.id);
    expect(isThere('show-solution')).toBe(false);
    expect(isThere(`open-${whole.id}`)).toBe(true);
  });

  it('offers none while a task is open that a teacher has handed out without solutions', async () => {
    const { page } = await galleryAt('slalom');
    expect(isThere('show-solution')).toBe(true);
    const locks = { solution: true };
    const task = { version: 1, checks: [{ type: 'loop', id: 'loop' }], locks };
    page.work.openProject(
      withoutSecrets({ files: [{ name: 'main.py', text: '' }], scene: defaultScene(), course: null, task }),
      null,
    );
    await vi.waitFor(() => expect(isThere('show-solution')).toBe(false));
  });

  it('copies its address and says so', async () => {
    const copied: string[] = [];
    vi.spyOn(navigator.clipboard, 'writeText').mockImplementation((text) => Promise.resolve(void copied.push(text)));
    await galleryAt('slalom');
    await tap('copy-address');
    await vi.waitFor(() => expect(textOf(byId('copy-address'))).toBe('Kopiert'));
    expect(copied).toEqual([new URL('#courses/slalom', location.href).href]);
  });

  it('shows its address where the browser forbids copying', async () => {
    vi.spyOn(navigator.clipboard, 'writeText').mockRejectedValue(new Error('forbidden'));
    await galleryAt('slalom');
    await tap('copy-address');
    await vi.waitFor(() => expect(document.querySelector('.sheet [role="alert"]')).not.toBeNull());
    const alert = textOf(document.querySelector('.sheet [role="alert"]'));
    expect(alert).toContain('Der Browser lässt das Kopieren nicht zu.');
    expect(alert).toContain(new URL('#courses/slalom', location.href).href);
  });
});

describe('the page of a course made from a number', () => {
  const seed = (): HTMLInputElement => fieldById('random-seed');
  const address = (): string => location.hash;

  it('is called by its kind and shows the number and the size of its address', async () => {
    const { title } = await galleryAt('maze-m-4711');
    expect(title()).toBe('Zufälliges Labyrinth');
    expect(seed().value).toBe('4711');
    expect(fieldById('random-size').value).toBe('m');
    expect(textOf(document.querySelector('.sheet .text'))).toContain('Aus der Zahl 4711');
  });

  it('follows the number that is typed, and so does the address', async () => {
    await galleryAt('maze-m-4711');
    const walls = (): string => document.querySelector('.sheet .preview')!.innerHTML;
    const before = walls();
    await write(seed(), '12');
    expect(address()).toBe('#courses/maze-m-12');
    expect(walls()).not.toBe(before);
    await write(seed(), '4711');
    expect(walls()).toBe(before);
  });

  it.each(['abc', '0', '1.5', ''])('cannot be opened or copied while the field has “%s”', async (text) => {
    const { page } = await galleryAt('track-s-5');
    await write(seed(), text);
    expect(textOf(document.querySelector('#seed-problem'))).toBe('Nur ganze Zahlen von 1 bis 999999');
    expect(seed().getAttribute('aria-invalid')).toBe('true');
    expect(fieldById('open-track-s-5').disabled).toBe(true);
    expect(fieldById('copy-address').disabled).toBe(true);
    const before = page.work.scene.value;
    await tap('open-track-s-5');
    expect(page.work.scene.value).toBe(before);
  });

  it('brings the number back when an emptied field is left; a wrong one stays to be mended', async () => {
    await galleryAt('track-s-5');
    await write(seed(), '');
    seed().dispatchEvent(new Event('blur'));
    await nextTick();
    expect(seed().value).toBe('5');
    await write(seed(), '5x');
    seed().dispatchEvent(new Event('blur'));
    await nextTick();
    expect(seed().value).toBe('5x');
  });

  it('grows with its size', async () => {
    await galleryAt('maze-s-7');
    const box = (): string => document.querySelector('.sheet .preview')!.getAttribute('viewBox')!;
    expect(box()).toBe('0 0 1000 750');
    const size = fieldById('random-size');
    size.value = 'l';
    size.dispatchEvent(new Event('change'));
    await nextTick();
    expect(address()).toBe('#courses/maze-l-7');
    expect(box()).toBe('0 0 2000 1500');
  });

  it('takes another number with the dice, and leaves no page behind for each', async () => {
    const { page } = await galleryAt('maze-s-7');
    const steps = history.length;
    await tap('random-new');
    expect(address()).toMatch(/^#courses\/maze-s-[1-9]\d*$/);
    expect(address()).not.toBe('#courses/maze-s-7');
    expect(history.length).toBe(steps);
    expect(page.router.page.value).toEqual({ name: 'courses', id: address().slice('#courses/'.length) });
  });

  it('opens what is shown, as the pupil’s own course', async () => {
    const { page } = await galleryAt('maze-s-7');
    await tap('open-maze-s-7');
    expect(page.work.work.value.project.course).toBeNull();
    expect(page.work.scene.value.name).toBe('Labyrinth 7, klein');
  });

  it('is the one that its card shows from then on', async () => {
    const { page } = await galleryAt('maze-s-7');
    page.router.open('courses');
    await nextTick();
    const href = byId('random-maze').querySelector('a')!.getAttribute('href');
    expect(href).toMatch(/#courses\/maze-s-7$/);
  });
});
