import { computed, onScopeDispose, shallowRef, watch, type ComputedRef } from 'vue';

import type { LayoutParts } from '../../session/layout/parts';
import type { RunParts } from '../../session/run/parts';
import type { ConsoleEntry } from './log/console-log';
import type { ConsoleParts } from './parts';

/** The fold of the console: folded, it shows its head alone. */
export interface ConsoleFold {
  readonly isFolded: ComputedRef<boolean>;
  readonly canFold: ComputedRef<boolean>;
  toggle(): void;
}

/**
 * Folds the console while it has nothing to say, and opens it for what a program prints or asks and for an error. What
 * a pupil has chosen by hand stays until the next run; an error or a question opens it all the same. While somebody
 * looks back it is folded, unless they open it.
 */
export function useConsoleFold({
  run,
  layout,
  console,
}: Pick<RunParts, 'run'> & Pick<LayoutParts, 'layout'> & Pick<ConsoleParts, 'console'>): ConsoleFold {
  const chosen = shallowRef<'open' | 'folded' | null>(null);
  const speaks = computed(() => run.isWaitingForInput.value || console.shown.value.some(says));
  /** A chart that is folded away would be none. */
  const canFold = computed(() => layout.canFold.value && !console.isChart.value);
  const isPast = computed(() => run.past.value !== null);
  const isFolded = computed(() => {
    if (!canFold.value) return false;
    return chosen.value === null ? isPast.value || !speaks.value : chosen.value === 'folded';
  });
  watch(isPast, () => (chosen.value = null));
  watch(isFolded, (folded) => (layout.isConsoleFolded.value = folded), { immediate: true, flush: 'sync' });
  watch(run.phase, (phase) => {
    if (phase === 'starting') chosen.value = null;
  });
  watch(
    [() => console.entries.value.findLast((entry) => entry.kind === 'error')?.id, run.isWaitingForInput],
    ([error, asks]) => {
      if (error !== undefined || asks) chosen.value = null;
    },
  );
  onScopeDispose(() => (layout.isConsoleFolded.value = false));
  return {
    isFolded,
    canFold,
    toggle: () => (chosen.value = isFolded.value ? 'open' : 'folded'),
  };
}

/** True if this is something to read: neither the head of a run nor a word about its end, such as a traceback, which a card explains. */
const says = (entry: ConsoleEntry): boolean =>
  entry.kind === 'error' ||
  entry.kind === 'fit' ||
  (entry.kind === 'text' && entry.tone === 'plain' && entry.text.trim() !== '');
