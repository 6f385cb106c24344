import type { Language } from '#core/texts';
import type { RuleTexts } from './texts';

/** What is said of the rules, by language: only the one that is asked for is fetched. */
const catalogues: Readonly<Record<Language, () => Promise<RuleTexts>>> = {
  de: async () => (await import('./de')).de,
  fr: async () => (await import('./fr')).fr,
  it: async () => (await import('./it')).it,
  en: async () => (await import('./en')).en,
};

/** The sentences about findings in a language. Fails where it cannot be fetched; another call tries again. */
export const loadRuleTexts = (language: Language): Promise<RuleTexts> => catalogues[language]();
