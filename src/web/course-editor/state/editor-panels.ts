import { shallowRef, type ShallowRef } from 'vue';

/** The parts of the editor in windows of their own. */
export type EditorPanel = 'list' | 'course' | 'background' | 'print';

/** Which of the editor's windows is open. */
export interface EditorPanels {
  /** `null`: none. */
  readonly shown: Readonly<ShallowRef<EditorPanel | null>>;
  readonly open: (panel: EditorPanel) => void;
  readonly close: () => void;
}

/** Makes the model of the editor's windows, all closed. */
export function createEditorPanels(): EditorPanels {
  const shown = shallowRef<EditorPanel | null>(null);
  return { shown, open: (panel) => void (shown.value = panel), close: () => void (shown.value = null) };
}

/**
 * When a window closes, the focus returns to where it was opened: the button beside undo, near the tools and their
 * keys.
 */
export const focusMore = (): void =>
  document.querySelector<HTMLElement>('[data-testid="course-more"]')?.focus({ preventScroll: true });
