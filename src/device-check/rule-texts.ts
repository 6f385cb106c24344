import type { Language } from '#core/languages';
import { byLanguage } from '#core/words';
import type { RuleId } from './rule-table';
import type de from './words/de.json';

/**
 * The sentence for each rule: what is missing, then the way out. `{board}` is the board's name, `{name}` what is
 * written in the program, `{instead}` code that does it on the device.
 */
export type RuleTexts = Readonly<Record<RuleId, string>>;

/** The sentences by language; only the chosen one is fetched. */
const catalogues = byLanguage(import.meta.glob<typeof de>('./words/*.json', { import: 'default' }));

/** The sentences about findings in a language. Fails where it cannot be fetched; another call tries again. */
export const loadRuleTexts = (language: Language): Promise<RuleTexts> => catalogues[language]();
