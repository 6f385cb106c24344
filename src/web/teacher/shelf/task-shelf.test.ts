// @vitest-environment happy-dom
import { afterEach, beforeAll, describe, expect, it, vi } from 'vitest';

import { aSeries, teachersTask } from '#check/series/testing/series';
import { aboutOf, withAbout, type ShelfWork } from '#check/shelf/shelf';
import { noAbout } from '#check/task/about';

import { loadTexts } from '../../kit/i18n';
import { stubDatabase } from '../../session/work/storage/testing/memory-database';
import { TaskShelf } from './task-shelf';
import { workNameOf } from './work-name-of';

beforeAll(() => loadTexts('de'));
afterEach(() => vi.unstubAllGlobals());

const named = (name: string, text = ''): ShelfWork => ({
  kind: 'task',
  project: { ...teachersTask(), scene: { ...teachersTask().scene, name }, files: [{ name: 'main.py', text }] },
});
async function opened(): Promise<TaskShelf> {
  const shelf = new TaskShelf();
  await vi.waitFor(() => expect(shelf.isReady.value).toBe(true));
  return shelf;
}
const names = ({ items }: TaskShelf): readonly string[] => items.value.map(({ work }) => workNameOf(work));
const programOf = ({ items }: TaskShelf, name: string): readonly string[] =>
  items.value.flatMap(({ work }) =>
    work.kind === 'task' && workNameOf(work) === name ? [work.project.files[0]!.text] : [],
  );

describe('the shelf of a teacher', () => {
  it('has its tasks and series again on the next visit, whole with their solutions', async () => {
    stubDatabase();
    const shelf = await opened();
    await shelf.keep(named('Linie'));
    await shelf.keep({ kind: 'series', series: aSeries() });
    const next = await opened();
    expect(next.items.value.map(({ text }) => text).sort()).toEqual(shelf.items.value.map(({ text }) => text).sort());
    expect(next.items.value.map(({ text }) => text).join()).toContain('Musterlösung');
  });

  it('renews a task of the same name, which keeps its details, and brings the earlier one back', async () => {
    stubDatabase();
    const shelf = await opened();
    await shelf.keep(withAbout(named('Linie', 'a = 1'), { ...noAbout, level: 'Klasse 8' }));
    const { isNew, undo } = await shelf.keep(named('Linie', 'a = 2'));
    expect([isNew, programOf(shelf, 'Linie'), aboutOf(shelf.items.value[0]!.work)?.level]).toEqual([false, ['a = 2'], 'Klasse 8']); // prettier-ignore
    await undo();
    expect(programOf(await opened(), 'Linie')).toEqual(['a = 1']);
  });

  it('gives back what was deleted', async () => {
    stubDatabase();
    const shelf = await opened();
    await shelf.keep(named('Linie'));
    const undo = shelf.remove(shelf.items.value);
    await vi.waitFor(async () => expect(names(await opened())).toEqual([]));
    await undo();
    expect(names(await opened())).toEqual(['Linie']);
  });

  it('holds what two tabs have done: new works, details of one, and two versions of one name', async () => {
    stubDatabase();
    const [one, two] = [await opened(), await opened()];
    await one.keep(named('Linie', 'a = 1'));
    await two.keep(named('Wand'));
    expect([...names(two)].sort()).toEqual(['Linie', 'Wand']);
    await two.setAbout(
      two.items.value.find(({ work }) => workNameOf(work) === 'Linie')!,
      { ...noAbout, topic: 'Linien' },
    );
    await one.setAbout(one.items.value[0]!, { ...noAbout, topic: 'Linien', minutes: 45 });
    expect(aboutOf(one.items.value[0]!.work)).toMatchObject({ topic: 'Linien', minutes: 45 });
    await two.keep(named('Linie', 'a = 2')); // has not seen the 45 minutes
    expect([...programOf(await opened(), 'Linie')].sort()).toEqual(['a = 1', 'a = 2']);
  });

  it('loses nothing where the browser has no room: it stays while the page is open, and says so', async () => {
    stubDatabase(false);
    const shelf = await opened();
    const { isStored } = await shelf.keep(named('Linie'));
    await shelf.setAbout(shelf.items.value[0]!, { ...noAbout, level: 'Klasse 8' });
    await shelf.refresh();
    expect([isStored, shelf.isUnsaved.value, names(shelf)]).toEqual([false, true, ['Linie']]);
    expect(aboutOf(shelf.items.value[0]!.work)?.level).toBe('Klasse 8');
  });
});
