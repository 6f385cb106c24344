import { computed, shallowRef, watch, type ComputedRef } from 'vue';

import type { LayoutParts } from '../../session/layout/parts';
import type { RunParts } from '../../session/run/parts';
import type { WorkParts } from '../../session/work/model/parts';
import { firstCourse, isAsFound } from '../../session/work/catalogue/first-course';
import type { FirstStepsParts } from '../parts';

type Parts = Pick<RunParts, 'run'> & WorkParts & Pick<LayoutParts, 'router' | 'layout'> & FirstStepsParts;

/**
 * True if a newcomer is greeted: on a page of its own (no host, no link, no requested course), until there is an
 * answer, a first run or anything else to look at in its place.
 */
export function useGreeting({ run, settings, work, router, layout, tour }: Parts): ComputedRef<boolean> {
  const isFirstVisit = computed(() => {
    const { project } = work.work.value;
    const isAlone = window.parent === window && location.search === '' && router.page.value === null;
    return isAlone && !settings.current.value.welcomed && project.course === firstCourse?.id && isAsFound(project);
  });
  // Anyone who has found Run no longer needs a greeting.
  const hasRun = shallowRef(run.isActive.value);
  watch(run.isActive, (active) => {
    hasRun.value ||= active;
    if (active && isFirstVisit.value) settings.change({ welcomed: true });
  });
  return computed(
    () =>
      isFirstVisit.value &&
      !hasRun.value &&
      !tour.isOpen.value &&
      (layout.kind.value !== 'phone' || layout.tab.value === 'code'),
  );
}
