import { execFile } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { promisify } from 'node:util';
import { readProgram } from '../build/programs';
import { seriesLinkOf } from '../src/check/series/series-link';
import { expect, test, type App } from './app';
import { IN_ONE_ENGINE } from './engines';
import { CREEP, linkTo, openClass, paste, RIGHT, select } from './class-page';
import { kindsInNode } from './in-node';
import { onceARun } from './once-a-run';
import { openedCourse } from './opened-course';
import { isThere, openWork } from './page';
import { by, gone, until } from './parts';

/** The pupils' mail: right, wrong, with an error, endless (at rest: that runs in no time), the same as another's, and damaged. */
const MAIL = `Guten Tag, hier sind alle.

Ada: ${linkTo(RIGHT)}
Ben: ${linkTo(CREEP)}
Cem: ${linkTo('x = 1 / 0\n')}
Dora: ${linkTo('from microbit import *\nwhile True:\n    sleep(1000)\n')}
Emil: ${linkTo(`# meins\n${RIGHT}`)}
Finn: ${linkTo(RIGHT).slice(0, -9)}
`;

/** Puts a text with links into its field. */
const pasteInto = (app: App, mail: string): Promise<void> =>
  app.evaluate((text) => {
    const field = document.querySelector<HTMLTextAreaElement>('[data-testid=class-links]')!;
    field.value = text;
    field.dispatchEvent(new Event('input', { bubbles: true }));
  }, mail);

/** A table and a report of a class. */
interface Written {
  readonly table: string;
  readonly report: string;
}

/** The files that the command line writes for an e-mail. @param name of the class, for all engines */
const writtenByCommandLine = (name: string, task: string, text: string): Promise<Written> =>
  onceARun(`class-${name}`, async (folder) => {
    const [mail, csv, html] = ['mail.txt', 'class.csv', 'class.html'].map((file) => join(folder, file)) as [string, string, string]; // prettier-ignore
    writeFileSync(mail, text);
    const given = ['bin/parcours.mjs', 'check', task, mail, '--table', csv, '--report', html, '--lang', 'de'];
    await promisify(execFile)('node', given).catch(() => undefined); // exit code 3: not all have passed
    return { table: readFileSync(csv, 'utf8'), report: readFileSync(html, 'utf8') };
  });

/** A mission's start program and solution as pupils find them who have the page in different languages. */
async function missionMail(): Promise<string> {
  const programs = await Promise.all(
    ['start', 'main'].map((name) => readProgram(`courses/missions/12-closed-line/${name}.py`)),
  );
  const [start, main] = programs.map(({ source }) => source);
  const filled = (text = ''): string => linkTo(text.replaceAll('$module', 'mbrobot'));
  return [
    `Ada: ${filled(main?.de)}`,
    ...(['de', 'en', 'fr', 'it'] as const).map((language) => `${language}: ${filled(start?.[language])}`),
  ].join('\n');
}

/** Keeps saved files here instead. */
const keepSaved = (app: App): Promise<void> =>
  app.evaluate(() => {
    URL.createObjectURL = (blob) => {
      void (blob as Blob).text().then((text) => (document.documentElement.dataset['saved'] = text));
      return 'blob:kept';
    };
    HTMLAnchorElement.prototype.click = () => undefined;
  });

/** The last file that the page saved. */
const saved = (app: App): Promise<string> => app.evaluate(() => document.documentElement.dataset['saved'] ?? '');

test(
  'a class that sends links is checked: table and report are byte for byte those of the command line',
  IN_ONE_ENGINE,
  async ({ app }) => {
    test.setTimeout(120_000);
    const byCommandLine = writtenByCommandLine('of-links', 'closed-line', MAIL);
    await openClass(app, 'closed-line');
    await keepSaved(app);
    await pasteInto(app, MAIL);
    await app.click(by('class-check-links'));
    await until(app, by('class-table'));
    // One of them never comes to its end, and is given up.
    await expect.poll(() => isThere(app, 'progress'), { timeout: 60_000 }).toBe(false);
    const table = await app.text(by('class-table'));
    for (const words of ['Ada', 'gleich wie Emil', 'Zeile 1: ZeroDivisionError', 'bitte neu abgeben'])
      expect(table).toContain(words);
    await app.click(by('class-csv'));
    // The browser leaves out the sign at the beginning by which spreadsheets know UTF-8.
    const { table: wanted, report } = await byCommandLine;
    await expect.poll(() => saved(app)).toBe(wanted.replace(/^\ufeff/, ''));
    await app.click(by('class-report'));
    await until(app, by('class-report-page'));
    expect(await app.evaluate(() => document.querySelector('iframe')!.srcdoc)).toBe(report);
    // Its links lead to its own sheets, not to this app.
    await expect.poll(() => app.evaluate(() => document.querySelector('iframe')!.contentDocument!.querySelector('a')?.href)).toBe('about:srcdoc#hand-in-0'); // prettier-ignore
    await app.evaluate(
      () => (document.querySelector('iframe')!.contentWindow!.print = () => (document.title = 'printed')),
    );
    await app.click(by('report-print'));
    await expect.poll(() => app.evaluate(() => document.title)).toBe('printed');
    await app.click(by('report-save'));
    await expect.poll(() => saved(app)).toBe(report);
    await app.evaluate(() => {
      const who = document.querySelector<HTMLSelectElement>('[data-testid=report-of]')!;
      who.selectedIndex = 3; // after the class and its table alone
      who.dispatchEvent(new Event('change', { bubbles: true }));
    });
    const sheet = (): Promise<string> =>
      app.evaluate(() => document.querySelector('iframe')!.contentDocument!.querySelector('main')?.innerText ?? '');
    await expect.poll(sheet).toMatch(/^Ben\s+Geschlossene Linie · ✗ nicht bestanden/);
    await app.press('Escape');
    await gone(app, by('class-report-page'));
    await app.click(by('class-passed'));
    await expect.poll(() => app.text(by('class-table'))).not.toContain('Ben');
    await app.click(`${by('class-table')} .name`);
    await until(app, by('class-open'));
    const href = await app.evaluate(() => document.querySelector<HTMLAnchorElement>('[data-testid=class-open]')!.href);
    expect(href).toContain('#p=');
    // Escape closes the opened hand-in, then the page.
    await app.press('Escape');
    await gone(app, by('class-view'));
    await until(app, by('class-task'));
    await app.press('Escape');
    await gone(app, by('class-task'));
  },
);

test(
  'a class of a mission has the same title and remarks on the page and on the command line, in whatever language it worked',
  IN_ONE_ENGINE,
  async ({ app }) => {
    test.setTimeout(120_000);
    const [mission, mail] = ['closed-line-maqueen-lite', await missionMail()];
    await openClass(app, mission);
    await pasteInto(app, mail);
    await app.click(by('class-check-links'));
    await until(app, by('class-table'));
    await expect.poll(() => isThere(app, 'progress'), { timeout: 60_000 }).toBe(false);
    expect((await app.text(by('class-table'))).split('unverändert')).toHaveLength(5);
    await app.click(by('class-report'));
    await until(app, by('class-report-page'));
    const shown = await app.evaluate(() => document.querySelector('iframe')!.srcdoc);
    expect(shown).toBe((await writtenByCommandLine('of-a-mission', mission, mail)).report);
  },
);

test(
  'a task of a series, whose link is pasted, is checked like on the command line',
  IN_ONE_ENGINE,
  async ({ app }) => {
    test.setTimeout(120_000);
    const tasks = ['slalom', 'closed-line'].map((course, place) => ({
      id: String(place + 1),
      title: place === 0 ? '' : 'Rund um den Tisch',
      from: { kind: 'course' as const, course },
    }));
    const made = seriesLinkOf({ id: 'woche', title: 'Woche 3', text: '', tasks }, () => null);
    const link = `https://example.org/#${made?.fragment ?? ''}`;
    await openClass(app, 'square');
    await keepSaved(app);
    await paste(app, `Die Reihe: ${link}`);
    await until(app, by('class-series-task'));
    await select(app, 'class-series-task', '2');
    const mail = `Ada: ${linkTo(RIGHT)}\nBen: ${linkTo(CREEP)}\n`;
    await paste(app, mail);
    await until(app, by('class-table'));
    await expect.poll(() => app.text(by('class-table')), { timeout: 60_000 }).toContain('19.5');
    await expect.poll(() => isThere(app, 'progress'), { timeout: 60_000 }).toBe(false);
    const { table, report } = await writtenByCommandLine('of-a-series', `${link}#2`, mail);
    await app.click(by('class-csv'));
    await expect.poll(() => saved(app)).toBe(table.replace(/^\ufeff/, ''));
    await app.click(by('class-report'));
    await until(app, by('class-report-page'));
    expect(report).toContain('<h1>Rund um den Tisch</h1>');
    expect(await app.evaluate(() => document.querySelector('iframe')!.srcdoc)).toBe(report);
  },
);

/** The hand-ins in the browser's database: a list as JSON. */
const keptRows = (): Promise<string> =>
  new Promise((resolve) => {
    const opened = indexedDB.open('parcours', 1);
    opened.onsuccess = () => {
      const rows = opened.result
        .transaction('pieces')
        .objectStore('pieces')
        .getAll(IDBKeyRange.bound('class.row.', 'class.row.~')) as IDBRequest<{ readonly text: string }[]>;
      rows.onsuccess = () => {
        opened.result.close();
        resolve(`[${rows.result.map(({ text }) => text).join()}]`);
      };
    };
  });

test('what a pupil hands in on the page is proved on the teacher’s, who keeps it over a reload as long as she wants', async ({
  app,
}) => {
  test.setTimeout(120_000);
  await app.goto('./logo.svg');
  await app.evaluate((work) => {
    localStorage.setItem('parcours.settings', JSON.stringify({ language: 'de', welcomed: true }));
    sessionStorage.setItem('parcours.work', work);
  }, openedCourse('closed-line'));
  await app.goto('./');
  await app.click('[aria-label="Teilen"]');
  await app.click(by('hand-in'));
  await app.fill(by('hand-in-name'), 'Ada L.');
  await expect.poll(() => app.text(by('hand-in-state')), { timeout: 60_000 }).toContain('bestanden nach 19.5 s');
  await app.evaluate(() => {
    const writeText = (text: string): Promise<void> => {
      sessionStorage.setItem('copied', text);
      return Promise.resolve();
    };
    Object.defineProperty(navigator, 'clipboard', { value: { writeText }, configurable: true });
  });
  await app.click(by('hand-in-copy'));
  const link = await app.evaluate(() => sessionStorage.getItem('copied') ?? '');
  await app.goto('./#class');
  await app.reload();
  await until(app, by('class-links'));
  await pasteInto(app, link);
  await app.click(by('class-check-links'));
  await until(app, by('class-table'));
  await gone(app, 'progress');
  const table = (await app.text(by('class-table'))).replace(/\s+/g, ' ');
  expect(table).toContain('Ada L. bestanden 1/1 19.5 s 0 1');
  expect(table).not.toMatch(/Lauf weicht ab|Parcours verändert/);
  await app.click(`${by('class-table')} .name`);
  await app.fill(by('class-note'), 'Prima');
  await app.click(by('class-keep'));
  await expect.poll(() => app.evaluate(keptRows)).toContain('Prima');
  await app.reload();
  await until(app, by('class-table'));
  const again = (await app.text(by('class-table'))).replace(/\s+/g, ' ');
  expect(again).toContain('Ada L. bestanden 1/1 19.5 s 0 1');
  expect(again).toContain('Prima');
  await app.evaluate(() => {
    const other = document.createElement('iframe');
    other.src = `${location.pathname}?other#class`;
    other.id = 'other';
    document.body.append(other);
  });
  const there = (): Promise<string> =>
    app.evaluate(() => {
      const table = document.querySelector<HTMLIFrameElement>('#other')!.contentDocument?.querySelector('[data-testid=class-table]'); // prettier-ignore
      return table?.textContent ?? '';
    });
  await expect.poll(there, { timeout: 30_000 }).toContain('Prima');
  await app.click(`${by('class-table')} .name`);
  await app.fill(by('class-note'), 'Noch besser');
  // Another page of the same browser follows.
  await expect.poll(there).toContain('Noch besser');
  await app.click(by('class-keep'));
  await expect.poll(() => app.evaluate(keptRows)).toBe('[]');
});

/** The line of `--json` that the command line prints of an e-mail, by these options. */
async function lineOfCommandLine(task: string, mail: string): Promise<string> {
  const folder = mkdtempSync(join(tmpdir(), 'parcours-class-'));
  const files = { 'task.json': task, 'mail.txt': mail };
  for (const [name, text] of Object.entries(files)) writeFileSync(join(folder, name), text);
  const given = ['check', join(folder, 'task.json'), join(folder, 'mail.txt'), '--json', '--lang', 'de'];
  try {
    await promisify(execFile)('node', ['bin/parcours.mjs', ...given]);
    throw new Error('All have passed.');
  } catch (error) {
    return (error as { readonly stdout: string }).stdout.trim().split('\n').at(-1) ?? '';
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
}

test(
  'hand-ins of every kind, for a task with hidden worlds: what the page finds is what the command line finds, to the byte',
  IN_ONE_ENGINE,
  async ({ app }) => {
    test.setTimeout(120_000);
    const { aClass, lineOf } = await kindsInNode();
    const { task, work, mail } = await aClass();
    const byCommandLine = lineOfCommandLine(task, mail); // while the page is at it
    await openWork(app, work, './#class');
    await until(app, by('class-links'));
    await app.evaluate(() => {
      document.querySelector<HTMLInputElement>('[data-testid=class-keep]')!.click();
    });
    await pasteInto(app, mail);
    await app.click(by('class-check-links'));
    await until(app, by('class-table'));
    const wanted = await byCommandLine;
    const { handIns } = JSON.parse(wanted) as {
      readonly handIns: readonly {
        readonly name: string;
        readonly passed: boolean;
        readonly remarks: readonly string[];
      }[];
    };
    expect(handIns.filter(({ passed }) => passed).map(({ name }) => name)).toEqual(['Ada', 'Ivo', 'Lea', 'Nina', 'Zoë 🤖 «7b»']); // prettier-ignore
    const told = handIns.flatMap(({ name, remarks }) =>
      remarks.length === 0 ? [] : [`${name}: ${remarks.join(' ')}`],
    );
    expect(told).toEqual([
      'Ada: Gleiches Programm wie: Zoë 🤖 «7b»',
      'Ada (2): Die Abgabe sagt «bestanden», der Lauf hier nicht. Gleiches Programm wie: Cem',
      'Cem: Gleiches Programm wie: Ada (2)',
      'Hana: Beim Üben half die Hand.',
      'Ivo: Der Parcours wurde geändert; geprüft wurde mit dem der Aufgabe.',
      'Kai: nicht lesbar: Der Link ist beschädigt oder unvollständig. Bitte ganz kopieren und neu senden.',
      'Lea: für eine andere Aufgabe: another',
      'Max: Das Programm ist noch das ausgeteilte.',
      'Nina: Das Programm wurde ausserhalb der Seite geändert.',
      'Zoë 🤖 «7b»: Gleiches Programm wie: Ada',
    ]);
    type Rows = Parameters<typeof lineOf>[0];
    const found = async (): Promise<string> => {
      const rows = JSON.parse(await app.evaluate(keptRows)) as Rows;
      return rows.length === handIns.length && rows.every(({ result }) => result !== null) ? lineOf(rows) : '';
    };
    await expect.poll(found, { timeout: 60_000 }).toBe(wanted);
  },
);
