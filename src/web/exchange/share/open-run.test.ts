// @vitest-environment happy-dom
import { readFileSync } from 'node:fs';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { effectScope, nextTick, watch, type EffectScope } from 'vue';

import { withoutSecrets } from '#check/task/write-task';
import { parseTape, setupAsKept, tapeToText } from '#tape/file';
import { PHYSICS } from '#simulation/physics-version';
import { version } from '../../../../package.json';
import { createParts, type AllParts } from '../../app/testing/page';
import { downloads } from '../../app/testing/downloads';
import { workerHere } from '../../app/testing/worker-here';
import { linksToRun, saveRun } from '../../pupil/look-back/save-run';
import { setLanguage, t } from '../../kit/i18n';
import { repeatShown } from '../../session/run/repeat-shown';
import { noHost } from '../../session/visit/host-view';
import { firstCourse } from '../../session/work/catalogue/first-course';
import { nothingKept } from '../../session/work/model/keep-work';
import { openAddress } from './open-address';
import { commandsOf } from './use-commands';

const firmware = WebAssembly.compile(readFileSync('.cache/vm/vm.wasm'));
const PROGRAM = 'from mbrobot import *\nforward()\nfor i in range(8):\n    print(i)\n    delay(100)\nstop()\n';

let page: AllParts;
let scope: EffectScope;
async function newPage(): Promise<void> {
  scope = effectScope(true);
  page = scope.run(() => createParts(nothingKept, noHost, { createWorker: workerHere, firmware: () => firmware }))!;
  page.settings.change({ language: 'en' });
  await setLanguage('en');
}
beforeEach(async () => {
  vi.stubGlobal('requestAnimationFrame', (draw: () => void) => setTimeout(draw, 5));
  vi.stubGlobal('cancelAnimationFrame', clearTimeout);
  localStorage.clear();
  await newPage();
});
afterEach(() => {
  scope.stop();
  vi.unstubAllGlobals();
  vi.restoreAllMocks();
});

const soon = <T>(look: () => T): Promise<T> => vi.waitFor(look, { timeout: 20_000, interval: 10 });
function said(): string {
  const { key, values } = page.notices.current.value ?? {};
  return key === undefined ? '' : t(key, values);
}
/** Runs the program for a while, looks back, and saves the run. */
async function saved(program = PROGRAM, act: () => void | Promise<void> = () => undefined): Promise<string> {
  page.work.setText('main.py', program);
  await page.run.start();
  await soon(() => expect(page.run.nowUs.value).toBeGreaterThan(300_000));
  await act();
  page.run.look.back();
  const files = downloads();
  await saveRun(page);
  expect(files.map(({ name }) => name)).toEqual([expect.stringMatching(/\.run\.json$/)]);
  return files[0]!.blob.text();
}
const open = (text: string): void => commandsOf(page).take([new File([text], 'mine.run.json')]);
const programNow = (): string | undefined => page.work.find('main.py')?.text;

describe('a run that is taken along', () => {
  it('is opened with its project, run again, and looked at from its beginning; then it can go on', async () => {
    const text = await saved();
    await page.run.reset();
    page.work.setText('main.py', 'print("another")\n');
    open(text);
    await soon(() => expect(page.run.recording.value.canRepeat).toBe(true));
    expect(programNow()).toBe(PROGRAM);
    expect([page.run.nowUs.value, page.run.phase.value]).toEqual([0, 'paused']);
    const read = parseTape(text);
    expect(page.run.present.value?.timeUs).toBe('tape' in read && read.tape.result.simulatedUs);
    expect(page.task.ready.value?.id).toBe('forward-maqueen-lite');
    expect(said()).toBe('mine.run.json: the run is the same as when it was saved. You see its beginning.');
    expect(page.notices.current.value?.action?.key).toBe('course.restore');
  });

  it.each([
    ['ends with its program', 'print(1)\n', { untilUs: 60_000_000, untilProgramEnds: true }, []],
    [
      'goes on after a Ctrl-C that is the last that was done to it',
      'while True:\n    pass\n',
      { untilUs: 600_000, untilProgramEnds: false },
      [{ timeUs: 300_000, action: { type: 'interrupt' } }] as const,
    ],
  ])('is the same file when it is opened and saved again: one that %s', async (_, main, ends, inputs) => {
    const read = parseTape(await saved());
    if (!('tape' in read)) throw new Error(read.problem);
    const [device] = read.tape.setup.devices;
    const setup = setupAsKept({ ...read.tape.setup, devices: [{ ...device, files: { 'main.py': main } }], inputs });
    const repeated = await repeatShown(page, { setup, ...ends }, String);
    const text = tapeToText({ madeBy: version, physics: PHYSICS, setup, ...ends, result: repeated!.result });
    await page.run.reset();
    open(text);
    await soon(() => expect(said()).toContain('the same'));
    await soon(() => expect(page.run.recording.value.canRepeat).toBe(true));
    const files = downloads();
    await saveRun(page);
    expect(await files[0]!.blob.text()).toBe(text);
  });

  it('is the same with presses, words, the hand and a changed course', async () => {
    const asks = 'print(input("Name? "))\n' + PROGRAM;
    const text = await saved(asks, async () => {
      const { run, work } = page;
      run.input({ type: 'serial', text: 'Ada\r' });
      run.input({ type: 'button', button: 'a', down: true });
      work.edit({ type: 'course', changes: { size: [900, 700] } });
      run.input({ type: 'place', pose: { xMm: 200, yMm: 200, headingDeg: 30 } });
      await soon(() => expect(run.nowUs.value).toBeGreaterThan(900_000));
    });
    const read = parseTape(text);
    const inputs = 'tape' in read ? (read.tape.setup.inputs ?? []) : [];
    expect(inputs.map(({ action }) => action.type)).toEqual(['arena-senses', 'serial', 'button', 'edit', 'place']);
    await page.run.reset();
    open(text);
    await soon(() => expect(said()).toContain('the same'));
    expect(page.work.scene.value.size).toEqual([900, 700]);
  });

  it('leaves its task open with its locks if that was handed out, and reports what it brings', async () => {
    const project = { ...page.work.work.value.project, task: { version: 1, id: 'A', locks: { hand: true } } };
    page.work.openProject(withoutSecrets(project), null);
    await soon(() => expect(page.work.locks.task.value).not.toBeNull());
    page.work.setText('main.py', PROGRAM, true);
    const text = await saved();
    await page.run.reset();
    const { task } = page.work.work.value.project;
    open(text);
    await soon(() => expect(said()).toContain('the same'));
    const opened = page.work.work.value.project;
    expect([opened.task, page.work.locks.task.value?.locks.hand, opened.handIn]).toEqual([task, true, undefined]);
    page.work.setText('main.py', 'print("mine")\n', true);
    open(text);
    await soon(() => expect(programNow()).toBe(PROGRAM));
    expect(page.work.work.value.project).toMatchObject({ task, handIn: { remarks: ['outside'] } });
    await soon(() => expect(said()).toContain('the same'));
    await page.run.reset(); // nothing is edited while somebody looks back
    page.work.edit({ type: 'course', changes: { size: [900, 700] } });
    open(text);
    await soon(() => expect(page.work.scene.value.size).not.toEqual([900, 700]));
    expect(page.work.work.value.project.task).toBeUndefined();
  });

  it('ends with Stop, without what Stop interrupts', async () => {
    const text = await saved('from mbrobot import *\nforward()\nwhile True:\n    delay(20)\n', () => page.run.stop());
    const read = parseTape(text);
    if ('problem' in read) throw new Error(read.problem);
    expect(read.tape.setup.inputs?.map(({ action }) => action.type)).toEqual(['arena-senses']);
    expect(read.tape.result.devices).toMatchObject([{ ended: null }]);
    expect(read.tape.result.simulatedUs).toBeGreaterThan(300_000);
  });

  it('wins no stars for somebody who looks at it', async () => {
    const isPassed = (): void => expect(page.run.present.value?.verdict?.state).toBe('passed');
    const text = await saved(firstCourse!.solution.en, () => soon(isPassed));
    expect(Object.keys(page.task.stars.all.value)).toEqual(['forward-maqueen-lite']);
    scope.stop();
    localStorage.clear();
    await newPage();
    open(text);
    await soon(() => expect(page.run.recording.value.canRepeat).toBe(true));
    page.run.look.leave();
    await nextTick();
    isPassed();
    expect(page.task.stars.all.value).toEqual({});
  });

  it('goes along in a link, too, and is looked at from its start, or from the moment that was looked at', async () => {
    page.work.setText('main.py', PROGRAM);
    await page.run.start();
    await soon(() => expect(page.run.nowUs.value).toBeGreaterThan(300_000));
    page.run.look.back();
    page.run.look.at(240_000, { ...page.run.present.value!, timeUs: 240_000 });
    const { fromStart = '', fromThere: link = '' } = (await linksToRun(page)) ?? {};
    expect(fromStart).toMatch(/#r=1\.0\.[\w-]+$/);
    expect(link).toMatch(/#r=1\.240\.[\w-]+$/);
    scope.stop();
    await newPage();
    expect(openAddress(page, link)).toBeNull();
    await soon(() => expect(page.run.recording.value.canRepeat).toBe(true));
    expect(page.run.recording.value.asked.value?.timeUs).toBe(240_000);
    expect(said()).toMatch(/^Link: the run is the same as when it was saved. You see it from 00:00.24 on.$/);
    expect(openAddress(page, link.slice(0, -3))).toBe(
      'The link is damaged: a part of it is missing or changed. Copy it again, whole.',
    );
  });

  it('is too long for a link when the program is: then there is a file', async () => {
    let noise = '';
    for (let n = 1; noise.length < 20_000; n = (n * 48271) % 2147483647) noise += n.toString(36);
    page.work.setText('main.py', `${PROGRAM}# ${noise}\n`);
    await page.run.start();
    await soon(() => expect(page.run.nowUs.value).toBeGreaterThan(100_000));
    page.run.look.back();
    expect(await linksToRun(page)).toBeNull();
    expect(said()).toMatch(/^The run is too long for a link \(\d+ characters, 8000 at most\)\. Save it as a file\.$/);
  });

  it('opens also where it was saved, with the run still there', async () => {
    const text = await saved();
    open(text);
    await soon(() => expect(said()).toContain('the same'));
    expect([page.run.nowUs.value, page.run.phase.value]).toEqual([0, expect.stringMatching(/starting|paused/)]);
  });
});

const result = /"traceHash":"[0-9a-f]{64}"/;
const other = `"traceHash":"${'0'.repeat(64)}"`;

describe('a run that was made with another physics of the robots', () => {
  it.each<[string, (text: string) => string, string]>([
    [
      'an older one, by a file that does not say any',
      (text) => text.replace(/ *"physics": .*\n/, ''),
      'an older physics',
    ],
    ['a newer one', (text) => text.replace(/"physics": \d+/, '"physics": 99'), 'a newer physics'],
  ])('is looked at as it comes out here, and says so: %s', async (_which, change, words) => {
    const text = change((await saved()).replace(result, other));
    await page.run.reset();
    open(text);
    await soon(() => expect(said()).toContain(`mine.run.json: the run was made with ${words} of the robots.`));
    await soon(() => expect(page.run.past.value).not.toBeNull());
    expect(page.notices.current.value).toMatchObject({ kind: 'warn' });
  });
});

describe('a run that cannot be shown', () => {
  it.each<[string, (text: string) => string, string]>([
    [
      'it comes out differently',
      (text) => text.replace(result, other),
      'mine.run.json: the run comes out differently than when it was saved.',
    ],
    [
      'it is of another Parcours, and comes out differently',
      (text) => text.replace(result, other).replace(/"madeBy": "[^"]*"/, '"madeBy": "0.0.1"'),
      'mine.run.json: the run is from Parcours 0.0.1 and comes out differently in ',
    ],
    [
      'its program was changed',
      (text) => text.replace('range(8)', 'range(9)'),
      'mine.run.json: the program was changed',
    ],
    [
      'its seed was changed',
      (text) => text.replace('"seed":1', '"seed":2'),
      'mine.run.json: course, settings or inputs were changed',
    ],
    [
      'its file is of a newer version',
      (text) => text.replace('"version": 1,\n  "madeBy"', '"version": 2,\n  "madeBy"'),
      'mine.run.json: the run is from a newer version. Reload the page and open it again. The project in it is open.',
    ],
    [
      'the end of its file is cut off',
      (text) => text.slice(0, text.indexOf('"result"') + 20),
      'mine.run.json is damaged or was cut off. Get the file once more, whole. The project in it is open.',
    ],
  ])('opens its project all the same and says why: %s', async (_why, change, words) => {
    const changed = change(await saved());
    await page.run.reset();
    page.work.setText('main.py', 'print("mine")\n');
    open(changed);
    await soon(() => expect(said()).toContain(words));
    expect(programNow()).toMatch(/^from mbrobot import/);
    expect([page.run.past.value, page.run.phase.value]).toEqual([null, 'ready']);
    expect(page.notices.current.value).toMatchObject({ kind: 'warn', action: { key: 'course.restore' } });
  });

  it('changes nothing where not even its project can be read', async () => {
    const text = await saved();
    await page.run.reset();
    const before = page.work.work.value;
    open(text.slice(0, 300));
    await soon(() => expect(said()).toContain('mine.run.json is damaged or was cut off'));
    expect(said()).not.toContain('project');
    expect(page.work.work.value).toBe(before);
  });

  it('is not shown to somebody who has started the program meanwhile', async () => {
    const text = await saved();
    await page.run.reset();
    open(text);
    // At once when its project is there: to run it again takes a moment.
    await new Promise<void>((resolve) => watch(page.work.work, () => resolve(), { once: true, flush: 'sync' }));
    await page.run.start();
    await soon(() => expect(page.run.ended.value).not.toBeNull());
    expect(page.run.past.value).toBeNull();
    expect(said()).not.toContain('the same');
  });
});
