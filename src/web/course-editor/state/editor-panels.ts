import { shallowRef } from 'vue';

/** What of the editor stands in a window of its own. */
export type EditorPanel = 'list' | 'course' | 'background' | 'print';

const shown = shallowRef<EditorPanel | null>(null);

/** Which of them is open: the page has one arena, so this is said once. */
export const editorPanels = {
  shown,
  open: (panel: EditorPanel): void => void (shown.value = panel),
  close: (): void => void (shown.value = null),
};
