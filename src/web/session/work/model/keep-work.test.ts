// @vitest-environment happy-dom
import { effectScope, nextTick, type EffectScope } from 'vue';
import { afterEach, beforeAll, beforeEach, describe, expect, it, vi } from 'vitest';

import { defaultScene, type Scene } from '#scene/scene';
import { serializeScene } from '#scene/serialize';

import { savedMsOf } from '../storage/history';
import { stubDatabase } from '../storage/testing/memory-database';
import { copyOnDisk } from '../storage/disk-copy';
import { copiesOf } from '../storage/tab-storage';
import { keepWork, openedFrom, openTabStorage } from './keep-work';
import { WorkModel } from './work-model';

const first = () => ({
  project: { files: [{ name: 'main.py', text: '' }], scene: defaultScene(), course: null },
  open: 'main.py',
  previous: [],
});
const scopes: EffectScope[] = [];
const said: string[] = [];

/** Opens the page in the tab whose session the document has. */
async function openPage(): Promise<WorkModel> {
  const { storage, work } = await openedFrom(await openTabStorage());
  const model = new WorkModel(work ?? first(), Date.now);
  const scope = effectScope(true);
  scopes.push(scope);
  scope.run(() => keepWork(model, storage, (why) => said.push(why ?? 'saved')));
  return model;
}
const programIn = (model: WorkModel): string | undefined => model.files.value[0]?.text;
const textOf = async (): Promise<string | undefined> => programIn(await openPage());
/** The page types one character each 100 ms for so long, and never pauses. */
async function typeFor(model: WorkModel, ms: number): Promise<void> {
  for (let now = 0; now < ms; now += 100) {
    model.setText('main.py', `${programIn(model) ?? ''}x`);
    await vi.advanceTimersByTimeAsync(100);
  }
}
/** The tab dies: what it had in mind is gone, and the page hears of nothing. */
const dies = (): void => scopes.splice(0).forEach((scope) => scope.stop());
/** All stores of this browser that are not on the disk forget. */
function browserIsKilled(): void {
  dies();
  sessionStorage.clear();
  localStorage.clear();
}
/** True if the browser's storage for text takes nothing more. */
let isFull = false;
/** A storage for text like the browser's. */
function textStore() {
  const all = new Map<string, string>();
  return {
    get length() {
      return all.size;
    },
    key: (index: number) => [...all.keys()][index] ?? null,
    getItem: (key: string) => all.get(key) ?? null,
    removeItem: (key: string) => void all.delete(key),
    clear: () => all.clear(),
    setItem(key: string, value: string) {
      if (isFull) throw new DOMException('full', 'QuotaExceededError');
      all.set(key, value);
    },
  };
}

/** Locks that nobody else holds. */
const locks = {
  request: (_: string, __: object, act: (lock: object) => unknown) => {
    act({});
    return new Promise(() => undefined);
  },
};

describe('the work that is kept', () => {
  beforeAll(() => import('../storage/disk-saver')); // fetched before time is a fake one
  beforeEach(() => {
    vi.useFakeTimers({ now: 1_000_000 });
    vi.stubGlobal('navigator', { locks });
    vi.stubGlobal('sessionStorage', textStore());
    vi.stubGlobal('localStorage', textStore());
  });
  afterEach(() => {
    browserIsKilled();
    said.length = 0;
    isFull = false;
    vi.unstubAllGlobals();
    vi.useRealTimers();
  });

  it('lacks at most 0.4 s after eight seconds of typing without a pause', async () => {
    stubDatabase();
    await typeFor(await openPage(), 8000);
    dies();
    expect((await textOf())?.length).toBeGreaterThanOrEqual(76);
  });

  it('lacks no more where the browser puts timers off as long as somebody types', async () => {
    stubDatabase();
    const model = await openPage();
    const late = vi.spyOn(globalThis, 'setTimeout').mockImplementation(() => 1 as never);
    for (let count = 1; count <= 80; count += 1) {
      model.setText('main.py', 'x'.repeat(count));
      await nextTick();
      vi.advanceTimersByTime(100);
    }
    late.mockRestore();
    dies();
    expect((await textOf())?.length).toBeGreaterThanOrEqual(75);
  });

  it('is whole 0.4 s after the last key', async () => {
    stubDatabase();
    const model = await openPage();
    await typeFor(model, 300);
    await vi.advanceTimersByTimeAsync(400);
    dies();
    expect(await textOf()).toBe('xxx');
  });

  it('is saved at once when the page is left', async () => {
    stubDatabase();
    const model = await openPage();
    model.setText('main.py', 'left');
    await nextTick();
    dispatchEvent(new Event('pagehide'));
    dies();
    expect(await textOf()).toBe('left');
  });

  it('comes from the disk after the browser was killed, and was asked to be really there', async () => {
    const database = stubDatabase();
    await typeFor(await openPage(), 3000);
    await vi.advanceTimersByTimeAsync(400);
    browserIsKilled();
    expect((await textOf())?.length).toBe(30);
    expect(new Set(database.durabilities)).toEqual(new Set(['strict']));
  });

  it('is the newer copy, whichever that is, also after the clock was put back', async () => {
    const database = stubDatabase();
    const model = await openPage();
    await typeFor(model, 1000);
    vi.setSystemTime(5000);
    database.hold();
    await typeFor(model, 2000);
    await vi.advanceTimersByTimeAsync(400);
    dies();
    database.release();
    expect((await textOf())?.length).toBe(30);
    const stamp = savedMsOf(sessionStorage.getItem('parcours.work'));
    expect(stamp).toBeGreaterThan(1_000_000);
  });

  it('is written once at a time to a slow disk, the newest last', async () => {
    const database = stubDatabase();
    const model = await openPage();
    await typeFor(model, 1000);
    const before = database.durabilities.length;
    database.hold();
    await typeFor(model, 6000);
    expect(database.durabilities.length - before).toBeLessThanOrEqual(1);
    await vi.advanceTimersByTimeAsync(400);
    database.release();
    await vi.advanceTimersByTimeAsync(0);
    browserIsKilled();
    expect((await textOf())?.length).toBe(70);
  });

  it('is not overwritten by another tab: of six tabs all are kept', async () => {
    const database = stubDatabase();
    for (let tab = 0; tab < 6; tab += 1) {
      sessionStorage.clear();
      const model = await openPage();
      model.setText('main.py', `tab ${String(tab)}`);
      await vi.advanceTimersByTimeAsync(1000);
      dies();
    }
    const kept = [...database.entries.values()].map((entry) => JSON.stringify(entry));
    expect(kept).toHaveLength(6);
    for (const tab of [0, 1, 2, 3, 4, 5]) expect(kept.join()).toContain(`tab ${String(tab)}`);
    expect(await textOf()).toBe('tab 5');
  });

  it('stored by an earlier version is opened', async () => {
    stubDatabase();
    const files = [{ name: 'main.py', text: 'old' }];
    const scene = JSON.parse(serializeScene(defaultScene())) as unknown;
    sessionStorage.setItem('parcours.tab', 't1');
    sessionStorage.setItem(
      'parcours.work',
      JSON.stringify({ version: 1, project: { files, scene, course: null }, open: 'main.py', previous: [] }),
    );
    expect(await textOf()).toBe('old');
  });

  it('has what is being drawn, again and again, and forgets it when the gesture is dropped', async () => {
    stubDatabase();
    const model = await openPage();
    const before = model.scene.value;
    const drawn = (name: string): Scene => ({ ...before, name });
    model.unfinished.value = () => drawn('begun');
    await vi.advanceTimersByTimeAsync(700);
    model.unfinished.value = () => drawn('further');
    await vi.advanceTimersByTimeAsync(400);
    expect(sessionStorage.getItem('parcours.work')).toContain('further');
    expect(model.scene.value).toBe(before);
    model.unfinished.value = null;
    await vi.advanceTimersByTimeAsync(700);
    expect(sessionStorage.getItem('parcours.work')).not.toContain('further');
  });

  it('goes to the tab’s own storage, which is slow, only when the page is left, for a full course', async () => {
    stubDatabase();
    const model = await openPage();
    const long = `# ${'x'.repeat(40_000)}`;
    model.setText('main.py', long);
    await vi.advanceTimersByTimeAsync(700);
    expect(sessionStorage.getItem('parcours.work')).toBeNull();
    expect(await textOf()).toBe(long);
    dispatchEvent(new Event('pagehide'));
    expect(sessionStorage.getItem('parcours.work')).toContain(long);
  });

  it('stays the tab’s own where there are no locks and a duplicate writes under the same name', async () => {
    vi.stubGlobal('navigator', {});
    stubDatabase();
    const model = await openPage();
    model.setText('main.py', 'mine');
    await vi.advanceTimersByTimeAsync(700);
    const mine = sessionStorage.getItem('parcours.work') ?? '';
    model.setText('main.py', 'theirs'); // by the duplicate, later
    await vi.advanceTimersByTimeAsync(700);
    dies();
    sessionStorage.setItem('parcours.work', mine);
    expect(await textOf()).toBe('mine');
  });

  it('is reported once if it fits nowhere, and again only after something could be saved', async () => {
    stubDatabase(false);
    const model = await openPage();
    isFull = true;
    await typeFor(model, 3000);
    expect(said).toEqual(['full']);
    isFull = false;
    await typeFor(model, 1500);
    isFull = true;
    await typeFor(model, 3000);
    expect(said).toEqual(['full', 'saved', 'full']);
  });

  it('is safe if only the disk has room for it, and nothing is reported', async () => {
    stubDatabase();
    const model = await openPage();
    isFull = true;
    await typeFor(model, 2000);
    await vi.advanceTimersByTimeAsync(400);
    expect(said).toEqual([]);
    isFull = false;
    browserIsKilled();
    expect((await textOf())?.length).toBe(20);
  });

  it('is nowhere where the browser forbids storing, and that is told', async () => {
    const refuses = vi.spyOn(globalThis, 'localStorage', 'get').mockImplementation(() => {
      throw new DOMException('denied', 'SecurityError');
    });
    const model = await openPage();
    model.setText('main.py', 'private');
    await vi.advanceTimersByTimeAsync(700);
    refuses.mockRestore();
    expect(said).toEqual(['forbidden']);
  });

  it('gets room in the storage for text from copies of other tabs that are on the disk, too', async () => {
    stubDatabase();
    const first = await openPage();
    first.setText('main.py', 'first');
    await vi.advanceTimersByTimeAsync(700);
    dies();
    sessionStorage.clear();
    const [other] = Object.keys(Object.fromEntries(copiesOf(localStorage)));
    const second = await openPage();
    isFull = true;
    second.setText('main.py', 'second');
    await vi.advanceTimersByTimeAsync(450);
    isFull = false; // one of the copies was given up
    await vi.advanceTimersByTimeAsync(700);
    expect(copiesOf(localStorage).map(([tab]) => tab)).not.toContain(other);
    expect([said, (await copyOnDisk(other ?? null))?.includes('first')]).toEqual([[], true]);
  });

  it('goes to the storage for text alone where there is no database', async () => {
    const model = await openPage();
    await typeFor(model, 2000);
    await vi.advanceTimersByTimeAsync(400);
    expect(said).toEqual([]);
    dies();
    expect((await textOf())?.length).toBe(20);
  });

  it('opens after two seconds where the database never answers', async () => {
    vi.stubGlobal('IDBKeyRange', { bound: () => null });
    vi.stubGlobal('indexedDB', { open: () => ({}) });
    let isOpen = false;
    void openPage().then(() => (isOpen = true));
    await vi.advanceTimersByTimeAsync(1900);
    expect(isOpen).toBe(false);
    await vi.advanceTimersByTimeAsync(200);
    expect(isOpen).toBe(true);
  });
});
