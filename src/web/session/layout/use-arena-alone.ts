import { onScopeDispose } from 'vue';

import type { ArenaAlone } from './arena-alone';
import { useLayout } from './parts';

/** For controls in the arena's pane. */
export function useArenaAlone(): Pick<ArenaAlone, 'isAlone' | 'hasSide' | 'enter' | 'leave'> {
  const { alone } = useLayout();
  onScopeDispose(alone.attach());
  return alone;
}
