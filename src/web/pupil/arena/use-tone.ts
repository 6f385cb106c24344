import { computed, type ComputedRef } from 'vue';

import type { RunParts } from '../../session/run/parts';

/** The tone that the run makes now, in Hz, whether it is heard or not; 0: none. */
export function useTone({ run }: Pick<RunParts, 'run'>): ComputedRef<number> {
  return computed(() => (run.phase.value === 'running' ? (run.shown.value?.sound?.hz ?? 0) : 0));
}
