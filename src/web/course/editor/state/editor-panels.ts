import { shallowRef, watch, type ShallowRef } from 'vue';

import type { Scene } from '#scene/scene';

import type { LayoutParts } from '../../../session/layout/parts';
import type { ModeParts } from '../../../session/mode/parts';
import type { WorkParts } from '../../../session/work/model/parts';

/** The parts of the editor that have a window of their own. */
export type EditorPanel = 'list' | 'course' | 'background' | 'print' | 'parts' | 'line';

/** The editor's windows, of which at most one is open. */
export interface EditorPanels {
  /** `null`: none. */
  readonly shown: Readonly<ShallowRef<EditorPanel | null>>;
  readonly open: (panel: EditorPanel) => void;
  readonly close: () => void;
  /** True if what is selected is to be laid onto the shelf of parts, as soon as that is open. */
  readonly keeps: ShallowRef<boolean>;
  /** A course to be printed instead of the open one, after which the shelf of parts is open again; `null`: none. */
  readonly printed: ShallowRef<Scene | null>;
  /** The picture file from which the floor is being made; `null`: none. */
  readonly picture: ShallowRef<Blob | null>;
  /** Opens a picture as a floor to be, which begins building. Returns `false` where the page has no arena. */
  readonly offer: (picture: Blob) => boolean;
}

/** Creates the model of the editor's windows, all closed. */
export function createEditorPanels({
  work,
  layout,
  settings,
  mode,
}: Pick<LayoutParts, 'layout'> & WorkParts & ModeParts): EditorPanels {
  const shown = shallowRef<EditorPanel | null>(null);
  const picture = shallowRef<Blob | null>(null);
  const printed = shallowRef<Scene | null>(null);
  const isShut = (): boolean => mode.current.value !== 'build';
  // All but the one that prints belong to building.
  watch(mode.current, () => {
    if (!isShut() || shown.value === 'print') return;
    shown.value = picture.value = printed.value = null;
  });
  return {
    shown,
    open(panel) {
      if (panel === 'print' || !isShut()) shown.value = panel;
    },
    close() {
      shown.value = printed.value === null ? null : 'parts';
      picture.value = printed.value = null;
    },
    keeps: shallowRef(false),
    printed,
    picture,
    offer(file) {
      if (!layout.tabs.value.includes('arena')) return false;
      settings.change({ showArena: true });
      layout.tab.value = 'arena';
      if (work.staysAsItIs()) return true;
      mode.enter('build');
      if (isShut() && work.locks.refuses('course')) return true;
      picture.value = file;
      shown.value = 'background';
      return true;
    },
  };
}

/**
 * Returns the focus to where a closing window was opened: the button beside undo, where the tools' keys work.
 */
export const focusMore = (): void =>
  document.querySelector<HTMLElement>('[data-testid="course-more"]')?.focus({ preventScroll: true });
