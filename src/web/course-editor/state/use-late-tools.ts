import { shallowRef, watch, type ShallowRef } from 'vue';

import type { LayoutParts } from '../../layout/parts';
import type { CourseEditorParts } from './parts';

/**
 * Whether palette, undo and keys may load now: where they are in sight, once the page has nothing more urgent to do,
 * otherwise on request. Everything else they need comes with the first tool.
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
    const { requestIdleCallback }: Partial<Pick<Window, 'requestIdleCallback'>> = window; // Safari has none
    if (requestIdleCallback === undefined) setTimeout(come, 300);
    else requestIdleCallback.call(window, come, { timeout: 1500 });
  }
  if (editor.isOpen.value || layout.kind.value !== 'phone') soon();
  watch([editor.isOpen, layout.kind], come);
  return mayCome;
}
