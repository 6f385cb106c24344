import { LANGUAGES, type Language } from '#core/languages';

/** The same short texts in every language, by key. */
export type Catalogues = Readonly<Record<Language, Readonly<Record<string, string>>>>;

/**
 * Everything that is wrong between the languages of some short texts, one line each; empty when all is well: keys that
 * are missing or too many, names and numbers that differ from the German ones, texts that are still English, and signs
 * that a language does not write.
 *
 * @param alike keys of texts that are rightly the same in English and another language
 */
export function mistakesIn(catalogues: Catalogues, alike: readonly string[] = []): string[] {
  const keys = Object.keys(catalogues.de);
  return LANGUAGES.flatMap((language) => [
    ...keyMistakes(keys, catalogues[language]).map((mistake) => `${language}: ${mistake}`),
    ...keys.flatMap((key) => {
      const text = catalogues[language][key];
      if (text === undefined) return [];
      const mistakes = [...textMistakes(text, catalogues.de[key] ?? ''), ...signMistakes(text, language)];
      const isEnglish = language !== 'en' && text === catalogues.en[key] && !alike.includes(key);
      if (isEnglish) mistakes.push('is the English text');
      return mistakes.map((mistake) => `${language}: ${key}: ${mistake}`);
    }),
  ]);
}

function keyMistakes(keys: readonly string[], texts: Readonly<Record<string, string>>): string[] {
  return [
    ...keys.filter((key) => !(key in texts)).map((key) => `${key} is missing`),
    ...Object.keys(texts)
      .filter((key) => !keys.includes(key))
      .map((key) => `${key} is too many`),
  ];
}

/** Finds faults in what must be equal in every language: names with a dot, a bracket or an underscore, and numbers. */
function textMistakes(text: string, german: string): string[] {
  const [said, wanted] = [codeIn(text), codeIn(german)];
  return said === wanted ? [] : [`says “${said}” where German says “${wanted}”`];
}

/** Placeholders, names and numbers of a text, sorted. The pupil's own variables are not among them: they may be translated. */
function codeIn(text: string): string {
  const names = text.match(/\{\w+\}|\b[A-Za-z_]\w*(?:\.[A-Za-z_]\w*)+\b|\b\w+(?=\()|\b\w+_\w*\b/g) ?? [];
  const numbers = text.match(/\d+/g) ?? [];
  return [...new Set(names), ...numbers].sort().join(' ');
}

/** An apostrophe between two letters, as in l’image. The b of b'abc' is Python. */
const STRAIGHT_APOSTROPHE = /(?<=\p{L})(?<!(?<!\p{L})b)'(?=\p{L})/u;

/** Signs by language: Swiss German has no ß, French has a narrow space before : ; ? ! and inside «…», others have none. */
function signMistakes(text: string, language: Language): string[] {
  const mistakes: string[] = [];
  if (text !== text.trim() || text.includes('  ')) mistakes.push('has a space too many');
  if (language === 'de' && text.includes('ß')) mistakes.push('has an ß');
  if (language === 'fr' && /[ \u00a0][:;?!»]|«[ \u00a0]/.test(text)) mistakes.push('has a wide space before a sign');
  if (language === 'fr' && /\p{L}[;?!]|\p{L}:(?= |$)/u.test(withoutCode(text))) mistakes.push('lacks a narrow space');
  if (language !== 'fr' && /[\s][:;?!»]|«\s/.test(text)) mistakes.push('has a space before a sign');
  if ((language === 'fr' || language === 'it') && STRAIGHT_APOSTROPHE.test(text))
    mistakes.push('has a straight apostrophe');
  return mistakes;
}

/** A text without what Python writes with a colon. */
const withoutCode = (text: string): string => text.replace(/lambda \w+:|\btry:|\w+:\./g, '');
