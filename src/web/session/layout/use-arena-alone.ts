import { onScopeDispose } from 'vue';

import type { ArenaAlone } from './arena-alone';
import { useLayout } from './parts';

/** The state of the arena alone, for a control in its pane. The control counts as a way back until its scope ends. */
export function useArenaAlone(): Pick<ArenaAlone, 'isAlone' | 'hasSide' | 'enter' | 'leave'> {
  const { alone } = useLayout();
  onScopeDispose(alone.attach());
  return alone;
}
