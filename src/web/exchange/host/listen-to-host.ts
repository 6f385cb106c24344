import { onMounted, onScopeDispose } from 'vue';
import type { HostedPage } from './hosted-page';

import { fetchAgain } from './fetch-again';
import { latePart } from '../../kit/late-part';

/** Most messages kept until the code that understands them is loaded. Chosen: more than any host sends by then. */
const MOST_EARLY = 200;

const early: MessageEvent<unknown>[] = [];
const keep = (event: MessageEvent<unknown>): void => {
  if (event.source === window.parent && early.length < MOST_EARLY) early.push(event);
};

/**
 * Keeps messages of the embedding page until the app listens. Call it at once: hosts speak after the frame's `load`,
 * which waits neither for the texts of the language nor for the pupil's own work.
 */
export function keepEarlyMessages(): void {
  if (window.parent !== window) addEventListener('message', keep);
}

/**
 * Lets the embedding page send commands. The code of the dialects is fetched only in a frame; no earlier message is
 * lost.
 */
export function listenToHost(app: HostedPage): void {
  if (window.parent === window) return;
  let close = (): void => undefined;
  keepEarlyMessages();
  onMounted(() => {
    void fetchAgain(() => import('./frame'))
      .then(({ openFrame }) => {
        removeEventListener('message', keep);
        close = openFrame(app, early.splice(0));
      })
      .catch(() => app.notices.show(latePart));
  });
  onScopeDispose(() => {
    removeEventListener('message', keep);
    close();
  });
}
