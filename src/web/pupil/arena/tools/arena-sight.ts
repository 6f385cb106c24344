import type { Vec } from '#core/geometry';
import { middleBetween } from '#editor/plane';
import { intoArena } from '#editor/snap';
import type { EditorView } from '../../../course/editor/state/course-editor-model';
import type { OpeningSources } from './arena-openings';
import { toMm } from '../view/view-transform';

/** The visible part of the arena, for dragging something in from beside it. */
export function arenaSight(
  { picture, course, inkCanvas }: Pick<OpeningSources, 'picture' | 'course' | 'inkCanvas'>,
  surface: { readonly reachMm: number },
): EditorView {
  const boxNow = (): DOMRect | undefined => inkCanvas()?.parentElement?.getBoundingClientRect();
  return {
    at(xPx, yPx) {
      const box = boxNow();
      if (!box || xPx < box.left || yPx < box.top || xPx > box.right || yPx > box.bottom) return null;
      return toMm(picture.view.value, { x: xPx - box.left, y: yPx - box.top });
    },
    middle(abovePx) {
      const { widthPx } = picture.canvas.value;
      const heightPx = Math.min(picture.canvas.value.heightPx, abovePx - (boxNow()?.top ?? 0));
      const inMm = (x: number, y: number): Vec => intoArena(toMm(picture.view.value, { x, y }), course().size);
      return middleBetween(inMm(0, 0), inMm(widthPx, heightPx));
    },
    reachMm: () => surface.reachMm,
    show: (atMm) => picture.showPlace(atMm),
  };
}
