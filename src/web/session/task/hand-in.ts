import { computed, shallowRef, watch, type ComputedRef, type Ref } from 'vue';

import { isHandedOut } from '../work/model/task-locks';
import type { WorkParts } from '../work/model/parts';

/** Handing in the open work: its window, and whether it was done. */
export interface HandInModel {
  /** True where a task was handed out: there, handing in takes the place of sharing. */
  readonly isAsked: ComputedRef<boolean>;
  readonly isOpen: Readonly<Ref<boolean>>;
  /** True if the open work has been handed in; a reload does not forget it. */
  readonly isDone: Readonly<Ref<boolean>>;
  /** Opens the window, at the name. */
  readonly open: () => void;
  readonly close: () => void;
  /** Notes that a link or file has left the page. */
  readonly done: () => void;
}

/** Makes the model. Another work closes the window. */
export function createHandIn({ work }: Pick<WorkParts, 'work'>): HandInModel {
  const isOpen = shallowRef(false);
  watch([work.works, work.arrivals], () => (isOpen.value = false));
  return {
    isAsked: computed(() => isHandedOut(work.work.value.project)),
    isOpen,
    isDone: computed(() => work.work.value.isHandedIn === true),
    open: () => void (isOpen.value = true),
    close: () => void (isOpen.value = false),
    done: () => work.noteHandedIn(),
  };
}
