import { onScopeDispose, watch } from 'vue';

import { openLayer, type Layer } from './overlays';

/** Keeps a layer open as long as a component is on the page, or as long as `isOpen` says: Escape closes it in its turn. */
export function useLayer(
  layer: Layer,
  { isOpen = () => true, place = 'top' }: { isOpen?: () => boolean; place?: 'top' | 'below' } = {},
): void {
  let close: (() => void) | null = null;
  watch(
    isOpen,
    (isNowOpen) => {
      close?.();
      close = isNowOpen ? openLayer(layer, place) : null;
    },
    { immediate: true, flush: 'sync' },
  );
  onScopeDispose(() => close?.());
}
