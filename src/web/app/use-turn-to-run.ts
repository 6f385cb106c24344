import { watch } from 'vue';

import type { LayoutParts } from '../session/layout/parts';
import type { RunParts } from '../session/run/parts';
import { hasRobot } from '../session/work/hardware/use-hardware';
import type { WorkParts } from '../session/work/model/parts';

/**
 * On a phone, where the program hides the rest, a run turns to what it shows: the arena, or the board where no device has
 * a robot; and to the console when the program asks something. Whoever looks at something else when it starts goes on
 * looking at it.
 */
export function useTurnToRun(app: Pick<RunParts, 'run'> & Pick<LayoutParts, 'layout'> & WorkParts): void {
  const { run, layout } = app;
  watch(run.phase, (phase) => {
    if (phase !== 'starting' || layout.arrangement.value !== 'phone' || !layout.isShown.value.code) return;
    const pane = hasRobot(app) ? 'arena' : 'board';
    if (layout.tabs.value.includes(pane)) layout.tab.value = pane;
  });
  watch(run.isWaitingForInput, (asks) => {
    if (asks && layout.arrangement.value === 'phone' && layout.tabs.value.includes('console'))
      layout.tab.value = 'console';
  });
}
