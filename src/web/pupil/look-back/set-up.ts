import { useLayer } from '../../kit/overlays/use-layer';
import type { SetUp } from '../../session/models/session';

/** Escape leads out of the past once nothing else is open. */
export const setUp: SetUp = ({ mode }) => {
  useLayer(
    { requestClose: () => mode.enter('drive') },
    { isOpen: () => mode.current.value === 'lookBack', place: 'below' },
  );
};
