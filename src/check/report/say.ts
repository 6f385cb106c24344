import type { Language } from '#core/languages';
import { filledIn, wordsOf } from '#core/words';
import { unreadCodes } from '../hand-in/unread';
import type { Reason, Remark } from '../result';
import type de from './words/de.json';

export const reportWords = wordsOf(import.meta.glob<typeof de>('./words/*.json', { eager: true, import: 'default' }));

/** Why a check does not hold: a sentence, and what there is to say of the run besides. */
export function reasonText({ code, params }: Reason, language: Language): string {
  const { reasons, more } = reportWords;
  const besides = (['near', 'limit'] as const).filter((name) => params[name] !== undefined);
  return [reasons[code], ...besides.map((name) => more[name])]
    .map((words) => filledIn(words[language], params))
    .join(' ');
}

/** A sentence about something that the teacher is told. */
export function remarkText({ code, params }: Remark, language: Language): string {
  const why = unreadCodes.find((one) => one === params['why']);
  const problem = why && filledIn(reportWords.unread[why][language], params);
  return filledIn(reportWords.remarks[code][language], problem === undefined ? params : { problem });
}
