import { effectScope, watch } from 'vue';

import type { ClassKeeper } from './class-keeper';
import type { ClassModel } from './model/class-model';

/** Has the browser ask before the page is left, as long as results or notes would be lost with it, and only then. */
export function askOnLeaving(model: ClassModel, keeper: Pick<ClassKeeper, 'isKept'>): void {
  const ask = (event: Event): void => event.preventDefault();
  effectScope(true).run(() =>
    watch(
      () => model.isUnsaved.value && !keeper.isKept.value,
      (asks) => (asks ? addEventListener('beforeunload', ask) : removeEventListener('beforeunload', ask)),
      { flush: 'sync', immediate: true },
    ),
  );
}
