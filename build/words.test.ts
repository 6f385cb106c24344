import { mkdir, mkdtemp, rm, writeFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';

import { reachedWords } from './word-groups.ts';
import { textsIn, words, wordsFolder, wordsIn } from './words.ts';

let src: string;

async function put(files: Readonly<Record<string, string>>): Promise<void> {
  for (const [path, text] of Object.entries(files)) {
    await mkdir(dirname(join(src, path)), { recursive: true });
    await writeFile(join(src, path), text);
  }
}

const wall = {
  'wall/words/de.json': '{ "title": "Wand", "kinds": { "block": "Block" } }',
  'wall/words/fr.json': '{ "kinds": { "block": "bloc" }, "title": "Mur" }',
  'wall/words/it.json': '{ "title": "Muro", "kinds": { "block": "blocco" } }',
  'wall/words/en.json': '{ "title": "Wall", "kinds": { "block": "block" } }',
};

beforeEach(async () => {
  await mkdir('.cache', { recursive: true });
  src = join(process.cwd(), await mkdtemp('.cache/words-'));
  await put(wall);
});
afterEach(() => rm(src, { recursive: true }));

describe('the words of a part', () => {
  it('are its texts in every language, named as in its files', async () => {
    expect(await wordsIn(join(src, 'wall/words'))).toEqual({
      title: { de: 'Wand', fr: 'Mur', it: 'Muro', en: 'Wall' },
      kinds: { block: { de: 'Block', fr: 'bloc', it: 'blocco', en: 'block' } },
    });
  });

  it('have one order in all languages, that of the German file', async () => {
    expect(await textsIn(join(src, 'wall/words'), 'fr')).toEqual(['Mur', 'bloc']);
    expect(await textsIn(join(src, 'wall/words'), 'en')).toEqual(['Wall', 'block']);
  });

  it('are what an import of their folder means, unless a source has its name', async () => {
    const importer = join(src, 'wall/wall.ts');
    expect(wordsFolder('./words', importer)).toBe(join(src, 'wall/words'));
    expect(wordsFolder('../wall/words', importer)).toBe(join(src, 'wall/words'));
    for (const other of ['./word', './words/de.json', 'words', '#wall/words'])
      expect(wordsFolder(other, importer), other).toBeNull();
    await put({ 'wall/words.ts': '' });
    expect(wordsFolder('./words', importer)).toBeNull();
  });

  it('are a module that needs no code at run time', async () => {
    const plugin = words() as unknown as { load(this: object, id: string): Promise<{ readonly code: string }> };
    const { code } = await plugin.load.call({ addWatchFile: () => undefined }, `\0words:${join(src, 'wall/words')}`);
    expect(code).toMatch(/^export default \{"title":\{"de":"Wand","fr":"Mur"/);
  });
});

describe('the words that the page needs at once', () => {
  it('are those that its sources import; those behind import() come late', async () => {
    const late = Object.fromEntries(Object.entries(wall).map(([path, text]) => [path.replace('wall', 'late'), text]));
    const types = Object.fromEntries(Object.entries(wall).map(([path, text]) => [path.replace('wall', 'types'), text]));
    await put({
      ...late,
      ...types,
      'main.ts': "import {\n  title,\n} from './wall/wall';\nimport './style.css';\nawait import('./Late.vue');",
      'wall/wall.ts':
        "import words from './words';\nimport type { A } from '#types/types';\nexport const { title } = words;",
      'Late.vue':
        "<script setup lang=\"ts\">\nimport { title } from '#wall/wall';\nimport words from './late/words';\n</script>",
      'types/types.ts': "import words from './words';\nexport type A = typeof words;",
    });
    expect(reachedWords([join(src, 'main.ts')], src)).toEqual({
      first: [join(src, 'wall/words')],
      late: [join(src, 'late/words')],
    });
  });

  it('are also reached by a pattern that takes in all files of a name', async () => {
    await put({
      'main.ts': "const all = import.meta.glob<Part>('./**/part.ts', { eager: true, import: 'part' });\n",
      'wall/part.ts': "import words from './words';\n",
    });
    expect(reachedWords([join(src, 'main.ts')], src).first).toEqual([join(src, 'wall/words')]);
  });
});
