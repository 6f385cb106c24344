import { filledIn } from '#core/words';
import type { Finding } from './finding';
import type { RuleTexts } from './rule-texts';

/**
 * Explains a finding to a pupil in one or two sentences: what is missing, and the way out.
 *
 * @param board what the board is called: `micro:bit V2`
 * @param texts the sentences in the pupil's language, see `loadRuleTexts`
 */
export function explain({ rule, name, instead }: Finding, board: string, texts: RuleTexts): string {
  return filledIn(texts[rule], { board, name, instead });
}
