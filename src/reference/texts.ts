import type { Language } from '#core/languages';
import { byLanguage } from '#core/words';
import type { RobotReference } from './types';
import type de from './words/de.json';

/** Short words on names of the API, by the names' keys: `microbit.display.show`. */
export type ReferenceTexts = Readonly<Record<string, string>>;

const catalogues = byLanguage(import.meta.glob<typeof de>('./words/*.json', { import: 'default' }));

/** The words on every name of the boards' modules and of the language, fetched in one language. Rejects without a connection. */
export const loadReferenceTexts = (language: Language): Promise<ReferenceTexts> => catalogues[language]();

/** The same, and the words on the names of these libraries. */
export async function loadTextsWith(
  language: Language,
  libraries: readonly Pick<RobotReference, 'texts'>[],
): Promise<ReferenceTexts> {
  const texts = await loadReferenceTexts(language);
  return Object.assign({}, texts, ...libraries.map((library) => textsOfRobot(library, language))) as ReferenceTexts;
}

/** The words on the names of a robot's libraries, in one language. */
export const textsOfRobot = ({ texts }: Pick<RobotReference, 'texts'>, language: Language): ReferenceTexts =>
  Object.fromEntries(Object.entries(texts).map(([key, text]) => [key, text[language]]));
