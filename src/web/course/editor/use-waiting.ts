import { computed, shallowRef, watch, type ComputedRef } from 'vue';

import type { WorkParts } from '../../session/work/model/parts';
import type { CourseEditorParts } from './state/parts';
import type * as Waiting from './words/waiting-words';

type App = Pick<WorkParts, 'work'> & Pick<CourseEditorParts, 'editor'>;

/** The changes that take effect only at the next start, in words; empty if there are none. */
export function useWaiting({ work, editor }: App): ComputedRef<string> {
  /** Names the changes; loaded with the first of them. */
  const teller = shallowRef<typeof Waiting | null>(null);
  watch(
    editor.isWaiting,
    async (isWaiting) => {
      if (isWaiting) teller.value ??= await import('./words/waiting-words').catch(() => null);
    },
    { immediate: true },
  );
  return computed(() => {
    const start = editor.runStart.value;
    return editor.isWaiting.value && start !== null ? (teller.value?.waitingWords(start, work.scene.value) ?? '') : '';
  });
}
