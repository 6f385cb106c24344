import { computed, type ComputedRef } from 'vue';

import type { RunParts } from '../run/parts';
import type { WorkParts } from '../work/model/parts';

/** The modes of the arena, in the order in which they are shown: driving, building the course, looking back at a run. */
export const ARENA_MODES = ['drive', 'build', 'lookBack'] as const;
export type ArenaMode = (typeof ARENA_MODES)[number];

/** The purpose of the arena now. Whatever does not belong to it is neither shown nor can it act. */
export interface ModeModel {
  readonly current: ComputedRef<ArenaMode>;
  /** The modes that can be entered now, in their order: no building where a task locks the course, no past before a run. */
  readonly offered: ComputedRef<readonly ArenaMode[]>;
  /** Enters a mode; one that is not offered is refused without a word. */
  enter(mode: ArenaMode): void;
}

/** Makes the mode of the arena. It has no state of its own: a past that is shown, or tools that are unfolded, are the mode. */
export function createMode({ run, work, settings }: Pick<RunParts, 'run'> & WorkParts): ModeModel {
  const mayBuild = (): boolean => !work.locks.isLocked('course');
  const hasRun = (): boolean => run.present.value !== null && run.phase.value !== 'starting';
  const current = computed((): ArenaMode => {
    if (run.past.value !== null) return 'lookBack';
    return settings.current.value.showTools === true && mayBuild() ? 'build' : 'drive';
  });
  const offered = computed(() =>
    ARENA_MODES.filter((mode) => {
      if (mode === 'build') return mayBuild();
      return mode === 'drive' || run.past.value !== null || hasRun();
    }),
  );
  return {
    current,
    offered,
    enter(mode) {
      if (mode === current.value || !offered.value.includes(mode)) return;
      if (mode === 'lookBack') {
        run.look.back();
        return;
      }
      if (current.value === 'lookBack') run.look.leave();
      settings.change({ showTools: mode === 'build' });
    },
  };
}
