import { onScopeDispose } from 'vue';

import { historyFromText, historyToText } from '#scene/kept-history';

import type { WorkParts } from '../../session/work/model/parts';
import type { CourseEditorParts } from './state/parts';

/**
 * The most that is stored, in characters. Chosen: far less than the work itself may take of the browser's five million.
 */
const MOST_CHARACTERS = 200_000;

/**
 * Restores the stored undo history and stores it from now on. Stores nothing if the browser forbids it or has no room.
 *
 * @param key its key in the tab's session storage
 */
export function storeUndo(
  { work, editor }: Pick<WorkParts, 'work'> & Pick<CourseEditorParts, 'editor'>,
  key: string,
): void {
  quietly(() => {
    const text = sessionStorage.getItem(key);
    if (text === null) return;
    work.takeUp(historyFromText(text, work.scene.value));
    // An undo before the first tool is chosen must be announced, too.
    import('./join-editor').then(({ joinEditor }) => joinEditor(editor)).catch(() => undefined);
  });
  const save = (): void =>
    quietly(() => {
      const { past, future } = work.history.value;
      if (past.length + future.length === 0) sessionStorage.removeItem(key);
      else sessionStorage.setItem(key, historyToText(work.history.value, MOST_CHARACTERS));
    });
  const hidden = (): void => {
    if (document.visibilityState === 'hidden') save();
  };
  addEventListener('pagehide', save);
  document.addEventListener('visibilitychange', hidden);
  onScopeDispose(() => {
    save();
    removeEventListener('pagehide', save);
    document.removeEventListener('visibilitychange', hidden);
  });
}

function quietly(act: () => void): void {
  try {
    act();
  } catch {
    // nothing is stored
  }
}
