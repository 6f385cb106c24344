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
 * Folds the console, and opens it for what a program asks and for an error; for what it prints only where no arena is
 * in sight, since beside that its latest line stands in the head. What a pupil has chosen by hand stays until the next
 * run; an error or a question opens it all the same. While somebody looks back it is folded, unless they open it.
 *
 * @param hasBoard true while a real board's output stands in it, too
 */
export function useConsoleFold(
  { run, layout, console }: Pick<RunParts, 'run'> & Pick<LayoutParts, 'layout'> & Pick<ConsoleParts, 'console'>,
  hasBoard: () => boolean,
): ConsoleFold {
  const chosen = shallowRef<'open' | 'folded' | null>(null);
  const isCalm = computed(() => layout.isShown.value.arena);
  const speaks = computed(
    () =>
      run.isWaitingForInput.value ||
      hasBoard() ||
      ofPresentRun(console.shown.value).some((entry) => says(entry) || (!isCalm.value && isPrinted(entry))),
  );
  /** A chart that is folded away would be none. */
  const canFold = computed(() => layout.canFold.value && !console.isChart.value);
  const isPast = computed(() => run.past.value !== null);
  const isFolded = computed(() => {
    if (!canFold.value) return false;
    return chosen.value === null ? isPast.value || !speaks.value : chosen.value === 'folded';
  });
  watch(isPast, () => (chosen.value = null));
  watch(isFolded, (folded) => (layout.isConsoleFolded.value = folded), { immediate: true, flush: 'sync' });
  watch(hasBoard, () => (chosen.value = null));
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

/** The entries of the present run; what an earlier one has left is read already. */
const ofPresentRun = (entries: readonly ConsoleEntry[]): readonly ConsoleEntry[] =>
  entries.slice(entries.findLastIndex(({ kind }) => kind === 'run') + 1);

/** True if this is to be read at once: neither the head of a run nor a word about its end. */
const says = ({ kind }: ConsoleEntry): boolean => kind === 'error' || kind === 'fit';

/** True if the program has written this; a traceback is explained by a card. */
const isPrinted = (entry: ConsoleEntry): boolean =>
  entry.kind === 'text' && entry.tone === 'plain' && entry.text.trim() !== '';
