import files from 'virtual:word-files';
import type { Language, Texts } from '#core/languages';

/** The loaders of the files of words, by group and language. A file holds the texts of each of the group's parts. */
export type WordFiles = typeof files;

/** The names of a part's texts, with a 0 for each. */
type Shape = 0 | { readonly [name: string]: Shape };
type Tree = Texts | { readonly [name: string]: Tree };

/** A text in the languages that have come. */
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
  /** By group and language, what each part says. */
  const come = new Map<string, readonly (readonly string[])[]>();
  const coming = new Map<string, Promise<void>>();
  let wanted: Language = 'de';

  /** The words of a part. They are complete before the part is shown, in the language that is wanted. */
  function wordsOfPart(group: string, at: number, shape: Shape): Tree {
    const texts: Text[] = [];
    const part = { group, at, texts };
    const tree = treeOf(shape, texts);
    parts.push(part);
    for (const language of Object.keys(files[group] ?? {}) as Language[]) fill(part, language);
    return tree;
  }

  function fill({ group, at, texts }: Part, language: Language): void {
    const said = come.get(`${group} ${language}`)?.[at] ?? [];
    for (const [index, text] of said.entries()) Object.assign(texts[index] ?? {}, { [language]: text });
  }

  /** Fetches the words of all parts that are there, in a language. Rejects without a connection; another call tries again. */
  async function loadWords(language: Language): Promise<void> {
    const groups = new Set(parts.map(({ group }) => group));
    await Promise.all([...groups].map((group) => loadGroup(group, language)));
  }

  /** Fetches the words of all parts that are there, and from now on of those that come. */
  function wantWords(language: Language): Promise<void> {
    wanted = language;
    return loadWords(language);
  }

  function loadGroup(group: string, language: Language): Promise<void> {
    const key = `${group} ${language}`;
    const loading = coming.get(key) ?? fetchGroup(group, language);
    coming.set(key, loading);
    loading.catch(() => coming.delete(key));
    return loading;
  }

  async function fetchGroup(group: string, language: Language): Promise<void> {
    const file = await files[group]?.[language]();
    come.set(`${group} ${language}`, file?.wordTexts ?? []);
    for (const part of parts) if (part.group === group) fill(part, language);
  }

  /** What an `import()` gives, once the words that it brought are there. The build puts this around each. */
  async function withWords<T>(imported: Promise<T>): Promise<T> {
    const part = await imported;
    const isWords = typeof part === 'object' && part !== null && 'wordTexts' in part;
    if (!isWords) await loadWords(wanted);
    return part;
  }

  return { wordsOfPart, loadWords, wantWords, withWords };
}

function treeOf(shape: Shape, texts: Text[]): Tree {
  if (shape !== 0) return Object.fromEntries(Object.entries(shape).map(([name, it]) => [name, treeOf(it, texts)]));
  const text: Text = {};
  texts.push(text);
  return text as Texts;
}

export const { wordsOfPart, loadWords, wantWords, withWords } = openWordFiles(files);
