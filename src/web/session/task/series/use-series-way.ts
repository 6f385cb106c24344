import { computed, shallowRef, watch, type ComputedRef } from 'vue';

import type { Series, SeriesTask } from '#check/series/series';

import type { WithLate } from '../../../kit/state/late-models';
import { reopenSeries } from './kept-series';
import type { SeriesApp } from './open-task';
import { taskAfter } from './open-task';
import { placeOf } from './series-place';
import { taskOfWork } from './series-task';

/** The way on from a task of a series. */
export interface SeriesWay {
  /** The series of the open work; `null`: it has none, or this browser does not know it. */
  readonly series: ComputedRef<Series | null>;
  readonly task: ComputedRef<SeriesTask | null>;
  /** The one after it. */
  readonly next: ComputedRef<SeriesTask | null>;
}

/** Finds the series that the open work is a part of. */
export function useSeriesWay(app: Pick<SeriesApp, 'work'> & WithLate): SeriesWay {
  const { work } = app;
  const kept = shallowRef<Series | null>(null);
  const project = computed(() => work.work.value.project);
  watch(
    () => placeOf(project.value)?.series ?? null,
    async (id) => {
      const found = id === null ? null : await reopenSeries(app, id);
      if (id === (placeOf(project.value)?.series ?? null)) kept.value = found;
    },
    { immediate: true },
  );
  const task = computed(() => kept.value && taskOfWork(project.value, kept.value));
  return {
    series: computed(() => (task.value === null ? null : kept.value)),
    task,
    next: computed(() => kept.value && task.value && taskAfter(kept.value, task.value)),
  };
}
