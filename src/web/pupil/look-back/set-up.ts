import { nextTick } from 'vue';

import { useLayer } from '../../kit/overlays/use-layer';
import type { SetUp } from '../../session/models/session';

/** Escape leads out of the past once nothing else is open. The keyboard, whose control may have gone with it, goes on in the arena. */
export const setUp: SetUp = ({ mode }) => {
  async function requestClose(): Promise<void> {
    mode.enter('drive');
    await nextTick();
    if (document.activeElement !== document.body) return;
    document.querySelector<HTMLElement>('.pane-arena [role="application"]')?.focus({ preventScroll: true });
  }
  useLayer(
    { requestClose: () => void requestClose() },
    { isOpen: () => mode.current.value === 'lookBack', place: 'below' },
  );
};
