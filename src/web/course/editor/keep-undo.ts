import { effectScope, watch } from 'vue';

import type { WorkParts } from '../../session/work/model/parts';
import type { VisitParts } from '../../session/visit/parts';
import type { CourseEditorParts } from './state/parts';

/** The key of the steps in the tab's session storage. */
const UNDO_KEY = 'parcours.undo';

/**
 * Keeps the undo history across reloads, in this tab only. If this page does not keep the work, the history starts
 * empty with each load. The code is fetched once there is something to keep.
 */
export function keepUndo(app: Pick<WorkParts, 'work'> & VisitParts & Pick<CourseEditorParts, 'editor'>): void {
  if (!app.host.wish.keepsWork) return;
  const scope = effectScope();
  const begin = (): void => {
    import('./store-undo')
      .then(({ storeUndo }) => scope.active && scope.run(() => storeUndo(app, UNDO_KEY)))
      .catch(() => undefined);
  };
  if (hasKept()) begin();
  else watch(app.work.history, begin, { once: true });
}

function hasKept(): boolean {
  try {
    return sessionStorage.getItem(UNDO_KEY) !== null;
  } catch {
    return false; // the browser has no storage
  }
}
