import { existsSync } from 'node:fs';
import { mkdir, mkdtemp, readdir, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { LANGUAGES } from '../src/core/languages.ts';
import { wordProblems } from './program-words.ts';
import { readProgram, translate } from './programs.ts';

describe('a program in another language', () => {
  it('has its comments and strings translated, and the same code', () => {
    const words = { Hello: 'Hallo', 'a word': 'ein Wort' };
    expect(translate('# Hello\nprint("Hello", 1)  # a word\n', words)).toBe('# Hallo\nprint("Hallo", 1)  # ein Wort\n');
  });

  it('keeps what has no translation', () => {
    expect(translate('was_gesture("shake")  # shake it', {})).toBe('was_gesture("shake")  # shake it');
    expect(translate('# constructor', {})).toBe('# constructor');
  });

  it('tells a comment from a # in a string, and a string from quotes in a comment', () => {
    expect(translate('print("# no")  # say "no"', { no: 'nein', '# no': '# nein', 'say "no"': 'sag «nein»' })).toBe(
      'print("# nein")  # sag «nein»',
    );
  });

  it('takes docstrings, strings in single quotes and those with an escaped quote', () => {
    expect(translate('"""Goes on."""', { 'Goes on.': 'Geht weiter.' })).toBe('"""Geht weiter."""');
    expect(translate("print('a', 'it\\'s', '')", { "it\\'s": 'das ist', a: 'ein' })).toBe(
      "print('ein', 'das ist', '')",
    );
  });

  it('may need two lines for a comment', () => {
    expect(translate('# A square. Try it!\nleft()', { 'A square. Try it!': 'Ein Quadrat.\n# Versuch es!' })).toBe(
      '# Ein Quadrat.\n# Versuch es!\nleft()',
    );
  });
});

describe('a folder of programs', () => {
  let folder: string;
  beforeEach(async () => {
    folder = await mkdtemp(join(tmpdir(), 'parcours-words-'));
    await put('line.py', '# Line\nprint("Hello", "ok")\n');
    await put('words/en.json', '{ "line": { "title": "A line" } }');
    for (const language of LANGUAGES.filter((it) => it !== 'en')) await putWords(language);
  });
  afterEach(() => rm(folder, { recursive: true }));

  async function put(name: string, text: string): Promise<void> {
    await mkdir(dirname(join(folder, name)), { recursive: true });
    await writeFile(join(folder, name), text);
  }
  const putWords = (language: string, program: object = { Line: `${language} line`, Hello: `${language} hello` }) =>
    put(`words/${language}.json`, JSON.stringify({ line: { title: `${language} title`, program } }));
  const problems = async (): Promise<string> => (await wordProblems(folder)).join('\n');

  it('is read in every language, with the texts about each program', async () => {
    const { file, source, texts } = await readProgram(join(folder, 'line.py'));
    expect(file).toBe('line.py');
    expect(source.en).toBe('# Line\nprint("Hello", "ok")\n');
    expect(source.fr).toBe('# fr line\nprint("fr hello", "ok")\n');
    expect(texts).toEqual({ title: { de: 'de title', fr: 'fr title', it: 'it title', en: 'A line' } });
    expect(await problems()).toBe('');
  });

  it('may have words that all programs share', async () => {
    await put('main.py', '# Line\n');
    for (const language of LANGUAGES)
      await put(`words/${language}.json`, JSON.stringify({ name: language, program: { Line: language } }));
    await put('words/en.json', '{ "name": "en" }');
    for (const name of ['main.py', 'line.py'])
      expect((await readProgram(join(folder, name))).source.de).toMatch(/^# de\n/);
    expect((await readProgram(join(folder, 'main.py'))).texts['name']).toMatchObject({ fr: 'fr', en: 'en' });
  });

  it('is in English in a language that has no words yet, which is a problem', async () => {
    await rm(join(folder, 'words/it.json'));
    const { source, texts } = await readProgram(join(folder, 'line.py'));
    expect([source.it, texts['title']?.it]).toEqual([source.en, 'A line']);
    expect(await problems()).toBe(`${join(folder, 'words/it.json')} is missing`);
  });

  it('speaks a new language as soon as there is a file for it', async () => {
    await putWords('eo');
    const languages = [...LANGUAGES, 'eo'] as typeof LANGUAGES;
    const { source, texts } = await readProgram(join(folder, 'line.py'), languages);
    expect(source).toMatchObject({ eo: '# eo line\nprint("eo hello", "ok")\n' });
    expect(texts['title']).toMatchObject({ eo: 'eo title', de: 'de title' });
  });

  it('is told which comment or string has no translation, and in which file', async () => {
    await putWords('fr', { Line: 'Ligne' });
    expect(await problems()).toBe(`${join(folder, 'words/fr.json')}: no translation of “Hello”`);
    await putWords('fr', { Hello: 'Bonjour' });
    expect(await problems()).toContain('no translation of “Line”');
  });

  it('is told which translation nobody needs', async () => {
    await putWords('de', { Line: 'Linie', Hello: 'Hallo', 'Good-bye': 'Tschüss' });
    expect(await problems()).toBe(`${join(folder, 'words/de.json')}: no program says “Good-bye”`);
    await put(
      'words/de.json',
      '{ "lime": { "program": {} }, "line": { "program": { "Line": "Linie", "Hello": "Hoi" } } }',
    );
    expect(await problems()).toContain('there is no lime.py');
  });

  it('is told what was left in English, and what would end a string', async () => {
    await put('line.py', "# Go on\nprint('Hello')\n");
    for (const language of ['fr', 'it']) await putWords(language, { 'Go on': 'Continue', Hello: 'Bonjour' });
    await putWords('de', { 'Go on': 'Go on', Hello: "Wie geht's" });
    expect((await wordProblems(folder)).map((line) => line.replace(/^.*: /, ''))).toEqual([
      '“Go on” is the same as English',
      "the program is broken by “Wie geht's”",
    ]);
  });
});

const robots = (await readdir('src/robots')).map((name) => `src/robots/${name}/examples`);
const courses = (await readdir('courses')).map((name) => `courses/${name}`);
const folders = [...courses, ...robots, 'src/my-robot/programs', 'scripts/robot-template/examples'].filter((it) =>
  existsSync(join(it, 'words')),
);

describe('the programs that come with the app', () => {
  it('have words in at least 25 folders', () => expect(folders.length).toBeGreaterThanOrEqual(25));

  it.each(folders)('are translated into every language in %s, without a text too many', async (folder) => {
    expect(await wordProblems(folder)).toEqual([]);
  });
});
