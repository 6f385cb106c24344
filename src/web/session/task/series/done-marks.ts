import { shallowRef, type Ref } from 'vue';

import { isRecord } from '#core/record';

import { lateModel } from '../../../kit/state/late-models';
import type { SeriesPlace } from './series-place';

/** The tasks done in this browser, of all series: `series/task` → stars, 0 if the task gives none. */
export type Done = Readonly<Record<string, number>>;

/** The marks of tasks that are done. They stay when the program is changed or the page is closed. */
export interface DoneMarks {
  readonly all: Readonly<Ref<Done>>;
  /** Marks a task, and keeps the most stars. */
  mark(place: SeriesPlace, stars: number): void;
  /** Removes a mark. */
  clear(place: SeriesPlace): void;
}

const KEY = 'parcours.series';
/** Chosen: series of many years; the oldest marks go first. */
const MOST = 2000;

export const keyOf = ({ series, task }: SeriesPlace): string => `${series}/${task}`;

/** Loads the marks. @param store storage for them; `null`: they last as long as the page is open */
export function createDoneMarks(store: Storage | null): DoneMarks {
  const all = shallowRef(read(store));
  if (store !== null)
    window.addEventListener('storage', ({ key }) => {
      if (key === KEY) all.value = read(store);
    });
  function write(change: (now: Done) => Done): void {
    all.value = change({ ...all.value, ...read(store) });
    try {
      store?.setItem(KEY, JSON.stringify(all.value));
    } catch {
      // No room or no permission: they hold as long as the page does.
    }
  }
  return {
    all,
    mark(place, stars) {
      const key = keyOf(place);
      write((now) =>
        Object.fromEntries(Object.entries({ ...now, [key]: Math.max(stars, now[key] ?? 0) }).slice(-MOST)),
      );
    },
    clear(place) {
      const key = keyOf(place);
      write((now) => Object.fromEntries(Object.entries(now).filter(([name]) => name !== key)));
    },
  };
}

/** The stored marks; unreadable ones count as none. */
function read(store: Storage | null): Done {
  try {
    const stored: unknown = JSON.parse(store?.getItem(KEY) ?? '{}');
    if (!isRecord(stored)) return {};
    const good = Object.entries(stored).filter(([, stars]) => [0, 1, 2, 3].some((count) => count === stars));
    return Object.fromEntries(good) as Done;
  } catch {
    return {};
  }
}

/** The marks of this browser. */
export const doneMarks = lateModel(() => createDoneMarks(storage()));

function storage(): Storage | null {
  try {
    return localStorage;
  } catch {
    return null;
  }
}
