import { shallowRef, watch, type ShallowRef } from 'vue';

import type { LayoutParts } from '../../../session/layout/parts';
import type { CourseEditorParts } from './parts';

/**
 * True once palette, undo and shortcuts may load: if they are visible, as soon as the page is idle, otherwise on
 * demand. Everything else they need is loaded with the first tool.
 */
export function useLateTools({
  editor,
  layout,
}: Pick<LayoutParts, 'layout'> & Pick<CourseEditorParts, 'editor'>): Readonly<ShallowRef<boolean>> {
  const mayCome = shallowRef(false);
  const come = (): void => {
    mayCome.value = true;
  };
  function soon(): void {
    const { requestIdleCallback }: Partial<Pick<Window, 'requestIdleCallback'>> = window; // missing in Safari
    if (requestIdleCallback === undefined) setTimeout(come, 300);
    else requestIdleCallback.call(window, come, { timeout: 1500 });
  }
  if (editor.isOpen.value || layout.kind.value !== 'phone') soon();
  watch([editor.isOpen, layout.kind], come);
  return mayCome;
}
