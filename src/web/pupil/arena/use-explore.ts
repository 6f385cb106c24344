import { shallowRef, type ShallowRef } from 'vue';

import type { Vec } from '#core/geometry';

import type { Told } from '../narration/explore';
import type { Explored, ExplorerNow } from '../narration/explore-now';

/**
 * Keys of the arena: N (Shift+N for backwards) steps through the things in the course, O describes the surroundings.
 */
export interface Explore {
  /** The last answer; `count` distinguishes it from the one before. */
  readonly told: Readonly<ShallowRef<{ readonly count: number; readonly words: string }>>;
  readonly keydown: (event: KeyboardEvent) => void;
}

/** @param show shows the place (world mm) of the announced thing */
export function useExplore(explored: Explored, show: (atMm: Vec) => void): Explore {
  const told = shallowRef({ count: 0, words: '' });
  let explorer: ExplorerNow | null = null;

  function tell({ words, atMm }: Told): void {
    told.value = { count: told.value.count + 1, words };
    show(atMm);
  }
  function keydown(event: KeyboardEvent): void {
    const key = event.key.toLowerCase();
    if ((key !== 'n' && key !== 'o') || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    const back = event.shiftKey;
    import('../narration/explore-now').then(
      ({ createExplorerOf }) => {
        explorer ??= createExplorerOf(explored);
        tell(key === 'n' ? explorer.step(back) : explorer.around());
      },
      () => undefined, // without a connection the key does nothing
    );
  }
  return { told, keydown };
}
