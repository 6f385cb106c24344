import { effectScope, watch } from 'vue';

/** Has the browser ask before the page is left, as long as something would be lost with it, and only then. */
export function askBeforeLeaving(isUnsaved: () => boolean): void {
  const ask = (event: Event): void => event.preventDefault();
  effectScope(true).run(() =>
    watch(
      isUnsaved,
      (asks) => (asks ? addEventListener('beforeunload', ask) : removeEventListener('beforeunload', ask)),
      { flush: 'sync', immediate: true },
    ),
  );
}
