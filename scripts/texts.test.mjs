import { describe, expect, it } from 'vitest';
import { problemsOf } from './texts.mjs';

const same = { fr: new Set(['radio']), it: new Set(['radio']) };
const languages = ['de', 'fr', 'it', 'en'].map((language) => `  ${language}: { name: '…' },`).join('\n');
const problems = (files) => problemsOf(new Map(Object.entries({ 'src/core/languages.ts': languages, ...files })), same);

/** A text in its languages, as a part has it that names all its texts. */
const inWords = (texts) => ({
  ...Object.fromEntries(
    Object.entries(texts).map(([language, title]) => [`src/a/words/${language}.json`, JSON.stringify({ title })]),
  ),
  'src/a/wall.ts': "import words from './words';\nsay(words.title);",
});
const good = { de: 'Wand', fr: 'Mur', it: 'Muro', en: 'Wall' };
const found = (texts) => problems(inWords({ ...good, ...texts })).join('\n');

/** The texts of the first page with one text each, and a component that shows it. */
const catalogues = (english) => ({
  'src/web/kit/words/de.json': '{ "bar": { "stop": "Stopp" } }',
  'src/web/kit/words/fr.json': '{ "bar": { "stop": "Arrêter" } }',
  'src/web/kit/words/it.json': '{ "bar": { "stop": "Ferma" } }',
  'src/web/kit/words/en.json': `{ "bar": { ${english} } }`,
});
const button = {
  'src/web/Stop.vue': '<script setup lang="ts">\n</script>\n<template>{{ t(\'bar.stop\') }}</template>',
};

describe('a text', () => {
  it('is all right in four languages', () => {
    expect(found({})).toBe('');
  });

  it('is told where it stands when a language is missing', () => {
    const { fr: _, it: __, ...two } = good;
    expect(problems(inWords(two))).toEqual(['src/a/words/*.json title: no text in fr, it']);
  });

  it('has the same places for values in every language', () => {
    expect(found({ de: '{cm} cm', fr: '{mm} cm', it: '{cm} cm', en: '{cm} cm' })).toContain('fr has the places {mm}');
  });

  it('may not be the English one, unless the word is the same: radio', () => {
    expect(found({ fr: 'Wall' })).toContain('fr is the same as English: Wall');
    expect(found({ de: 'Funk', fr: 'Radio', it: 'Radio', en: 'Radio' })).toBe('');
    expect(found({ de: '{cm} cm', fr: '{cm} cm', it: '{cm} cm', en: '{cm} cm' })).toBe('');
  });

  it('is spelled the Swiss way in German and with narrow spaces in French', () => {
    expect(found({ de: 'Straße' })).toContain('ß in German');
    expect(found({ fr: 'Un mur ?' })).toContain('a wide space before a sign');
    expect(found({ fr: 'Un mur\u202f?' })).toBe('');
  });

  it('is told with the right word where it says one that is refused for a thing', () => {
    expect(found({ fr: 'Créer un exercice' })).toBe(
      'src/a/words/*.json title: “exercice” is called “tâche” in fr: Créer un exercice',
    );
    expect(found({ fr: 'Créer une tâche' })).toBe('');
  });

  it('stands in no source', () => {
    const source = "const words = {\n  title: { de: 'Wand', en: 'Wall' },\n};\nsay(words.title);";
    expect(problems({ 'src/web/a.ts': source })).toEqual(['src/web/a.ts:2: texts stand in words/<language>.json']);
    expect(problems({ 'src/a.ts': 'const source = { de: german, en: english };' })).toEqual([]);
  });
});

describe('the handbook', () => {
  const path = 'src/web/help/handbook/texts/fr.md';

  it('says the words of the page, and is told by its lines', () => {
    const book = `<!-- une note\nsur deux lignes -->\n# draw: Dessiner\n\nPosez une arrivée dans le champ.\n`;
    expect(problems({ [path]: book })).toEqual([
      `${path}:5: “champ” is called “zone” in fr: Posez une arrivée dans le champ.`,
    ]);
  });

  it('says «vous» to teachers and «tu» to the class', () => {
    expect(problems({ [path]: '# draw: Dessiner\n\nDessine ta ligne.' })).toHaveLength(1);
    expect(problems({ [path]: '# draw: Dessiner\n\nDessinez votre ligne.' })).toEqual([]);
    expect(problems({ [path]: '# class: Pour la classe\n\nDessine ta ligne.' })).toEqual([]);
  });
});

describe('the words of a part', () => {
  const part = (texts) =>
    Object.fromEntries(Object.entries(texts).map(([language, text]) => [`src/a/words/${language}.json`, text]));
  const files = part({
    de: '{ "title": "Wand", "kinds": { "block": "Block {id}" } }',
    fr: '{ "title": "Mur", "kinds": { "block": "Bloc {id}" } }',
    it: '{ "title": "Muro", "kinds": { "block": "Blocco {id}" } }',
    en: '{ "title": "Wall", "kinds": { "block": "Block no. {id}" } }',
  });
  const reader = { 'src/a/wall.ts': "import words from './words';\nsay(words.title);" };
  const user = { 'src/b.ts': "import wallWords from './a/words';\nsay(wallWords.kinds[kind]);" };

  it('are all right in four languages, each of them read', () => {
    expect(problems({ ...files, ...reader, ...user })).toEqual([]);
  });

  it('may not lack a text, nor have one more', () => {
    const other = part({ it: '{ "title": "Muro", "kind": { "block": "Blocco {id}" } }' });
    expect(problems({ ...files, ...other, ...reader, ...user })).toEqual([
      'src/a/words/*.json kinds.block: no text in it',
      'src/a/words/*.json kind.block: no text in de, fr, en',
      'src/a/words/*.json kind.block: used nowhere',
    ]);
  });

  it('may not be in a language that the app does not have', () => {
    expect(problems({ ...files, ...part({ rm: '{ "title": "Mir" }' }), ...reader, ...user })).toEqual([
      'src/a/words/*.json title: rm is no language of src/core/languages.ts',
    ]);
  });

  it('are looked at one by one: places, words left in English, signs', () => {
    const other = part({ fr: '{ "title": "Wall", "kinds": { "block": "Bloc" } }' });
    expect(problems({ ...files, ...other, ...reader, ...user })).toEqual([
      'src/a/words/*.json title: fr is the same as English: Wall',
      'src/a/words/*.json kinds.block: fr has the places (none), German {id}',
    ]);
  });

  it('are followed through a name for some of them', () => {
    const some = "import wallWords from './a/words';\nconst kinds = wallWords.kinds;\nsay(kinds.";
    expect(problems({ ...files, ...reader, 'src/b.ts': `${some}block);` })).toEqual([]);
    expect(problems({ ...files, ...reader, 'src/b.ts': `${some}wall);` })).toEqual([
      'src/a/words/*.json kinds.block: used nowhere',
    ]);
  });

  it('count as used if they are found by language', () => {
    const byName = "import type de from './words/de.json';\nexport const load = byLanguage(files);";
    expect(problems({ ...files, 'src/a/wall.ts': byName })).toEqual([]);
  });

  it('may not have a text that nobody names', () => {
    expect(problems({ ...files, ...reader })).toEqual(['src/a/words/*.json kinds.block: used nowhere']);
    expect(problems(files)).toEqual(['src/a/words/*.json: no source reads it']);
  });
});

describe('the catalogues', () => {
  it('are all right with the same keys, each of them shown', () => {
    expect(problems({ ...catalogues('"stop": "Stop"'), ...button })).toEqual([]);
  });

  it('may not lack a key', () => {
    expect(problems({ ...catalogues(''), ...button })).toEqual(['src/web/kit/words/*.json bar.stop: no text in en']);
  });

  it('may not have a key more', () => {
    expect(problems({ ...catalogues('"stop": "Stop", "go": "Go"'), ...button })[0]).toContain(
      'bar.go: no text in de, fr',
    );
  });

  it('may not have a key that nobody shows', () => {
    expect(problems(catalogues('"stop": "Stop"'))).toEqual(['src/web/kit/words/*.json bar.stop: used nowhere']);
  });

  it('count a key as shown that is put together: bar.${id}', () => {
    const made = { 'src/web/a.ts': 'const label = t(`bar.${id}`);' };
    expect(problems({ ...catalogues('"stop": "Stop"'), ...made })).toEqual([]);
  });
});

describe('the texts of a course', () => {
  it('are its name, what it is about and its task, in four languages', () => {
    const words = (language, texts) => ({ [`courses/a/words/${language}.json`]: JSON.stringify(texts) });
    const files = [
      words('de', { name: 'Tor', text: 'Ein Tor.', task: 'Fahr durch das Tor.' }),
      words('fr', { name: 'Porte', text: 'Une porte.', task: 'Passe la porte.' }),
      words('it', { name: 'Porta', text: 'Una porta.', task: 'Attraversa la porta.' }),
      words('en', { name: 'Gate', text: 'A gate.' }),
    ];
    expect(problems(Object.assign({}, ...files))).toEqual(['courses/a/words/*.json task: no text in en']);
  });
});
