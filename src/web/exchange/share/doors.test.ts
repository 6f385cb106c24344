// @vitest-environment happy-dom
import { beforeEach, describe, expect, it, vi } from 'vitest';

import { cleanFirmware } from '#hex/clean';
import { makeHex } from '#hex/make';
import { firmwareText } from '#hex/testing/firmware';
import { limits } from '#intake/formats';
import { addresses, samples } from '#intake/testing/samples';
import type { Content } from '#intake/contents';
import { contentOf, listSources } from '#intake/sources';

import { mountOn } from '../../app/testing/mount-on';
import { createPage, type TestPage } from '../../app/testing/page';
import { ClassModel } from '../../teacher/class/model/class-model';
import { offerLink } from '../../teacher/class/task-series';
import TaskChoice from '../../teacher/class/TaskChoice.vue';
import { treeFile } from '../../kit/files/added-files';
import { setLanguage, t } from '../../kit/i18n';
import { HandInReader } from '../../session/run/reading/hand-in-reader';
import { Reader } from '../../session/run/worker/reader';
import { collectFiles, collectLinks, type Collected } from '../../teacher/series/collect';
import { readyScene } from '../../session/work/catalogue/ready-courses';
import { openAddress } from './open-address';
import { commandsOf } from './use-commands';

let page: TestPage;
beforeEach(async () => {
  sessionStorage.clear();
  await setLanguage('en');
  page = createPage();
  page.settings.change({ language: 'en' });
});

const fileOf = (name: string, bytes: Uint8Array): File => new File([bytes.slice()], name);
/** The page's message, without the name of the file. */
const said = (name = ''): string => {
  const notice = page.notices.current.value;
  return notice === null ? '' : t(notice.key, notice.values).replaceAll(name, '').trim();
};
const soon = <T>(look: () => T): Promise<T> => vi.waitFor(look, { timeout: 20_000, interval: 5 });

/** The document that opened on the page, or its message. */
function opened(before: unknown, name = ''): string {
  if (location.hash !== '') return location.hash.slice(0, 12);
  if (page.dataLog.device.value !== null) return 'log';
  if (page.panels.shown.value === 'background') return 'floor';
  const { project } = page.work.work.value;
  const files = project.files.map((file) => `${file.name} ${file.text.trim()}`).join();
  return page.work.work.value === before ? said(name) : `${project.scene.name}: ${files}`;
}

/**
 * The effect of each file at each door where files are taken: the page, its class, the series that is made there, the
 * class's task.
 */
const files: Readonly<Record<string, readonly [page: string, class_: string, maker: string, task: string]>> = {
  'anna.py': ['anna.py forward()', 'anna forward()', 'refused', 'is not a task'],
  'anna.hex': ['main.py forward(),way.py x = 1', 'anna forward()', 'refused', 'is not a task'],
  'anna.parcours.json': ['Hall: main.py forward()', 'anna forward()', 'task', 'Hall'],
  'without-ending': ['Hall: main.py forward()', 'without-ending forward()', 'refused', 'Hall'],
  'hall.json': ['Hall: main.py ', 'hall course', 'task', 'Hall'],
  'mylevel.json': [': main.py ', 'mylevel course', 'task', ''],
  'week.json': ['#series/woch', 'series', 'series', 'series'],
  'anna.run.json': ['Hall: main.py forward()', 'anna forward()', 'refused', 'is not a task'],
  'cup.json': ['#tournament', 'cup tournament', 'refused', 'this is a tournament'],
  'class.zip': ['cannot be opened here', 'Anna forward(), Ben ', 'nothing', 'is not a task'],
  'week.zip': ['#series/woch', 'series', 'series', 'series'],
  'links.txt': ['cannot be opened here', 'Anna forward()', 'refused', 'is not a task'],
  'links.csv': ['cannot be opened here', 'Anna forward()', 'refused', 'is not a task'],
  'links.eml': ['cannot be opened here', 'Anna forward()', 'refused', 'is not a task'],
  'attached.eml': ['cannot be opened here', 'Anna forward()', 'refused', 'is not a task'],
  'walk.csv': ['log', 'walk no-link', 'refused', 'is not a task'],
  'floor.png': ['floor', 'floor kind', 'refused', 'is not a task'],
  'broken.json': ['damaged or was not', 'broken project', 'refused', 'is not a task'],
  'broken.py': ['is not text', 'broken not-text', 'refused', 'is not a task'],
  'broken.zip': ['cannot be opened here', 'broken.zip zip', 'refused', 'is not a task'],
  'blocks.hex': ['program from MakeCode', 'blocks hex-makecode', 'refused', 'is not a task'],
  'film.mp4': ['cannot be opened here', 'film kind', 'refused', 'is not a task'],
};

const programOf = (content: Content): string =>
  'handIn' in content ? (content.handIn.project.files[0]?.text.trim() ?? '') : content.problem.code;

describe.each(samples)('$name', ({ name, bytes }) => {
  const [onPage, inClass, inMaker, asTask] = files[name] ?? ['', '', '', ''];

  it('is opened by the page, dropped or chosen, as what it is', async () => {
    location.hash = '';
    const before = page.work.work.value;
    commandsOf(page).take([fileOf(name, bytes)]);
    await soon(() => expect(opened(before, name)).toContain(onPage));
  });

  it('is a hand-in for a class, dropped, chosen or pasted, or a series', async () => {
    const reader = new HandInReader(() => ({}), {
      start: (heard) => {
        const here = new Reader();
        return { send: (message) => void here.answer(message).then(heard), stop: () => undefined };
      },
      every: () => () => undefined,
    });
    const { series, sources } = await reader.open([{ path: name, file: fileOf(name, bytes) }]);
    const contents = await Promise.all(sources.map((source) => contentOf(source)));
    const found = sources.map((source, place) => `${source.name} ${programOf(contents[place]!)}`);
    expect(series === null ? found.join(', ') : series.kind).toBe(inClass);
  });

  it('adds its tasks to a series that is made', async () => {
    const { tasks, series, refusals } = await collectFiles([{ path: name, file: fileOf(name, bytes) }]);
    const what = series.length > 0 ? 'series' : tasks.length > 0 ? 'task' : refusals.length > 0 ? 'refused' : 'nothing';
    expect(what).toBe(inMaker);
  });

  it('is the task of a class, chosen', async () => {
    const model = new ClassModel({
      starter: () => Promise.reject(new Error()),
      every: () => () => undefined,
      lanes: 1,
      language: () => 'de',
    });
    const shown = mountOn(page, TaskChoice, { model });
    const picker = shown.get<HTMLInputElement>('input[type="file"]').element;
    Object.defineProperty(picker, 'files', { value: [fileOf(name, bytes)], configurable: true });
    picker.dispatchEvent(new Event('change'));
    await soon(() => {
      const refusal = shown.find('[role="alert"]');
      const isSeries = model.brought.value.chosen !== null;
      expect(isSeries ? 'series' : refusal.exists() ? refusal.text() : model.task.value?.name).toContain(asTask);
    });
  });
});

/** The effect of each address at each door where addresses are taken. */
const links: Readonly<Record<string, readonly [page: string, class_: string, maker: string]>> = {
  program: ['main.py forward()', 'forward()', 'refused'],
  course: [': main.py ', 'nothing', 'refused'],
  project: ['Hall: main.py forward()', 'forward()', 'task'],
  recording: ['Hall: main.py forward()', 'forward()', 'refused'],
  'series-link': ['#s=1.', 'series', 'series'],
  'series-place': ['#series=http', 'nothing', 'refused'],
  ready: ['Geschlossene Linie: main.py', 'nothing', 'task'],
  unreadable: ['not a link to a project', 'nothing', 'refused'],
};

describe.each(Object.entries(addresses))('an address: %s', (kind, address) => {
  const [onPage, inClass, inMaker] = links[kind] ?? ['', '', ''];

  it('is opened by the page', () => {
    location.hash = '';
    const before = page.work.work.value;
    expect(openAddress(page, address) ?? opened(before)).toContain(onPage);
  });

  it('is a hand-in for a class, typed or pasted, or a series', async () => {
    const model = new ClassModel({
      starter: () => Promise.reject(new Error()),
      every: () => () => undefined,
      lanes: 1,
      language: () => 'de',
    });
    const [source] = listSources(address, readyScene);
    const what = offerLink(model, address) ? 'series' : 'nothing';
    expect(source === undefined ? what : programOf(await contentOf(source))).toBe(inClass);
  });

  it('adds its tasks to a series that is made', () => {
    const { tasks, series }: Collected = collectLinks(address);
    expect(series.length > 0 ? 'series' : tasks.length > 0 ? 'task' : 'refused').toBe(inMaker);
  });
});

it('a tournament that is pasted as text leads to its page', () => {
  location.hash = '';
  const cup = samples.find(({ kind }) => kind === 'tournament')!;
  expect(openAddress(page, new TextDecoder().decode(cup.bytes))).toBeNull();
  expect(location.hash).toBe('#tournament');
});

it('a zip of a class is read once, also where it is looked through for a series', async () => {
  const zip = samples.find(({ name }) => name === 'class.zip')!;
  const file = fileOf(zip.name, zip.bytes);
  const read = vi.spyOn(file, 'arrayBuffer');
  const reader = new Reader();
  await reader.answer({ type: 'read-open', batch: 1, added: [{ path: zip.name, file }], scenes: {} });
  for (const place of [0, 1]) await reader.answer({ type: 'read', batch: 1, place });
  expect(read).toHaveBeenCalledTimes(1);
  expect(await treeFile({ path: zip.name, file }).read(limits.zip)).toHaveProperty('bytes');
});

it('a hex that was opened is named with the course in which it is, not twice', async () => {
  const cleaned = cleanFirmware(firmwareText('microbit-v2'));
  const made = makeHex('firmwares' in cleaned ? cleaned.firmwares : [], [{ name: 'main.py', text: 'x = 1\n' }]);
  const text = made.kind === 'hex' ? made.text : '';
  commandsOf(page).take([new File([text], 'anna.hex')]);
  await soon(() => expect(said()).toContain('anna – '));
  expect(said()).not.toContain('anna.hex');
});
