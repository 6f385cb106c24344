// @vitest-environment happy-dom
import { flushPromises } from '@vue/test-utils';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { effectScope, nextTick } from 'vue';

import type { SimulatorEvent } from '#embed/simulator';
import { defaultScene } from '#scene/scene';

import { noHost } from '../session/visit/host-view';
import { courses } from '#catalogue/courses';
import { firstCourse } from '../session/work/catalogue/first-course';
import { nothingKept, openedFrom } from '../session/work/model/keep-work';
import { workToText } from '../session/work/storage/history';
import type { TabStorage } from '../session/work/storage/tab-storage';
import { setWindow } from './testing/mount-on';
import { downloads } from './testing/downloads';
import { createPage, createParts, type TestPage } from './testing/page';
import { inputsOf, show, startRun } from './testing/run';

const course = (id: string) => courses.find((one) => one.id === id)!;
const finished = { kind: 'finished', exception: null, timeUs: 1000 } as const;

/** A page whose run is under way. */
async function running(): Promise<TestPage> {
  const page = createPage();
  await startRun(page);
  expect(page.run.phase.value).toBe('running');
  return page;
}

describe('a first visit', () => {
  it('finds the first course with its program in the language of the page, and nothing to bring back', () => {
    const page = createPage();
    const { project, previous } = page.work.work.value;
    expect(project.course).toBe(firstCourse?.id);
    expect(project.files).toHaveLength(1);
    expect(Object.values(firstCourse?.program ?? {})).toContain(project.files[0]?.text);
    expect(previous).toEqual([]);
  });

  it('finds a page at rest, whose first press of Run is the first thing that the worker hears', async () => {
    const page = createPage();
    expect(page.run.phase.value).toBe('ready');
    expect(page.sent).toEqual([]);
    await page.run.start();
    expect(page.sent.map(({ type }) => type)).toEqual(['prepare', 'run']);
  });
});

describe('the console', () => {
  const closedLine = course('closed-line');
  async function withOutput(): Promise<TestPage> {
    const page = await running();
    page.console.write('of the first course');
    return page;
  }

  it('is empty when another course has been opened, also of the end of its last run', async () => {
    const page = await withOutput();
    page.work.setScene({ ...closedLine.scene, name: 'Other' }, null);
    await flushPromises();
    expect(page.run.phase.value).toBe('ready');
    expect(page.console.toText()).toBe('');
  });

  it('keeps what a run prints that began right after the opening', async () => {
    const page = await withOutput();
    page.work.setScene({ ...closedLine.scene, name: 'Other' }, null);
    const started = page.run.start();
    page.console.write('of the second course');
    await started;
    await flushPromises();
    expect(page.console.toText()).toContain('of the second course');
  });

  it('keeps everything when only the program changes', async () => {
    const page = await withOutput();
    page.work.setText('main.py', 'x = 1');
    await flushPromises();
    expect(page.console.toText()).toContain('of the first course');
  });
});

describe('what a tab has kept', () => {
  const scopes: { stop(): void }[] = [];
  afterEach(() => {
    for (const scope of scopes.splice(0)) scope.stop();
    vi.useRealTimers();
  });
  async function pageWith(storage: TabStorage) {
    const scope = effectScope(true);
    scopes.push(scope);
    const opened = await openedFrom(storage);
    return scope.run(() => createParts(opened, noHost))!;
  }
  const stored = workToText({
    project: { files: [{ name: 'main.py', text: 'mine = 1\n' }], scene: defaultScene(), course: null },
    open: 'main.py',
    previous: [],
  });

  it('is opened again', async () => {
    const page = await pageWith({ load: () => stored, save: () => true });
    expect(page.work.open.value.text).toBe('mine = 1\n');
    expect(page.work.work.value.project.course).toBeNull();
  });

  it('is forgotten where it cannot be read: the page opens as on a first visit', async () => {
    const page = await pageWith({ load: () => stored.slice(0, 40), save: () => true });
    expect(page.work.work.value.project.course).toBe(firstCourse?.id);
  });

  it('is saved soon after a change, and can be opened', async () => {
    vi.useFakeTimers();
    const saved: string[] = [];
    const page = await pageWith({ load: () => null, save: (text) => saved.push(text) > 0 });
    page.work.setText('main.py', 'new = 2\n');
    await nextTick();
    await vi.advanceTimersByTimeAsync(1000);
    const again = await pageWith({ load: () => saved.at(-1) ?? null, save: () => true });
    expect(again.work.open.value.text).toBe('new = 2\n');
  });

  it('has no room any more: that is said, with a button that saves it as a file', async () => {
    vi.useFakeTimers();
    const page = await pageWith({ ...nothingKept.storage, save: () => false });
    page.work.setText('main.py', 'new = 2\n');
    await nextTick();
    await vi.advanceTimersByTimeAsync(1000);
    vi.useRealTimers();
    await vi.waitFor(() => expect(page.notices.current.value?.key).toBe('files.storageFull'), 20_000);
    const saved = downloads();
    page.notices.current.value?.action?.run();
    await vi.waitFor(() => expect(saved.map(({ name }) => name)).toEqual([expect.stringMatching(/\.parcours\.json$/)]));
    expect(await saved[0]?.blob.text()).toContain('new = 2');
    vi.restoreAllMocks();
  });
});

describe('what a run is given', () => {
  const setupOf = (page: TestPage) => page.sent.flatMap((message) => (message.type === 'run' ? [message] : [])).at(-1);

  it('is the program, the course and the device as they are on the page', async () => {
    const page = createPage();
    page.work.setText('main.py', 'x = 1\n');
    page.work.create('turn.py', 'left = 1\n');
    page.settings.change({ device: 'calliope-mini-3', robot: 'callibot', speed: 4, seed: 7, reality: 0.5 });
    await nextTick();
    await page.run.start();
    const sent = setupOf(page);
    expect(sent?.setup).toMatchObject({
      ...{ scene: page.work.scene.value, seed: 7, reality: 0.5 },
      devices: [
        {
          files: { 'main.py': 'x = 1\n', 'turn.py': 'left = 1\n' },
          ...{ board: 'calliope-mini-3', robot: 'callibot' },
        },
      ],
    });
    expect([sent?.speed, sent?.paused]).toEqual([4, false]);
  });

  it('is what stands there at the start: a program that is changed meanwhile waits for the next', async () => {
    const page = await running();
    page.work.setText('main.py', 'changed = 1\n');
    await nextTick();
    expect(page.sent.filter(({ type }) => type === 'run')).toHaveLength(1);
    expect(page.run.phase.value).toBe('running');
    await page.run.start();
    expect(setupOf(page)?.setup.devices[0].files['main.py']).toBe('changed = 1\n');
  });
});

describe('a run', () => {
  beforeEach(() => setWindow(1400));

  it('follows the speed that is chosen', async () => {
    const page = await running();
    page.settings.change({ speed: 0.25 });
    await nextTick();
    expect(page.sent.at(-1)).toEqual({ type: 'speed', speed: 0.25 });
  });

  it.each([
    ['the microcomputer', { device: 'calliope-mini-3' }],
    ['the robot', { robot: 'callibot' }],
    ['how worn it is', { reality: 0.5 }],
  ])('ends at once when %s is another, and everything is back at the start', async (_what, wish) => {
    const page = await running();
    page.settings.change(wish);
    expect(page.run.phase.value).toBe('stopping');
    await flushPromises();
    expect(page.run.phase.value).toBe('ready');
    expect(page.run.snapshot.value).toBeNull();
  });

  it.each([
    ['the language', { language: 'fr' }],
    ['light and dark', { theme: 'dark' }],
    ['what is in sight', { showBoard: false }],
    ['the check of the device', { deviceCheck: false }],
  ] as const)('goes on when %s is changed', async (_what, wish) => {
    const page = await running();
    page.settings.change(wish);
    await flushPromises();
    expect(page.run.phase.value).toBe('running');
  });

  it('ends when another course is opened', async () => {
    const page = await running();
    page.work.setScene(course('slalom').scene, 'slalom');
    await flushPromises();
    expect(page.run.phase.value).toBe('ready');
  });

  it('goes on when its course is edited, and hears of it', async () => {
    const page = await running();
    const before = page.work.scene.value;
    const block = { type: 'block', id: 'new-block', at: [100, 100], size: [50, 50], angle: 0 } as const;
    page.work.edit({ type: 'add', objects: [block] });
    await flushPromises();
    expect(page.run.phase.value).toBe('running');
    expect(page.work.scene.value.objects.length).toBe(before.objects.length + 1);
    expect(inputsOf(page).length).toBeGreaterThan(0);
  });

  it('is told when its board feels the arena no more', async () => {
    const page = await running();
    page.settings.change({ arenaSenses: false });
    await nextTick();
    expect(inputsOf(page)).toContainEqual({ type: 'arena-senses', on: false });
  });

  it('is numbered in the console, with what the program printed below', async () => {
    const page = await running();
    page.say({ type: 'console', output: [{ device: 0, text: 'eins\n', timeUs: 0 }] });
    await page.run.start();
    page.say({ type: 'started' });
    page.say({ type: 'console', output: [{ device: 0, text: 'zwei\n', timeUs: 0 }] });
    page.console.toText();
    const lines = page.console.entries.value.map((entry) =>
      entry.kind === 'run' ? entry.number : entry.kind === 'text' ? entry.text.trim() : entry.kind,
    );
    expect(lines).toEqual([1, 'eins', 2, 'zwei']);
  });

  it('tells the worker that its output was taken: without it the program would wait for ever', async () => {
    const page = await running();
    page.say({ type: 'console', output: [{ device: 0, text: 'eins\n', timeUs: 0 }] });
    expect(page.sent.at(-1)).toEqual({ type: 'console-taken' });
  });

  it('begins with an empty data log and no radio of the one before', async () => {
    const page = await running();
    const row = { type: 'row', headings: ['x'], values: ['1'], timeUs: 0 } as const;
    page.say({ type: 'events', events: { log: [row], radio: [], radioDropped: 0, sound: [] }, device: 0 });
    expect(page.dataLog.table.value.rows).toHaveLength(1);
    await page.run.start();
    expect(page.dataLog.table.value.rows).toHaveLength(0);
  });

  it('removes the mark of the error when it begins anew on the device', async () => {
    const page = await running();
    page.jump.wrong.value = { file: 'main.py', line: 1, device: 0 };
    page.notices.show({ kind: 'error', key: 'notice.firmware' });
    page.say({ type: 'program-restarted', device: 0 });
    expect(page.jump.wrong.value).toBeNull();
    expect(page.notices.current.value).toBeNull();
  });
});

describe('a run that cannot begin', () => {
  it('says that the connection is to be checked if the VM is missing, and can be tried again', async () => {
    const scope = effectScope(true);
    let isOnline = false;
    const firmware = () =>
      isOnline ? Promise.resolve({} as WebAssembly.Module) : Promise.reject(new Error('offline'));
    const createWorker = () => ({
      ...{ onmessage: null, onerror: null },
      ...{ postMessage: () => undefined, terminate: () => undefined },
    });
    const page = scope.run(() => createParts(nothingKept, noHost, { createWorker, firmware }))!;
    const told: SimulatorEvent[] = [];
    page.host.listen((event) => told.push(event));
    await page.run.start();
    await flushPromises();
    expect(page.run.phase.value).toBe('failed');
    expect(page.notices.current.value).toMatchObject({ kind: 'error', key: 'notice.firmware' });
    expect(told.map(({ type }) => type)).toEqual(['started', 'failed']);
    isOnline = true;
    await page.run.start();
    expect(page.run.phase.value).toBe('starting');
    scope.stop();
  });
});

describe('what the page around hears of a run', () => {
  async function heard() {
    const page = createPage();
    const events: SimulatorEvent[] = [];
    page.host.listen((event) => events.push(event));
    await startRun(page);
    return { page, events, types: () => events.map(({ type }) => type) };
  }

  it('is its beginning, its output and its end with the verdict', async () => {
    const { page, events } = await heard();
    page.say({ type: 'console', output: [{ device: 0, text: 'Hallo\r\n', timeUs: 0 }] });
    const verdict = { kind: 'passed', timeUs: 900 } as never;
    await show(page, { verdict });
    page.say({ type: 'program-ended', ended: finished, device: 0 });
    expect(events).toEqual([
      { type: 'started' },
      { type: 'output', text: 'Hallo\r\n' },
      { type: 'program-ended', ended: finished, verdict },
    ]);
  });

  it('is what the pupil does to the board, and nothing of the arena', async () => {
    const { page, events } = await heard();
    page.run.input({ type: 'button', button: 'a', down: true });
    page.run.input({ type: 'arena-senses', on: true });
    expect(events.slice(1)).toEqual([{ type: 'sensed', action: { type: 'button', button: 'a', down: true } }]);
  });

  it('is what was sent by radio and what was logged, each only when there is something', async () => {
    const { page, types } = await heard();
    page.say({ type: 'events', events: { log: [], radio: [], radioDropped: 0, sound: [] }, device: 0 });
    expect(types()).toEqual(['started']);
    const row = { type: 'row', headings: ['x'], values: ['1'], timeUs: 0 } as const;
    page.say({ type: 'events', events: { log: [row], radio: [], radioDropped: 0, sound: [] }, device: 0 });
    expect(types()).toEqual(['started', 'log']);
  });

  it('is what it did not take, that it began anew, or that it failed', async () => {
    const { page, events } = await heard();
    page.say({ type: 'refused', message: 'No such block.' });
    page.say({ type: 'program-restarted', device: 0 });
    page.say({ type: 'failed', message: 'Too many bodies.' });
    expect(events.slice(1)).toEqual([
      { type: 'refused', message: 'No such block.' },
      { type: 'program-restarted' },
      { type: 'failed', message: 'Too many bodies.' },
    ]);
  });

  it('ends when it does not listen any more', async () => {
    const page = createPage();
    const events: SimulatorEvent[] = [];
    const stop = page.host.listen((event) => events.push(event));
    stop();
    await startRun(page);
    expect(events).toEqual([]);
  });
});

describe('what a host holds for a visit', () => {
  it('is so on the page, and none of it is kept', async () => {
    const page = createPage({ settings: { speed: 2, theme: 'dark', device: 'calliope-mini-3' } });
    expect(page.settings.current.value).toMatchObject({ speed: 2, theme: 'dark', device: 'calliope-mini-3' });
    expect(page.settings.own.value).toMatchObject({ speed: 1, theme: 'system', device: 'auto' });
    page.settings.change({ muted: true });
    await nextTick();
    const kept = JSON.parse(localStorage.getItem('parcours.settings') ?? '{}') as Record<string, unknown>;
    expect(kept).toMatchObject({ muted: true, speed: 1, theme: 'system' });
  });

  it('gives way to what the pupil chooses', async () => {
    const page = createPage({ settings: { speed: 2 } });
    page.settings.change({ speed: 8 });
    await nextTick();
    expect([page.settings.current.value.speed, page.settings.own.value.speed]).toEqual([8, 8]);
  });

  it('shows only what it names', () => {
    setWindow(1400);
    const page = createPage({ settings: { parts: ['bar', 'arena'] } });
    expect(page.layout.isShown.value).toEqual({ code: false, board: false, arena: true, console: false });
  });
});
