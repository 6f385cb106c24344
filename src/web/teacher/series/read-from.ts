import { parseSeries } from '#check/series/read-series';
import { seriesLimits } from '#check/series/series';
import { isSeriesLink } from '#check/series/series-link';
import { documentOfSeriesLink } from '#intake/address';
import { readTasks } from '#intake/read-files';
import { seriesDocument } from '#intake/text';

import { t } from '../../kit/i18n';
import type { WithLate } from '../../kit/state/late-models';
import { decodedAddress, fetchOwn, pageAddress, type Fetched } from '../../exchange/share/own-server';
import { shownAndKept, type FoundSeries } from '../../exchange/share/open-series';
import shareWords from '../../exchange/share/words';
import { reopenSeries, storedSeriesAt } from '../../session/task/series/kept-series';
import { urlOf } from '../../session/visit/address';
import { readyScene } from '../../session/work/catalogue/ready-courses';
import words from './words';

/**
 * Finds the series of a page's address: in a link that holds it, on the web server that the page comes from, or stored
 * in this browser. A series that is found is stored. What pupils must not see is left out, whatever the file holds.
 *
 * @param from the address behind `#`: `s=…`, `series=ADDRESS`, `series/ID`
 */
export async function findSeries(app: WithLate, from: string): Promise<FoundSeries> {
  if (isSeriesLink(from)) return shownAndKept(app, documentOfSeriesLink(from, readyScene));
  if (from.startsWith('series=')) return fetchSeries(app, decodedAddress(from.slice('series='.length)));
  const series = await reopenSeries(app, from.slice('series/'.length));
  return series === null ? { problem: t(words.notKept) } : { series };
}

/**
 * Fetches a series from the page's own web server. If that fails, the series that was stored from this address takes its
 * place.
 */
async function fetchSeries(app: WithLate, given: string): Promise<FoundSeries> {
  const loaded = await fetchOwn(given, pageAddress(), seriesLimits.characters);
  if ('fault' in loaded) {
    const url = urlOf(given, pageAddress());
    const isAway = loaded.fault === 'notThere' || loaded.fault === 'notReached' || loaded.fault === 'tooLarge';
    const series = isAway && url !== null ? await storedSeriesAt(url.href) : null;
    return series === null ? { problem: faultText(loaded) } : { series, isOld: true };
  }
  const document = seriesDocument(parseSeries(loaded.text, readyScene));
  if (document.kind === 'unreadable') return shownAndKept(app, document);
  const series = await readTasks(document.series, async (file) => {
    const beside = await fetchOwn(file, loaded.url, seriesLimits.characters);
    return 'fault' in beside ? { problem: faultText(beside) } : beside;
  });
  return shownAndKept(app, { ...document, series }, loaded.url);
}

const faultText = ({ fault, values }: Exclude<Fetched, { readonly text: string }>): string =>
  fault === 'tooLarge' ? t(shareWords.series.faults['too-large']) : t(words[fault], values);
