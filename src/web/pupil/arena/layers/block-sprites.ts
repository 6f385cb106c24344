import type { PlacedBlock } from '../model/arena-model';
import { liesStill } from '../picture/arranged';
import { drawMovableBlock } from '../picture/draw-bodies';
import { sightPx } from '../picture/draw-floor';
import { clipTo } from '../view/clip-to';
import { spriteSquare } from './sprite-square';
import { boxAround, roomyWindow, type PxBox } from '../view/moving-window';
import type { Palette } from '../model/palette';
import { toPx, type ArenaSize, type CanvasSize, type View } from '../view/view-transform';

/** The view and the pixel ratio in which blocks are shown. */
export interface SpriteFrame {
  readonly view: View;
  readonly canvas: CanvasSize;
  /** Canvas pixels per CSS px. */
  readonly ratio: number;
  readonly palette: Palette;
  readonly arena: ArenaSize;
}

/**
 * Blocks that are being pushed, each on a little canvas with room to move in. One canvas as large as the arena would
 * have to be painted for each picture, and a canvas that follows its block has the browser sort all layers of the page.
 */
export interface BlockSprites {
  /** Shows these blocks where they are now; those shown before stay. */
  show(blocks: readonly PlacedBlock[], frame: SpriteFrame): void;
  /** Takes all others away: they are painted elsewhere. */
  keepOnly(blocks: readonly PlacedBlock[]): void;
}

interface Shown {
  readonly element: HTMLCanvasElement;
  readonly window: PxBox;
  readonly block: PlacedBlock;
  readonly frame: SpriteFrame;
}

/** @param host the element for the little canvases: above the layer of blocks at rest */
export function createBlockSprites(host: () => HTMLElement | null): BlockSprites {
  const all = new Map<string, Shown>();
  return {
    show(blocks, frame) {
      const on = host();
      if (on === null) return;
      for (const block of blocks) {
        const before = all.get(block.id);
        if (before !== undefined && liesStill(before.block, block) && isSameFrame(before.frame, frame)) continue;
        const element = before?.element ?? document.createElement('canvas');
        const window = blockWindow(block, frame, before);
        if (window !== before?.window) putOn(element, window, frame.ratio);
        if (before === undefined) on.append(element);
        paint(element, window, block, frame);
        all.set(block.id, { element, window, block, frame });
      }
    },
    keepOnly(blocks) {
      if (all.size === 0) return;
      const kept = new Set(blocks.map(({ id }) => id));
      for (const [id, { element }] of all)
        if (!kept.has(id)) {
          element.remove();
          all.delete(id);
        }
    },
  };
}

const isSameFrame = (one: SpriteFrame, other: SpriteFrame): boolean =>
  one.view === other.view &&
  one.canvas === other.canvas &&
  one.ratio === other.ratio &&
  one.palette === other.palette &&
  one.arena === other.arena;

/** Place of a block's canvas; the same object as before while the block has room on it. */
function blockWindow({ pose, sizeMm }: PlacedBlock, frame: SpriteFrame, before: Shown | undefined): PxBox {
  const { view, ratio } = frame;
  const size = [sizeMm.x, sizeMm.y] as const;
  const half = spriteSquare({ at: [0, 0], size }, view.pxPerMm).sidePx / 2;
  const content = boxAround(toPx(view, { x: pose.xMm, y: pose.yMm }), half);
  return roomyWindow(content, ratio, before?.frame.ratio === ratio ? before.window : undefined);
}

function putOn(element: HTMLCanvasElement, { left, top, width }: PxBox, ratio: number): void {
  const side = Math.ceil(width * ratio);
  if (element.width !== side) element.width = element.height = side;
  element.style.width = element.style.height = `${String(side / ratio)}px`;
  element.style.transform = `translate(${String(left)}px, ${String(top)}px)`;
}

function paint(element: HTMLCanvasElement, window: PxBox, block: PlacedBlock, frame: SpriteFrame): void {
  const context = element.getContext('2d');
  if (context === null) return;
  const { view, ratio, palette } = frame;
  context.setTransform(ratio, 0, 0, ratio, -window.left * ratio, -window.top * ratio);
  context.clearRect(window.left, window.top, element.width, element.height);
  context.save();
  clipTo(context, sightPx(view, frame.arena, frame.canvas));
  drawMovableBlock(context, view, block, false, palette);
  context.restore();
}
