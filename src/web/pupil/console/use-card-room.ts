import { onScopeDispose, watch, type ShallowRef } from 'vue';

import type { LayoutModel } from '../../session/layout/layout-model';
import type { ConsoleModel } from './console-model';

/** Room around the card, in px. Chosen by eye. */
const AROUND_PX = 18;

/** Opens the console as high as the card of the last run's error: nobody must scroll to the button that repairs it. */
export function useCardRoom(
  box: Readonly<ShallowRef<HTMLElement | null>>,
  { leastConsolePx, kind }: LayoutModel,
  { entries }: ConsoleModel,
): void {
  let card: HTMLElement | null = null;
  const watching = new ResizeObserver(measure);
  function measure(): void {
    const pane = card?.closest<HTMLElement>('.pane');
    if (!card || !pane || !box.value || kind.value === 'phone') return;
    const headPx = pane.offsetHeight - box.value.offsetHeight;
    leastConsolePx.value = headPx + card.offsetHeight + AROUND_PX;
  }
  function letGo(): void {
    if (card !== null) leastConsolePx.value = 0;
    card = null;
    watching.disconnect();
  }
  const newest = () => entries.value.findLast((entry) => entry.kind === 'error' || entry.kind === 'run');
  // The error may be there before the console is: that comes with the first run.
  watch(
    [newest, box],
    ([latest]) => {
      letGo();
      if (latest?.kind !== 'error') return;
      card = box.value?.querySelector<HTMLElement>(`[data-entry="${String(latest.id)}"]`) ?? null;
      if (card !== null) watching.observe(card);
    },
    { flush: 'post', immediate: true },
  );
  onScopeDispose(letGo);
}
