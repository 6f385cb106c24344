import { arrival } from '../../../kit/state/arrival';
import { loadErrorTexts } from '../../../kit/i18n';
import { fetchedOnce } from '#core/memo';
import type { Advice, adviceFor as AdviceFor, ErrorReport } from './error-advice';

/** The knowledge about errors. It is fetched with the first run, not when the page opens. */
const advice = arrival<typeof AdviceFor>();

/**
 * Fetches the code and words that explain errors, unless they are there. Never rejects: without a connection errors
 * stay unexplained.
 */
export function fetchAdvice(): Promise<void> {
  return fetchOnce().catch(() => undefined); // the next error asks again
}
const fetchOnce = fetchedOnce(async () => {
  const [late] = await Promise.all([import('./error-advice'), loadErrorTexts()]);
  advice.set(late.adviceFor);
});

/**
 * The explanation of an exception for pupils (see `adviceFor`). Until that is fetched, only the device's words. A
 * template that reads it is rendered again then.
 */
export function explain({ failure, source, table }: ErrorReport): Advice {
  if (advice.value !== null) return advice.value(failure, source, table);
  const { type, message } = failure;
  return { key: 'error.other', values: {}, device: message === '' ? type : `${type}: ${message}` };
}
