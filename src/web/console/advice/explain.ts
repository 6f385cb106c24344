import { shallowRef } from 'vue';

import { loadErrorTexts } from '../../page/i18n';
import type { Advice, adviceFor as AdviceFor, ErrorReport } from './error-advice';

/** The knowledge about errors. It is fetched with the first run, not when the page opens. */
const adviceFor = shallowRef<typeof AdviceFor | null>(null);
let coming: Promise<void> | null = null;

/** Fetches what explains errors, unless it is there. Never rejects: without a connection errors stay unexplained. */
export function fetchAdvice(): Promise<void> {
  coming ??= Promise.all([import('./error-advice'), loadErrorTexts()]).then(
    ([late]) => {
      adviceFor.value = late.adviceFor;
    },
    () => {
      coming = null; // the next error asks again
    },
  );
  return coming;
}

/**
 * What a pupil should read about an exception (see `adviceFor`). Until that is fetched, only that there was one, in the
 * device's words. Read in templates, it is followed when more is known.
 */
export function explain({ failure, source, table }: ErrorReport): Advice {
  if (adviceFor.value !== null) return adviceFor.value(failure, source, table);
  const { type, message } = failure;
  return { key: 'error.other', values: {}, device: message === '' ? type : `${type}: ${message}` };
}
