import { describe, expect, it } from 'vitest';
import { problemsOf } from './texts.mjs';

const same = { fr: new Set(['radio']), it: new Set(['radio']) };
const problems = (files) => problemsOf(new Map(Object.entries(files)), same);

/** A text in its languages as it stands in a source. */
const inline = (texts) => `const words = ${JSON.stringify({ title: texts })};\nsay(words.title);\n`;
const good = { de: 'Wand', fr: 'Mur', it: 'Muro', en: 'Wall' };
const found = (texts) => problems({ 'src/web/a.ts': inline({ ...good, ...texts }) }).join('\n');

/** The catalogues of the app with one text each, and a component that shows it. */
const catalogues = (english) => ({
  'src/web/page/i18n/de.ts': "export const de = { bar: { stop: 'Stopp' } } as const;",
  'src/web/page/i18n/fr.ts': "export const fr: Texts = { bar: { stop: 'Arrêter' } };",
  'src/web/page/i18n/it.ts': "export const it: Texts = { bar: { stop: 'Ferma' } };",
  'src/web/page/i18n/en.ts': `export const en: Texts = { bar: { ${english} } };`,
});
const button = {
  'src/web/Stop.vue': '<script setup lang="ts">\n</script>\n<template>{{ t(\'bar.stop\') }}</template>',
};

describe('a text that brings its languages along', () => {
  it('is all right in four languages', () => {
    expect(found({})).toBe('');
  });

  it('is told where it stands when a language is missing', () => {
    const two = "\nconst words = { title: { de: 'Wand', en: 'Wall' } };\nsay(words.title);";
    expect(problems({ 'src/web/a.ts': two })).toEqual(['src/web/a.ts:2: no text in fr, it']);
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

  it('is not mixed up with a program or a function in each language', () => {
    expect(problems({ 'src/a.ts': 'const source = { de: german, en: english };' })).toEqual([]);
  });

  it('is told when nobody shows it', () => {
    const idle = `export const words = ${JSON.stringify({ title: good, idle: good })};`;
    const shown = {
      'src/web/B.vue': "<script setup>\nimport { words as own } from './a';\n</script>\n{{ own.title }}",
    };
    expect(problems({ 'src/web/a.ts': idle, ...shown })).toEqual(['src/web/a.ts words.idle: used nowhere']);
    const late = { 'src/web/b.ts': "const { words } = await import('./a'); show(words.idle, words.used);" };
    expect(problems({ 'src/web/a.ts': idle, ...shown, ...late })).toEqual([]);
  });
});

describe('the catalogues', () => {
  it('are all right with the same keys, each of them shown', () => {
    expect(problems({ ...catalogues("stop: 'Stop'"), ...button })).toEqual([]);
  });

  it('may not lack a key', () => {
    expect(problems({ ...catalogues(''), ...button })).toEqual(['src/web/page/i18n/*.ts bar.stop: no text in en']);
  });

  it('may not have a key more', () => {
    expect(problems({ ...catalogues("stop: 'Stop', go: 'Go'"), ...button })[0]).toContain('bar.go: no text in de, fr');
  });

  it('may not have a key that nobody shows', () => {
    expect(problems(catalogues("stop: 'Stop'"))).toEqual(['src/web/page/i18n/*.ts bar.stop: used nowhere']);
  });

  it('count a key as shown that is put together: bar.${id}', () => {
    const made = { 'src/web/a.ts': 'const label = t(`bar.${id}`);' };
    expect(problems({ ...catalogues("stop: 'Stop'"), ...made })).toEqual([]);
  });
});

describe('the texts of a course', () => {
  it('are its name, what it is about and its task, in four languages', () => {
    const own = { name: 'A', text: 'B', task: 'C' };
    const texts = { place: 1, de: own, fr: own, it: own, en: { name: 'A', text: 'B' } };
    expect(problems({ 'courses/a/texts.json': JSON.stringify(texts) })).toEqual([
      'courses/a/texts.json task: no text in en',
    ]);
  });
});
