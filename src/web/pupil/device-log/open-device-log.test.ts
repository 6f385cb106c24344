// @vitest-environment happy-dom
import { beforeEach, describe, expect, it, vi } from 'vitest';

import { microbitPage } from '#device-log/testing/microbit-page';

import { createPage, type TestPage } from '../../app/testing/page';
import { setLanguage, t } from '../../kit/i18n';
import { LANGUAGES } from '../../kit/i18n/texts';
import { commandsOf } from '../../exchange/share/use-commands';

const csv = 'Time (seconds),cm\n0.10,12.5\n0.20,11\n';
let page: TestPage;
beforeEach(async () => {
  await setLanguage('de');
  page = createPage();
  page.settings.change({ language: 'de' });
});

const file = (name: string, content: BlobPart = csv): File => new File([content], name);
const htm = (bytes: Uint8Array): File => file('MY_DATA.HTM', bytes.slice());
/** Drops files onto the page; what it says then, if it says something. */
async function dropped(...files: readonly File[]): Promise<string> {
  page.notices.close();
  const before = page.dataLog.device.value;
  commandsOf(page).take(files);
  const isDone = (): boolean => page.notices.current.value !== null || page.dataLog.device.value !== before;
  await vi.waitFor(() => expect(isDone()).toBe(true), { timeout: 20_000, interval: 5 });
  const notice = page.notices.current.value;
  return notice === null ? '' : t(notice.key, notice.values);
}
const rows = () => page.dataLog.device.value?.log.rows;

describe('a file of readings', () => {
  it.each(['MY_DATA.HTM', 'my_data.html', 'walk.csv', 'walk.tsv', 'walk.txt', 'WALK.CSV'])(
    'named %s is opened beside the simulation’s, and its window with it',
    async (name) => {
      expect(await dropped(file(name, /htm/i.test(name) ? microbitPage({ csv }).slice() : csv))).toBe('');
      expect(page.dataLog.device.value?.file).toBe(name);
      expect(rows()).toEqual([['0.10', '12.5'], ['0.20', '11']]); // prettier-ignore
      expect(page.dataLog.isCompared.value).toBe(true);
      expect(page.settings.current.value.panel).toBe('log');
      expect(page.work.files.value.map((it) => it.name)).toEqual(['main.py']);
    },
  );

  it('stays open through runs and their data logs', async () => {
    await dropped(file('walk.csv'));
    page.dataLog.take([{ type: 'row', headings: ['cm'], values: ['1'], timeUs: 0 }]);
    page.dataLog.clear();
    expect(rows()).toHaveLength(2);
  });

  it('comes along with a program', async () => {
    await dropped(file('walk.csv'), file('turn.py', 'a = 1\n'));
    await vi.waitFor(() => expect(page.work.find('turn.py')).toBeDefined());
    expect(rows()).toHaveLength(2);
  });

  it('is the last of several, which is told', async () => {
    expect(await dropped(file('one.csv'), file('two.csv'))).toBe(
      'two.csv ist offen. Von mehreren Dateien wird nur die letzte gezeigt.',
    );
    expect(page.dataLog.device.value?.file).toBe('two.csv');
  });
});

describe('a file of readings that cannot be shown', () => {
  it.each<readonly [string, File, string]>([
    ['nothing in it', file('a.csv', ''), 'a.csv ist leer. Kopiere die Datei nochmals vom Gerät.'],
    ['no numbers', file('a.csv', 'x,y\nred,blue\n'), 'In a.csv ist nichts zu zeichnen: In Zeile 2 steht «red». Nötig ist eine Spalte mit Zahlen neben der Zeit.'],
    ['a workbook', file('a.xlsx', Uint8Array.of(0x50, 0x4b, 3, 4)), 'a.xlsx ist eine Arbeitsmappe. Speichere sie in der Tabellenkalkulation als CSV und öffne diese Datei.'],
    ['another page', file('a.html', '<html>1,2</html>'), 'In a.html steht kein Datenlog eines micro:bit. Es heisst MY_DATA.HTM und liegt auf dem Laufwerk MICROBIT.'],
    ['half of a page', htm(microbitPage({ csv }).slice(0, 5000)), 'MY_DATA.HTM bricht nach 4.9 kB ab, noch vor der ersten ganzen Zeile (ab 8 kB). Kopiere die Datei nochmals vom Gerät.'],
    ['an empty log', htm(microbitPage({ csv: '' })), 'Das Datenlog in MY_DATA.HTM hat noch keine Zeile. Lass dein Programm mit log.add() messen und kopiere die Datei dann nochmals.'],
    ['binary data', file('a.csv', Uint8Array.of(1, 0, 2, 0xc3, 0)), 'a.csv ist kein Text. Es gehen MY_DATA.HTM vom micro:bit und Tabellen (.csv).'],
    ['too many columns', file('a.csv', `${Array.from({ length: 61 }, (_, at) => `c${String(at)}`).join()}\n`), 'a.csv hat in Zeile 1 61 Spalten, erlaubt sind 60. Lösche Spalten, die du nicht brauchst.'],
  ])('for %s says where and what to do, and keeps the readings before', async (_, given, words) => {
    await dropped(file('before.csv'));
    page.dataLog.isCompared.value = false;
    expect(await dropped(given)).toBe(words);
    expect(page.notices.current.value?.kind).toBe('error');
    expect(page.dataLog.device.value?.file).toBe('before.csv');
    expect(page.dataLog.isCompared.value).toBe(false);
  }); // prettier-ignore

  it('is not even read if it has 100 MB', async () => {
    const huge = file('huge.csv');
    Object.defineProperty(huge, 'size', { value: 100 * 1024 * 1024 });
    huge.arrayBuffer = () => Promise.reject(new Error('This would fill the memory.'));
    expect(await dropped(huge)).toMatch(/^huge\.csv ist zu gross: 100 MB, erlaubt sind 1 MB\./);
  });

  it('because the drive is gone says so', async () => {
    const gone = file('MY_DATA.HTM');
    gone.arrayBuffer = () => Promise.reject(new DOMException('gone', 'NotReadableError'));
    expect(await dropped(gone)).toMatch(/^MY_DATA\.HTM lässt sich nicht lesen\./);
  });

  it('has words in every language, with every value in them', async () => {
    for (const language of LANGUAGES) {
      await setLanguage(language);
      const told = await dropped(file('a.csv', `x\n${'long '.repeat(100)}\n`));
      expect(told).toContain('a.csv');
      expect(told).toContain('long long');
      expect(told).not.toMatch(/[{}]/);
      expect(told.length).toBeLessThan(250);
    }
  });
});
