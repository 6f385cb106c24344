import { nextTick } from 'vue';

import type { WorkParts } from '../work/model/parts';
import type { LayoutParts } from './parts';

/** Opens the projector view: the arena with task, timer and verdict beside it, also where another pane is shown. */
export async function openProjector({
  alone,
  layout,
  settings,
}: Pick<LayoutParts, 'alone' | 'layout'> & Pick<WorkParts, 'settings'>): Promise<void> {
  if (!layout.isShown.value.arena) {
    settings.change({ showArena: true });
    layout.tab.value = 'arena';
    await nextTick();
  }
  alone.hasSide.value = true;
  alone.enter();
}
