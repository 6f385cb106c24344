import { allTexts } from '../scripts/texts.mjs';
import { LANGUAGES, languages, type Language } from '../src/core/languages';
import type { App } from './app';

/** The texts of the app in one language: as they are, and as patterns where they have placeholders. */
interface Said {
  readonly whole: ReadonlySet<string>;
  readonly patterns: readonly RegExp[];
}

/** A text with fewer letters says nothing of its language: `max`, `Pin`. */
const LETTERS = 4;

/** Which languages have a text; each text is looked up once, since most are in sight at every look. */
type Lookup = (text: string) => ReadonlySet<Language>;

let lookup: Promise<Lookup> | undefined;

/** Reads every text of the app and its courses that has words of its own, by language. */
async function readTexts(): Promise<Lookup> {
  const entries = await allTexts();
  const saidIn = (language: Language): Said => {
    const texts = entries
      .map((entry) => squeezed(entry.texts[language] ?? ''))
      .filter((text) => (text.replace(PLACE, '').match(/\p{L}/gu) ?? []).length >= LETTERS);
    const withPlaces = texts.filter((text) => text.search(PLACE) >= 0);
    return { whole: new Set(texts), patterns: [...new Set(withPlaces)].map(patternOf) };
  };
  const said = LANGUAGES.map((language) => [language, saidIn(language)] as const);
  const known = new Map<string, ReadonlySet<Language>>();
  return (text) => {
    const found = known.get(text) ?? new Set(said.filter(([, texts]) => isSaid(text, texts)).map(([it]) => it));
    known.set(text, found);
    return found;
  };
}

const PLACE = /\{\w+\}/g;

/** A text whose places take any value. */
function patternOf(text: string): RegExp {
  const parts = text.split(PLACE).map((part) => part.replace(/[.*+?^${}()|[\]\\]/g, '\\$&'));
  return new RegExp(`^${parts.join('.+?')}$`, 'u');
}

const isSaid = (text: string, { whole, patterns }: Said): boolean =>
  whole.has(text) || patterns.some((pattern) => pattern.test(text));

/** As it is compared: with single spaces, the narrow ones before signs among them, and without marks of code. */
const squeezed = (text: string): string => text.replace(/\s+/g, ' ').replaceAll('`', '').trim();

/** Everything on the page that can be seen, and what screen readers say of it; the program is no text of ours. */
export async function wordsInSight(app: App): Promise<readonly string[]> {
  const found = await app.evaluate(() => {
    const isSeen = (element: Element): boolean =>
      element.checkVisibility({ opacityProperty: true, visibilityProperty: true }) &&
      element.closest('.cm-content, pre, code, style, script, [aria-hidden=true]') === null;
    const elements = Array.from(document.body.querySelectorAll('*')).filter(isSeen);
    return elements.flatMap((element) => {
      const nodes = Array.from(element.childNodes).filter(({ nodeType }) => nodeType === Node.TEXT_NODE);
      const said = ['aria-label', 'title', 'placeholder', 'alt'].map((name) => element.getAttribute(name) ?? '');
      return [...nodes.map(({ textContent }) => textContent ?? ''), ...said];
    });
  });
  return [...new Set(found.map(squeezed))].filter((text) => text.length >= LETTERS);
}

/** Texts on the page that are one of the app's in another language and none in this one. */
export async function wordsOfOthers(app: App, language: Language): Promise<readonly string[]> {
  const saying = await (lookup ??= readTexts());
  const names: readonly string[] = Object.values(languages).map(({ name }) => name); // each is called as it calls itself
  const seen = (await wordsInSight(app)).filter((text) => !names.includes(text));
  return seen.filter((text) => saying(text).size > 0 && !saying(text).has(language));
}
