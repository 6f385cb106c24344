import files from 'virtual:word-files';
import type { Language, Texts } from '#core/languages';

/** The loaders of the files of words, by group and language. A file holds the texts of each of the group's parts. */
export type WordFiles = typeof files;

/** The names of a part's texts, with a 0 for each. */
type Shape = 0 | { readonly [name: string]: Shape };
type Tree = Texts | { readonly [name: string]: Tree };

/** A text in the languages that are loaded. */
type Text = { -readonly [L in keyof Texts]?: Texts[L] };

interface Part {
  readonly group: string;
  /** Its place in the files of the group. */
  readonly at: number;
  readonly texts: readonly Text[];
}

/**
 * The words of the page's parts, as its build makes them (`build/words.ts`): a part names its texts, and they come in files,
 * one for each group of parts and each language, so that a visitor fetches one language. Where the build leaves all
 * languages in the parts (tests, the single file), there are no files, and nothing to wait for.
 */
export function openWordFiles(files: WordFiles) {
  const parts: Part[] = [];
  const { textsOf, load } = fetchedOnce(files, (group, language) => {
    for (const part of parts) if (part.group === group) fill(part, language);
  });
  /** The language that is shown, and the one that was chosen last: parts that come late have both. `null`: none yet. */
  let shown: Language | null = null;
  let wanted: Language | null = null;

  /** The words of a part. They are complete before the part is shown, in the language that is shown. */
  function wordsOfPart(group: string, at: number, shape: Shape): Tree {
    const texts: Text[] = [];
    const part = { group, at, texts };
    const tree = treeOf(shape, texts);
    parts.push(part);
    for (const language of Object.keys(files[group] ?? {}) as Language[]) fill(part, language);
    return tree;
  }

  function fill({ group, at, texts }: Part, language: Language): void {
    for (const [index, text] of (textsOf(group, language)[at] ?? []).entries())
      Object.assign(texts[index] ?? {}, { [language]: text });
  }

  /** Fetches the words of all parts that are there, in a language. Rejects without a connection; another call tries again. */
  async function loadWords(language: Language): Promise<void> {
    const groups = new Set(parts.map(({ group }) => group));
    await Promise.all([...groups].map((group) => load(group, language)));
  }

  /**
   * Chooses the language of the parts that are there and of those that come. Rejects without a connection; then all stays.
   *
   * @returns whether it is to be shown now; `false`: another one was chosen meanwhile
   */
  async function chooseLanguage(language: Language): Promise<boolean> {
    wanted = language;
    try {
      await loadWords(language);
    } catch (error) {
      if (wanted === language) wanted = shown;
      throw error;
    }
    if (wanted !== language) return false;
    shown = language;
    return true;
  }

  /** The result of an `import()`, once the words that it brought are there. The build wraps each one in this. */
  async function withWords<T>(imported: Promise<T>): Promise<T> {
    const part = await imported;
    const isWords = typeof part === 'object' && part !== null && 'wordTexts' in part;
    const languages = [shown, wanted].filter((language) => language !== null);
    if (!isWords) await Promise.all(languages.map(loadWords));
    return part;
  }

  return { wordsOfPart, loadWords, chooseLanguage, withWords };
}

/** The texts in the files, by group and language; each file is fetched once. @param onCome its texts are there */
function fetchedOnce(files: WordFiles, onCome: (group: string, language: Language) => void) {
  const come = new Map<string, readonly (readonly string[])[]>();
  const coming = new Map<string, Promise<void>>();
  async function fetchTexts(group: string, language: Language): Promise<void> {
    const file = await files[group]?.[language]();
    come.set(`${group} ${language}`, file?.wordTexts ?? []);
    onCome(group, language);
  }
  function load(group: string, language: Language): Promise<void> {
    const key = `${group} ${language}`;
    const loading = coming.get(key) ?? fetchTexts(group, language);
    coming.set(key, loading);
    loading.catch(() => coming.delete(key));
    return loading;
  }
  /** The texts of each part of the group, as far as its file is loaded. */
  const textsOf = (group: string, language: Language) => come.get(`${group} ${language}`) ?? [];
  return { textsOf, load };
}

function treeOf(shape: Shape, texts: Text[]): Tree {
  if (shape !== 0) return Object.fromEntries(Object.entries(shape).map(([name, it]) => [name, treeOf(it, texts)]));
  const text: Text = {};
  texts.push(text);
  return text as Texts;
}

export const { wordsOfPart, loadWords, chooseLanguage, withWords } = openWordFiles(files);
