import type { Language } from '#core/languages';
import { filledIn, wordsOf } from '#core/words';
import type { Reason, Remark } from '../result';
import type de from './words/de.json';

export const reportWords = wordsOf(import.meta.glob<typeof de>('./words/*.json', { eager: true, import: 'default' }));

/** A sentence about why a check does not hold. */
export const reasonText = ({ code, params }: Reason, language: Language): string =>
  filledIn(reportWords.reasons[code][language], params);

/** A sentence about something that the teacher is told. */
export const remarkText = ({ code, params }: Remark, language: Language): string =>
  filledIn(reportWords.remarks[code][language], params);
