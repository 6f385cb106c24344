import { cp, mkdir, mkdtemp, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { filesWithTexts, problemsOf } from './texts.mjs';
import { sameWords } from './texts-same.mjs';

/** A made-up language: what German says, marked. */
const NEW = 'eo';
const mark = (value) =>
  typeof value === 'string'
    ? `¶${value}`
    : Object.fromEntries(Object.entries(value).map(([name, it]) => [name, mark(it)]));

/** A copy of the sources with the language in it. It lies in the repository, so that packages are found from there. */
let place;
const inPlace = (path) => import(pathToFileURL(join(process.cwd(), place, 'src', path)).href);

/** The files that a new language takes: `src/…/words/eo.json` beside each German one, and the list with a line more. */
async function newFiles(folder) {
  const paths = (await readdir(folder, { recursive: true })).filter((path) =>
    /\bwords\/([a-z-]+\/)?de\.json$/.test(path),
  );
  const texts = paths.map(async (path) => [
    join(folder, path.replace(/de\.json$/, `${NEW}.json`)),
    `${JSON.stringify(mark(JSON.parse(await readFile(join(folder, path), 'utf8'))), null, 2)}\n`,
  ]);
  return Promise.all(texts);
}
const withLine = (list) => list.replace(/^ {2}en: .*$/m, `$&\n  ${NEW}: { name: 'Esperanto', locale: 'eo' },`);

beforeAll(async () => {
  await mkdir('.cache', { recursive: true });
  place = await mkdtemp('.cache/new-language-');
  await cp('src', join(place, 'src'), { recursive: true });
  await cp('package.json', join(place, 'package.json'));
  for (const [path, text] of await newFiles(join(place, 'src'))) await writeFile(path, text);
  const list = join(place, 'src/core/languages.ts');
  await writeFile(list, withLine(await readFile(list, 'utf8')));
});

afterAll(() => rm(place, { recursive: true }));

/** Every text in all languages that a value holds. */
function textsIn(value) {
  if (typeof value !== 'object' || value === null) return [];
  if (typeof value.de === 'string') return [value];
  return Object.values(value).flatMap(textsIn);
}

describe('a fifth language', () => {
  it('takes a file for every part and a line in the list: the check has nothing to say', async () => {
    const files = new Map(await filesWithTexts());
    for (const folder of ['src', 'courses', 'scripts/robot-template'])
      for (const [path, text] of await newFiles(folder)) files.set(path.replaceAll('\\', '/'), text);
    files.set('src/core/languages.ts', withLine(files.get('src/core/languages.ts')));
    expect(problemsOf(files, sameWords)).toEqual([]);
    files.delete(`src/web/kit/words/${NEW}.json`);
    expect(problemsOf(files)).toContain(`src/web/kit/words/*.json bar.run: no text in ${NEW}`);
  });

  it('is spoken by every part that has words', async () => {
    const paths = await readdir(join(place, 'src'), { recursive: true });
    const isPart = (path) => /\bwords\/([a-z-]+\/)?de\.json$/.test(path) && !/\b(examples|programs)\//.test(path);
    const folders = paths.filter(isPart).map((path) => path.replace(/\/de\.json$/, ''));
    const imports = folders.map((folder, index) => `import words${index} from './${folder}';`);
    const list = `export default { ${folders.map((folder, index) => `'${folder}': words${index}`).join(', ')} };`;
    await writeFile(join(place, 'src/all-words.ts'), [...imports, list].join('\n'));
    const { default: all } = await inPlace('all-words.ts');
    for (const [folder, words] of Object.entries(all))
      for (const texts of textsIn(words)) expect(texts[NEW], folder).toBe(`¶${texts.de}`);
    expect(textsIn(all).length).toBeGreaterThan(2000);
  });

  it('is spoken by robots, attachments and their sheets', async () => {
    const lists = await Promise.all(['robots/index.ts', 'robots/sheets.ts', 'attachments/types.ts'].map(inPlace));
    // Programs have a test of their own.
    const withoutPrograms = ({ robotSheets, ...list }) => [
      list,
      robotSheets?.map((sheet) => ({ ...sheet, examples: [] })),
    ];
    const texts = lists.flatMap((list) => textsIn(withoutPrograms(list)));
    expect(texts.length).toBeGreaterThan(200);
    const isWritten = ({ de }) => !/^(Servo |0x)/.test(de); // the names of ports and addresses are the same everywhere
    for (const it of texts.filter(isWritten)) expect(it[NEW]).toBe(`¶${it.de}`);
    const { robotReferences } = await inPlace('robots/references.ts');
    for (const { texts: words } of robotReferences)
      for (const text of Object.values(words)) expect(text[NEW]).toMatch(/^¶/);
  });

  it('is spoken by what is fetched one language at a time: the first page, errors, help, reference, device check', async () => {
    const { loadTexts, loadErrorTexts, setLanguage: _, showLanguage, t } = await inPlace('web/kit/i18n/index.ts');
    await loadTexts(NEW);
    showLanguage(NEW);
    await loadErrorTexts();
    expect([t('bar.run'), t('error.NameError')].every((text) => text.startsWith('¶'))).toBe(true);
    const { loadReferenceTexts } = await inPlace('reference/texts.ts');
    expect((await loadReferenceTexts(NEW))['microbit.display']).toMatch(/^¶/);
    const { loadRuleTexts } = await inPlace('device-check/rule-texts.ts');
    expect((await loadRuleTexts(NEW))['f-string']).toMatch(/^¶/);
    const { loadGuide } = await inPlace('web/help/guide/load-guide.ts');
    expect((await loadGuide(NEW, null)).content.title).toMatch(/^¶/);
  });

  it('is offered and understood: by the page, the command line and hosts', async () => {
    const { preferredLanguage } = await inPlace('web/kit/i18n/index.ts');
    expect(preferredLanguage(['eo', 'de'])).toBe(NEW);
    const { LANGUAGES } = await inPlace('core/languages.ts');
    expect(LANGUAGES).toContain(NEW);
  });
});
