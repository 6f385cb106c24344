import { parseSeries } from '#check/series/read-series';
import { seriesLimits } from '#check/series/series';
import { isSeriesLink } from '#check/series/series-link';
import { documentOfSeriesLink } from '#intake/address';
import { readTasks } from '#intake/read-files';
import { seriesDocument } from '#intake/text';

import { t } from '../../kit/i18n';
import type { WithLate } from '../../kit/state/late-models';
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
  if (from.startsWith('series=')) return fetchSeries(app, decoded(from.slice('series='.length)));
  const series = await reopenSeries(app, from.slice('series/'.length));
  return series === null ? { problem: t(words.notKept) } : { series };
}

/**
 * Fetches a series from the page's own web server alone: its content policy lets it reach no other. If that fails, the
 * series that was stored from this address takes its place.
 */
async function fetchSeries(app: WithLate, given: string): Promise<FoundSeries> {
  const url = urlOf(given, location.href.replace(/#.*/, ''));
  if (url === null) return { problem: t(words.badAddress, { address: given }) };
  if (!/^https?:$/.test(location.protocol)) return { problem: t(words.noServer) };
  if (url.origin !== location.origin) return { problem: t(words.foreign, { host: url.host || given }) };
  const loaded = await textAt(url);
  if ('problem' in loaded) {
    const series = await storedSeriesAt(url.href);
    return series === null ? { problem: loaded.problem } : { series, isOld: true };
  }
  const document = seriesDocument(parseSeries(loaded.text, readyScene));
  if (document.kind === 'unreadable') return shownAndKept(app, document);
  const series = await readTasks(document.series, async (file) => {
    const place = urlOf(file, url.href);
    if (place === null || place.origin !== url.origin)
      return { problem: t(words.foreign, { host: place?.host ?? file }) };
    return textAt(place);
  });
  return shownAndKept(app, { ...document, series }, url.href);
}

async function textAt(url: URL): Promise<{ readonly text: string } | { readonly problem: string }> {
  const address = url.pathname;
  try {
    const response = await fetch(url, { cache: 'no-cache' });
    if (!response.ok) return { problem: t(words.notThere, { address, status: response.status }) };
    const text = await response.text();
    return text.length > seriesLimits.characters ? { problem: t(shareWords.series.faults['too-large']) } : { text };
  } catch {
    return { problem: t(words.notReached, { address }) };
  }
}

/** Decodes an address; one that was written plainly may have a `%` of its own. */
function decoded(text: string): string {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}
