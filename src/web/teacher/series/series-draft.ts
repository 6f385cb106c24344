import { shallowRef, watch, type ShallowRef } from 'vue';

import { freeTaskId, seriesLimits, type Series, type SeriesTask } from '#check/series/series';
import { hexOf } from '#core/hex';

import { lateModel } from '../../kit/state/late-models';
import { keepDraft, keptDraft } from '../../session/task/series/kept-series';

/** After typing, only its end is written. Chosen, in ms. */
const QUIET_MS = 400;

/** The series that a teacher is making; it stays over a reload, until another is begun. */
export interface SeriesDraft {
  readonly series: ShallowRef<Series>;
  /** Resolves when the draft stored in this browser is there. */
  readonly isReady: Promise<void>;
  change(part: Partial<Omit<Series, 'id'>>): void;
  /** Adds tasks at the end. @returns how many had no room */
  add(tasks: readonly Omit<SeriesTask, 'id'>[]): number;
  remove(place: number): void;
  /** @param by −1: up, 1: down @returns the new place */
  move(place: number, by: -1 | 1): number;
  /** Begins anew, or brings another series in. */
  replace(series: Series): void;
}

/** Eight random hexadecimal digits. (`randomUUID` is missing on pages that came over plain http.) */
const newId = (): string => hexOf(crypto.getRandomValues(new Uint8Array(4)));

/** A series without a name and tasks, with an id of its own: marks of one series do not count for another. */
export const emptySeries = (): Series => ({ id: newId(), title: '', text: '', tasks: [] });

/** The draft of this page. */
export const seriesDraft = lateModel(() => createDraft());

function createDraft(): SeriesDraft {
  const series = shallowRef(emptySeries());
  let timer: ReturnType<typeof setTimeout> | undefined;
  let isTouched = false;
  const isReady = keptDraft().then((kept) => {
    if (kept !== null && !isTouched) series.value = kept;
    watch(series, (now) => {
      clearTimeout(timer);
      timer = setTimeout(() => void keepDraft(now), QUIET_MS);
    });
  });
  const set = (next: Series): void => {
    isTouched = true;
    series.value = next;
  };
  const setTasks = (tasks: readonly SeriesTask[]): void => set({ ...series.value, tasks });
  return {
    series,
    isReady,
    change: (part) => set({ ...series.value, ...part }),
    add(tasks) {
      const room = seriesLimits.tasks.max - series.value.tasks.length;
      const all = [...series.value.tasks];
      for (const task of tasks.slice(0, room)) all.push({ ...task, id: freeTaskId(all) });
      setTasks(all);
      return Math.max(0, tasks.length - room);
    },
    remove: (place) => setTasks(series.value.tasks.toSpliced(place, 1)),
    move(place, by) {
      const { tasks } = series.value;
      const [one, to] = [tasks[place], Math.min(Math.max(place + by, 0), tasks.length - 1)];
      if (one !== undefined) setTasks(tasks.toSpliced(place, 1).toSpliced(to, 0, one));
      return to;
    },
    replace: set,
  };
}
