import { intoArena } from '#editor/snap';
import type { EditorView } from '../../course-editor/state/course-editor-model';
import type { OpeningSources } from './arena-openings';
import { toMm } from '../view/view-transform';

/** What of the arena is seen, for those who bring something from beside it. */
export function arenaSight(
  { picture, course, inkCanvas }: Pick<OpeningSources, 'picture' | 'course' | 'inkCanvas'>,
  surface: { readonly reachMm: number },
): EditorView {
  return {
    at(xPx, yPx) {
      const box = inkCanvas()?.parentElement?.getBoundingClientRect();
      if (!box || xPx < box.left || yPx < box.top || xPx > box.right || yPx > box.bottom) return null;
      return toMm(picture.view.value, { x: xPx - box.left, y: yPx - box.top });
    },
    middle() {
      const { widthPx, heightPx } = picture.canvas.value;
      return intoArena(toMm(picture.view.value, { x: widthPx / 2, y: heightPx / 2 }), course().size);
    },
    reachMm: () => surface.reachMm,
  };
}
