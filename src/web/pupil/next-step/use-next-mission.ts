import { computed, shallowRef, watch, type ComputedRef } from 'vue';

import type * as Missions from '#catalogue/missions';

import type { StepTask } from './next-step';
import type { StepApp } from './step-app';

type App = Pick<StepApp, 'task'>;

/**
 * The step after the open mission; `null`: not known yet. The missions are fetched once one is passed; without a
 * connection nothing follows.
 */
export function useNextMission({ task }: App, hasPassed: () => boolean): ComputedRef<StepTask['next']> {
  const late = shallowRef<typeof Missions | null>(null);
  watch(
    hasPassed,
    async (passed) => {
      if (passed) late.value ??= await import('#catalogue/missions').catch(() => null);
    },
    { immediate: true },
  );
  return computed(() => {
    const mission = task.ready.value?.mission;
    if (mission === undefined || late.value === null || !hasPassed()) return null;
    if (late.value.missionAfter(mission) !== null) return 'mission';
    const stars = task.stars.all.value;
    return late.value.ladderOf(mission.robot).every(({ id }) => stars[id] === 3) ? 'missions' : 'stars';
  });
}
