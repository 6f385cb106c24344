import { shallowRef, type ShallowRef } from 'vue';

/** The parts of the editor that have a window of their own. */
export type EditorPanel = 'list' | 'course' | 'background' | 'print';

/** Which of the editor's windows is open. */
export interface EditorPanels {
  /** `null`: none. */
  readonly shown: Readonly<ShallowRef<EditorPanel | null>>;
  readonly open: (panel: EditorPanel) => void;
  readonly close: () => void;
}

/** Creates the model of the editor's windows, all closed. */
export function createEditorPanels(): EditorPanels {
  const shown = shallowRef<EditorPanel | null>(null);
  return { shown, open: (panel) => void (shown.value = panel), close: () => void (shown.value = null) };
}

/**
 * Returns the focus to where a closing window was opened: the button beside undo, where the tools' keys work.
 */
export const focusMore = (): void =>
  document.querySelector<HTMLElement>('[data-testid="course-more"]')?.focus({ preventScroll: true });
