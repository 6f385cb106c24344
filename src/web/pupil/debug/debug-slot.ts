import { computed, shallowRef, watch, type ComputedRef, type ShallowRef } from 'vue';

import type { Debug, Stillness } from './debug';
import type * as Marks from './editor/marks';
import type { PastParts } from './past';

/**
 * The debugger's place on the page. Its code is loaded when it is needed: with the first break point, with stored ones,
 * or when a program is first halted or looked back on.
 */
export class DebugSlot implements Stillness {
  /** `null` until it is loaded. */
  readonly debug: ShallowRef<Debug | null> = shallowRef(null);
  readonly isStanding: ComputedRef<boolean>;
  readonly isInspectable: ComputedRef<boolean>;
  readonly showsVariables = shallowRef(false);
  /** The marks in the editor; loaded with `debug`. */
  marks: typeof Marks | null = null;
  private coming: Promise<Debug> | null = null;

  constructor(private readonly app: PastParts) {
    const { run } = app;
    this.isStanding = computed(
      () => run.phase.value === 'paused' && run.past.value === null && run.ended.value === null,
    );
    this.isInspectable = computed(() => this.isStanding.value || run.past.value !== null);
    watch(this.isInspectable, (isStill) => isStill && this.need());
    if (hasKept()) this.need();
  }

  /** Loads the debugger. Without a connection nothing happens; the next call tries again. */
  need(use?: (debug: Debug) => void): void {
    this.coming ??= Promise.all([import('./debug'), import('./editor/marks')]).then(([{ Debug: Made }, marks]) => {
      this.marks = marks;
      return (this.debug.value = new Made(this.app, this));
    });
    this.coming.then(use, () => (this.coming = null));
  }
}

/** The key is that of `break-points.ts`, which comes later. */
function hasKept(): boolean {
  try {
    return (sessionStorage.getItem('parcours.break-points') ?? '{}') !== '{}';
  } catch {
    return false;
  }
}
