import { onScopeDispose } from 'vue';

import type { ArenaAlone } from './arena-alone';
import { useLayout } from './parts';

/** The full-screen arena, for a control in its pane that can lead back. It counts until its scope ends. */
export function useArenaAlone(): Pick<ArenaAlone, 'isAlone' | 'hasSide' | 'enter' | 'leave'> {
  const { alone } = useLayout();
  onScopeDispose(alone.attach());
  return alone;
}
