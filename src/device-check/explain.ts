import type { Finding } from './finding';
import { de } from './texts/de';
import { en } from './texts/en';
import type { RuleTexts } from './texts/texts';

/** The languages that findings are explained in. */
export type CheckLanguage = 'de' | 'en';

const catalogues: Readonly<Record<CheckLanguage, RuleTexts>> = { de, en };

/**
 * One or two sentences about a finding that a pupil understands: what is missing, and the way out.
 *
 * @param board what the board is called: `micro:bit V2`
 */
export function explain({ rule, name, instead }: Finding, board: string, language: CheckLanguage): string {
  const values: Readonly<Record<string, string>> = { board, name, instead };
  return catalogues[language][rule].replace(/\{(\w+)\}/g, (_whole, key: string) => values[key] ?? '');
}
