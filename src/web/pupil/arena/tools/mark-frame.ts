import type { Palette } from '../model/palette';
import type { ArenaSize, CanvasSize, View } from '../view/view-transform';

/** The frame in which marks are drawn. */
export interface MarkFrame {
  readonly view: View;
  readonly canvas: CanvasSize;
  readonly arena: ArenaSize;
  readonly palette: Palette;
}
