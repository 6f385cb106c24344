import { defineAsyncComponent, type AsyncComponentLoader, type AsyncComponentOptions, type Component } from 'vue';

/** Name of the event of a view that did not come. Its detail asks for it again. */
export const MISSED_VIEW = 'parcours:missed-view';

/**
 * A component whose code is loaded when it is first drawn. Where that fails its place stays empty, and the page is told: it
 * asks again on request, or when the connection is back (`noticeMissingParts`).
 */
export const lateView = <T extends Component>(
  loader: AsyncComponentLoader<T>,
  meanwhile: Pick<AsyncComponentOptions, 'loadingComponent' | 'delay'> = {},
): T =>
  defineAsyncComponent<T>({
    ...meanwhile,
    loader,
    onError(_error, retry, fail) {
      const isUnheard = dispatchEvent(new CustomEvent(MISSED_VIEW, { detail: retry, cancelable: true }));
      if (isUnheard) fail();
    },
  });
