// @vitest-environment happy-dom
import { flushPromises } from '@vue/test-utils';
import { beforeEach, describe, expect, it, vi } from 'vitest';
import { nextTick } from 'vue';

import { projectToText } from '#project/file';
import { defaultScene, type Scene } from '#scene/scene';
import { serializeScene } from '#scene/serialize';

import AppDialog from '../../app/AppDialog.vue';
import { downloads } from '../../app/testing/downloads';
import { press } from '../../app/testing/editing';
import { mountOn, textOf } from '../../app/testing/mount-on';
import { createPage, type TestPage } from '../../app/testing/page';
import { startRun } from '../../app/testing/run';
import { t } from '../../kit/i18n';
import { projectOf } from '#catalogue/course';
import { courseName, firstCourse } from '../../session/work/catalogue/first-course';
import { useCourses } from '../../session/work/use-courses';
import type { TaskLocks } from '../../session/work/model/task-locks';
import { replaceFile } from './load-files';
import { commandsOf } from './use-commands';

let page: TestPage;
beforeEach(() => {
  page = createPage();
  page.settings.change({ language: 'de' });
});

/** Waits until the page has said something else than before, and gives it in words. */
async function told(act: () => void): Promise<string> {
  page.notices.close();
  act();
  await vi.waitFor(() => expect(page.notices.current.value).not.toBeNull(), { timeout: 20_000, interval: 5 });
  return notice();
}
function notice(): string {
  const { key, values } = page.notices.current.value!;
  return t(key, values);
}
const take = (...files: readonly File[]): void => commandsOf(page).take(files);
const file = (name: string, content: BlobPart = ''): File => new File([content], name);
const texts = (): Readonly<Record<string, string>> =>
  Object.fromEntries(page.work.files.value.map(({ name, text }) => [name, text]));
const kept = (): readonly string[] => page.work.work.value.previous.map(({ name }) => name);
const course: Scene = { ...defaultScene(), name: 'Neuland', size: [700, 500] };

it('a program does not take the place of lines that the open task keeps; nothing is put aside, and no other thing is said', () => {
  page.work.setText('main.py', 'kept()\n');
  const changed = vi.fn(() => null);
  page.work.locks.task.value = { changed } as unknown as TaskLocks;
  replaceFile(page, { name: 'main.py', text: 'forward()\n' });
  expect([changed.mock.calls.length, texts()['main.py'], kept(), page.notices.current.value]).toEqual([
    1,
    'kept()\n',
    [],
    null,
  ]);
});

describe('a program that is taken in', () => {
  it('becomes a file of its own, and is shown', async () => {
    expect(await told(() => take(file('turn.py', 'left = 1\n')))).toBe('turn.py ist geladen.');
    expect(texts()['turn.py']).toBe('left = 1\n');
    expect(page.work.open.value.name).toBe('turn.py');
    expect(page.notices.current.value?.kind).toBe('ok');
  });

  it('has line ends as the editor has them', async () => {
    await told(() => take(file('turn.py', 'a = 1\r\nb = 2\r\n')));
    expect(texts()['turn.py']).toBe('a = 1\nb = 2\n');
  });

  it('is one of several that come together', async () => {
    take(file('one.py', '1\n'), file('two.py', '2\n'));
    await vi.waitFor(() => expect(Object.keys(texts())).toEqual(['main.py', 'one.py', 'two.py']));
    expect(page.work.open.value.name).toBe('two.py');
  });

  it('is only shown where it is there already, letter for letter', async () => {
    page.work.create('turn.py', 'left = 1\n');
    page.work.show('main.py');
    expect(await told(() => take(file('turn.py', 'left = 1\r\n')))).toBe('turn.py ist geladen.');
    expect(page.work.open.value.name).toBe('turn.py');
    expect(Object.keys(texts())).toEqual(['main.py', 'turn.py']);
    expect(page.dialogs.current.value).toBeNull();
  });

  it('fills an empty file of its name without asking', async () => {
    page.work.setText('main.py', '  \n');
    expect(await told(() => take(file('main.py', 'left = 1\n')))).toBe('main.py ist geladen.');
    expect(texts()).toEqual({ 'main.py': 'left = 1\n' });
  });

  it.each([
    ['is no text', 'broken.py', new Uint8Array([0x78, 0xff, 0xfe, 0x00]), 'broken.py ist kein Text.'],
    ['is larger than 256 kB', 'large.py', ' '.repeat(256 * 1024 + 1), 'large.py ist zu gross: 257 kB, erlaubt sind 256 kB.'], // prettier-ignore
    ['has a name that no board takes', 'my file.py', 'x = 1\n', 'my file.py ist keine Python-Datei (.py).'],
  ])('is refused when it %s: nothing changes', async (_why, name, content, words) => {
    const before = page.work.work.value;
    expect(await told(() => take(file(name, content)))).toBe(words);
    expect(page.notices.current.value?.kind).toBe('error');
    expect(page.work.work.value).toBe(before);
  });

  it('does not keep the next one from being taken when it is refused', async () => {
    take(file('broken.py', new Uint8Array([0xff, 0])), file('fine.py', 'x = 1\n'));
    await vi.waitFor(() => expect(page.work.open.value.name).toBe('fine.py'));
    expect(Object.keys(texts())).not.toContain('broken.py');
  });
});

describe('a program whose name is taken', () => {
  const dialog = () => textOf(document.querySelector('.dialog-card'));
  async function asked(): Promise<void> {
    mountOn(page, AppDialog);
    page.work.setText('main.py', 'mine = 1\n');
    take(file('main.py', 'theirs = 2\n'));
    await vi.waitFor(() => expect(page.dialogs.current.value).not.toBeNull());
    await flushPromises();
  }
  const answer = (name: string) => press(name, '.dialog-card button');

  it('is asked about before anything is overwritten', async () => {
    await asked();
    expect(dialog()).toContain('main.py gibt es schon');
    expect(texts()).toEqual({ 'main.py': 'mine = 1\n' });
  });

  it('is left out on “cancel”', async () => {
    await asked();
    await answer('Abbrechen');
    expect(texts()).toEqual({ 'main.py': 'mine = 1\n' });
    expect(page.notices.current.value).toBeNull();
  });

  it('stands beside the other under a free name, which the button says', async () => {
    page.work.create('main2.py', 'x\n');
    await asked();
    const as = /Als (\S+\.py) laden/.exec(dialog())?.[1] ?? '';
    expect(Object.keys(texts())).not.toContain(as);
    await answer(`Als ${as} laden`);
    expect(texts()).toMatchObject({ 'main.py': 'mine = 1\n', [as]: 'theirs = 2\n' });
    expect(page.work.open.value.name).toBe(as);
    expect(notice()).toBe(`main.py gab es schon. Die geladene Datei heisst ${as}.`);
  });

  it('takes the place of the other, whose work can be had back', async () => {
    await asked();
    await answer('Ersetzen');
    expect(texts()).toEqual({ 'main.py': 'theirs = 2\n' });
    expect(notice()).toBe('main.py ist ersetzt. Das frühere Programm liegt unter «Meine Arbeiten».');
    expect(kept()).toHaveLength(1);
    page.notices.current.value?.action?.run();
    await nextTick();
    expect(texts()).toEqual({ 'main.py': 'mine = 1\n' });
  });

  it('comes back with what it ran on', async () => {
    page.settings.change({ device: 'calliope-mini-3' });
    await asked();
    await answer('Ersetzen');
    page.settings.change({ device: 'microbit-v2' });
    page.notices.current.value?.action?.run();
    expect(page.settings.current.value.device).toBe('calliope-mini-3');
  });

  it('is asked about one after the other where there are several', async () => {
    mountOn(page, AppDialog);
    page.work.setText('main.py', 'mine = 1\n');
    page.work.create('turn.py', 'mine = 1\n');
    take(file('main.py', 'theirs = 2\n'), file('turn.py', 'theirs = 2\n'));
    await vi.waitFor(() => expect(dialog()).toContain('main.py gibt es schon'));
    await answer('Abbrechen');
    await vi.waitFor(() => expect(dialog()).toContain('turn.py gibt es schon'));
    await answer('Ersetzen');
    expect(texts()).toEqual({ 'main.py': 'mine = 1\n', 'turn.py': 'theirs = 2\n' });
  });
});

describe('a project or a course that is taken in', () => {
  const project = (text: string) => projectToText({ files: [{ name: 'main.py', text }], scene: course, course: null });

  it('opens as a whole; the work before is put aside', async () => {
    page.work.setText('main.py', 'mine = 1\n');
    const words = await told(() => take(file('lesson.parcours.json', project('theirs = 2\n'))));
    expect(words).toBe('«lesson – Neuland» ist geöffnet. Deine Arbeit ist aufbewahrt.');
    expect(texts()).toEqual({ 'main.py': 'theirs = 2\n' });
    expect(page.work.scene.value).toEqual(course);
    page.notices.current.value?.action?.run();
    expect(texts()).toEqual({ 'main.py': 'mine = 1\n' });
  });

  it('keeps nothing where nothing of the pupil’s own was there', async () => {
    const words = await told(() => take(file('lesson.json', project('theirs = 2\n'))));
    expect(words).toBe('«lesson – Neuland» ist geöffnet.');
    expect(kept()).toEqual([]);
  });

  it('ends the run that goes on', async () => {
    await startRun(page);
    await told(() => take(file('lesson.json', project('theirs = 2\n'))));
    await vi.waitFor(() => expect(page.run.phase.value).toBe('ready'));
  });

  it('brings its device along', async () => {
    const settings = { device: 'calliope-mini-3', firmware: '', robot: 'none', robotOptions: {}, reality: 0, seed: 1, arenaSenses: false }; // prettier-ignore
    const text = projectToText({ files: [{ name: 'main.py', text: '' }], scene: course, course: null, settings });
    await told(() => take(file('lesson.json', text)));
    expect(page.settings.current.value).toMatchObject({ device: 'calliope-mini-3', robot: 'none', showArena: false });
  });

  it('is only a course: the program stays', async () => {
    page.work.setText('main.py', 'mine = 1\n');
    await told(() => take(file('course.json', serializeScene(course))));
    expect(texts()).toEqual({ 'main.py': 'mine = 1\n' });
    expect(page.work.scene.value.size).toEqual([700, 500]);
  });

  it('is called like its file where it has no name', async () => {
    const words = await told(() => take(file('Garten.json', serializeScene({ ...course, name: '' }))));
    expect(words).toBe('«Garten.json» ist geöffnet.');
  });

  it('may be a picture: it is offered as the floor, where the arena shows', async () => {
    page.settings.change({ showArena: false });
    take(file('floor.JPG', 'x'));
    await vi.waitFor(() => expect(page.panels.shown.value).toBe('background'));
    expect(page.panels.picture.value).toMatchObject({ name: 'floor.JPG' });
    expect([page.settings.current.value.showArena, page.layout.tab.value]).toEqual([true, 'arena']);
  });

  it('is refused in words when it is a picture and the page shows no arena', async () => {
    page.host.parts.value = ['bar', 'code'];
    expect(await told(() => take(file('d.PNG', 'x')))).toMatch(/^d\.PNG ist ein Bild\. .* keine Arena\.$/);
  });

  it.each([
    [
      'no JSON',
      'a.json',
      '{ "format": ',
      /^a\.json: Die Datei ist beschädigt oder nicht ganz heruntergeladen \(Zeile 1, Spalte \d+\)\.$/,
    ],
    ['JSON of something else', 'b.json', '{ "hello": 1 }', /^b\.json: Das ist weder ein Projekt noch ein Parcours\.$/],
    ['no text', 'c.json', new Uint8Array([0xff, 0]), /^c\.json lässt sich nicht lesen\.$/],
    ['of another kind', 'd.pdf', 'x', /^d\.pdf kann hier nicht geöffnet werden\. Es gehen Programme/],
    ['a project without a program', 'e.json', () => project('x').replace('main.py', 'other.py'), /^e\.json: .*main\.py heissen\.$/], // prettier-ignore
    ['a course larger than an arena can be', 'f.json', () => serializeScene(course).replace(/700/g, '70000000'), /^f\.json: .*70000000 liegt nicht zwischen/], // prettier-ignore
  ])('is refused in words when it is %s: nothing changes', async (_why, name, content, words) => {
    const before = page.work.work.value;
    expect(await told(() => take(file(name, typeof content === 'function' ? content() : content)))).toMatch(words);
    expect(page.notices.current.value?.kind).toBe('error');
    expect(page.work.work.value).toBe(before);
  });

  it('is refused before it is read when it is larger than 16 MB', async () => {
    const huge = file('huge.json', '{}');
    Object.defineProperty(huge, 'size', { value: 17 * 1024 * 1024 });
    const read = vi.spyOn(huge, 'arrayBuffer');
    expect(await told(() => take(huge))).toBe('huge.json ist zu gross: 17 MB, erlaubt sind 16 MB.');
    expect(read).not.toHaveBeenCalled();
  });
});

describe('several projects that come together', () => {
  const project = (text: string) => projectToText({ files: [{ name: 'main.py', text }], scene: course, course: null });
  const handedIn = (...names: readonly string[]) =>
    names.map((name) => file(`${name}.parcours.json`, project(`${name} = 1\n`)));
  const saysLast = (part: string) => vi.waitFor(() => expect(notice()).toContain(part), { timeout: 20_000 });

  it('leave the last one open and keep the others, each under the name of its file', async () => {
    page.work.setText('main.py', 'mine = 1\n');
    take(...handedIn('Anna', 'Beat', 'Carla'));
    await saysLast('«Carla – Neuland» ist offen. Die übrigen Dateien (2) liegen unter «Meine Arbeiten».');
    expect(texts()).toEqual({ 'main.py': 'Carla = 1\n' });
    expect(kept().slice(0, 2)).toEqual(['Beat – Neuland', 'Anna – Neuland']);
    expect(kept()).toHaveLength(3);
  });

  it('are kept even where they hold nothing but what we brought', async () => {
    take(file('Anna.json', projectToText(projectOf(firstCourse!, 'de'))), ...handedIn('Beat'));
    await saysLast('«Beat – Neuland» ist offen.');
    expect(kept()).toEqual([`Anna – ${courseName(firstCourse!.scene, firstCourse!.id)}`]);
  });

  it('are all kept even where they say the same', async () => {
    const found = projectToText(page.work.work.value.project);
    take(file('Anna.json', found), file('Beat.json', found), file('Carla (1).json', found));
    await saysLast('«Carla – ');
    expect(kept().map((name) => name.split(' ')[0])).toEqual(['Beat', 'Anna']);
  });

  it('say which one of them could not be opened', async () => {
    take(...handedIn('Anna'), file('Beat.json', '{'), ...handedIn('Carla'));
    await saysLast('Beat.json: Die Datei ist beschädigt');
    expect(texts()).toEqual({ 'main.py': 'Carla = 1\n' });
    expect(kept()).toEqual(['Anna – Neuland']);
  });

  it('are not opened where they would push each other out of what is kept', async () => {
    const before = page.work.work.value;
    const words = await told(() => take(...handedIn('A', 'B', 'C', 'D', 'E', 'F')));
    expect(words).toBe('Das sind 6 Dateien. Öffne höchstens 5 auf einmal, damit unter «Meine Arbeiten» keine verloren geht.'); // prettier-ignore
    expect(page.work.work.value).toBe(before);
  });

  it('take a program that comes with them into the last one', async () => {
    take(file('turn.py', 'left = 1\n'), ...handedIn('Anna'));
    await vi.waitFor(() => expect(texts()).toEqual({ 'main.py': 'Anna = 1\n', 'turn.py': 'left = 1\n' }));
  });

  it('come back under their names, and are saved under them', async () => {
    take(...handedIn('Anna', 'Beat'));
    await saysLast('«Beat – Neuland»');
    useCourses(page).restore(page.work.work.value.previous[0]!);
    expect(kept()).toEqual(['Beat – Neuland']);
    const saved = downloads();
    commandsOf(page).save();
    await vi.waitFor(() => expect(saved[0]?.name).toBe('Anna.parcours.json'));
    vi.restoreAllMocks();
  });

  it('lose the name of the file when another course is opened', async () => {
    await told(() => take(...handedIn('Anna')));
    page.work.setScene({ ...course, name: 'Anderes' }, null);
    expect(page.work.work.value.file).toBeUndefined();
  });
});

describe('what is saved', () => {
  /** The downloaded file: name and content. */
  async function download(save: () => void): Promise<readonly [string, string]> {
    const saved = downloads();
    save();
    await vi.waitFor(() => expect(saved).toHaveLength(1));
    vi.restoreAllMocks();
    return [saved[0]?.name ?? '', (await saved[0]?.blob.text()) ?? ''];
  }
  beforeEach(() => {
    page.work.openProject({ files: [{ name: 'main.py', text: 'x = 1\n' }], scene: course, course: null }, null);
  });

  it('comes back as it was from a project, with program, course and device', async () => {
    page.settings.change({ device: 'calliope-mini-3' });
    const [name, text] = await download(() => commandsOf(page).save());
    expect(name).toBe('Neuland.parcours.json');
    expect(notice()).toBe('Neuland.parcours.json ist gespeichert.');
    const before = page.work.work.value.project;
    page.work.setText('main.py', 'other = 2\n');
    page.settings.change({ device: 'microbit-v2' });
    await told(() => take(file(name, text)));
    expect(page.work.work.value.project).toMatchObject({ files: before.files, scene: before.scene });
    expect(page.settings.current.value.device).toBe('calliope-mini-3');
  });

  it('has no program in a course', async () => {
    const [name, text] = await download(() => commandsOf(page).saveScene());
    expect(name).toBe('Neuland.json');
    expect(text).not.toContain('x = 1');
    expect(JSON.parse(text)).toMatchObject({ name: 'Neuland', size: [700, 500] });
  });

  it('is the shown file as a program', async () => {
    page.work.create('turn.py', 'left = 1\n');
    expect(await download(() => commandsOf(page).saveProgram())).toEqual(['turn.py', 'left = 1\n']);
    expect(notice()).toBe('turn.py ist gespeichert.');
  });

  it('has a name that every file system takes', async () => {
    page.work.setScene({ ...course, name: '..a/b: "c"? ' }, null);
    const [name] = await download(() => commandsOf(page).saveScene());
    expect(name).toBe('ab c.json');
  });
});
