import { unreadText } from '#check/report/say';
import type { Unread } from '#check/series/series';
import type { Unreadable } from '#intake/document';

import { shownLanguage, t } from '../../kit/i18n';
import { linkReason, reasonOf } from './problem-words';
import shareWords from './words';

/** Why a file or a link cannot be read, in words. */
export function unreadableReason({ seriesLink, link, problems, problem }: Unreadable): string {
  if (seriesLink !== undefined) return t(shareWords.series.faults[seriesLink]);
  if (link !== undefined) return linkReason(link);
  return problems.length > 0 ? reasonOf(problems) : unreadText(problem, shownLanguage());
}

/** Why a task of a series cannot be read. */
export const unreadReason = ({ said, problems }: Unread): string => said ?? reasonOf(problems);
