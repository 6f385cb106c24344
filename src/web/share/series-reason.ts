import type { SeriesProblem } from '#check/series/read-series';
import type { ReadSeriesLink } from '#check/series/series-link';
import type { Series, Unread } from '#check/series/series';
import type { ProjectProblem } from '#project/problem';

import { say } from '../page/i18n/say';
import { reasonOf } from './problem-words';
import { shareWords } from './share-words';

const isOfProjects = (problem: SeriesProblem): problem is ProjectProblem => problem.code !== 'not-a-series';

/** What is wrong with the file of a series, in words: the first problem, and how many follow. */
export function seriesReason(problems: readonly SeriesProblem[]): string {
  const known = problems.filter(isOfProjects);
  return known.length < problems.length ? say(shareWords.series.notASeries) : reasonOf(known);
}

/** Why a link opens no series, in words. */
export const seriesLinkReason = (read: Exclude<ReadSeriesLink, { readonly series: Series }>): string =>
  'fault' in read ? say(shareWords.series.faults[read.fault]) : seriesReason(read.problems);

/** Why a task cannot be read. */
export const unreadReason = ({ said, problems }: Unread): string => said ?? reasonOf(problems);
