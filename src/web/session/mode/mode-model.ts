import { computed, watch, type ComputedRef } from 'vue';

import { ARENA_MODES, type ArenaMode } from '#embed/simulator';

import type { RunParts } from '../run/parts';
import type { VisitParts } from '../visit/parts';
import type { WorkParts } from '../work/model/parts';

export { ARENA_MODES, type ArenaMode } from '#embed/simulator';

/** The purpose of the arena now. Whatever does not belong to it is neither shown nor can it act. */
export interface ModeModel {
  readonly current: ComputedRef<ArenaMode>;
  /**
   * The modes that can be entered now, in their order: no building where a task locks the course or a host shows no
   * tools, no past before a run.
   */
  readonly offered: ComputedRef<readonly ArenaMode[]>;
  /** Enters a mode; one that is not offered is refused without a word. Building and looking back pause a run. */
  enter(mode: ArenaMode): void;
}

type Around = Pick<RunParts, 'run'> & WorkParts & VisitParts;

/**
 * Makes the mode of the arena. It has no state of its own: a past that is shown, or tools that are unfolded, are the
 * mode. Every start of a run leads to driving, and so does another course, unless a host or the address wants it built.
 */
export function createMode({ run, work, settings, host }: Around): ModeModel {
  const hasTools = (): boolean => host.parts.value?.includes('tools') ?? true;
  const mayBuild = (): boolean => hasTools() && !work.locks.isLocked('course');
  const hasRun = (): boolean => run.present.value !== null && run.phase.value !== 'starting';
  const current = computed((): ArenaMode => {
    if (run.past.value !== null) return 'lookBack';
    return settings.current.value.showTools && mayBuild() ? 'build' : 'drive';
  });
  const offered = computed(() =>
    ARENA_MODES.filter((mode) => {
      if (mode === 'build') return mayBuild();
      return mode === 'drive' || run.past.value !== null || hasRun();
    }),
  );
  const unfold = (showTools: boolean): void => {
    if (settings.current.value.showTools !== showTools) settings.change({ showTools });
  };
  watch(
    run.phase,
    (phase) => {
      if (phase === 'starting' || phase === 'running') unfold(false);
    },
    { flush: 'sync' },
  );
  watch(
    work.openings,
    () => {
      if (host.parts.value === null && host.wish.mode !== 'build') unfold(false);
    },
    { flush: 'sync' },
  );
  watch(
    () => run.past.value !== null,
    (isPast) => {
      if (isPast && !settings.current.value.lookedBack) settings.change({ lookedBack: true });
    },
    { flush: 'sync' },
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
      if (mode === 'build') run.pause();
      unfold(mode === 'build');
    },
  };
}
