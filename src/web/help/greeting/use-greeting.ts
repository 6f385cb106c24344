import { computed, watch, type ComputedRef } from 'vue';

import type { LayoutParts } from '../../session/layout/parts';
import type { RunParts } from '../../session/run/parts';
import { firstCourse } from '../../session/work/catalogue/first-course';
import type { WorkParts } from '../../session/work/model/parts';
import { isHandedOut } from '../../session/work/model/task-locks';
import type { FirstStepsParts } from '../parts';

type Parts = Pick<RunParts, 'run'> & WorkParts & Pick<LayoutParts, 'router' | 'layout'> & FirstStepsParts;

/**
 * True while somebody is asked where to begin, in the place of the task's card: on the first visit to a page of its own
 * (no host, no link, no requested course), and whenever the logo is pressed, until there is an answer, a run, or
 * something else was opened. Never where a task was handed out.
 */
export function useGreeting({ run, settings, work, router, layout, tour, greeting }: Parts): ComputedRef<boolean> {
  const isOwnPage = window.parent === window && location.search === '';
  const isFirstVisit = computed(
    () =>
      isOwnPage &&
      router.page.value === null &&
      !settings.current.value.welcomed &&
      work.work.value.project.course === firstCourse?.id,
  );
  const isGreeted = computed(
    () =>
      (isFirstVisit.value || greeting.isAsked.value) &&
      !tour.isOpen.value &&
      !isHandedOut(work.work.value.project) &&
      layout.parts.value.includes('bar'),
  );
  // Who runs a program has begun.
  watch(run.isActive, (isActive) => {
    if (!isActive) return;
    greeting.end();
    if (isFirstVisit.value) settings.change({ welcomed: true });
  });
  watch([work.openings, work.arrivals], greeting.end);
  return isGreeted;
}
