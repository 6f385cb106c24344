import type { Pose } from '#core/geometry';
import { isSame } from '#core/same';
import { tagSheetMm } from '#scene/kinds/tag-thing';
import type { CarriedTag } from '#scene/kinds/stuck-tags';
import { clipTo } from '../view/clip-to';
import { boxAround, roomyWindow, type PxBox } from '../view/moving-window';
import type { Palette } from '../model/palette';
import type { SceneKinds } from '../picture/scene-kinds';
import { toPx, type View } from '../view/view-transform';

/** The view in which carried tags are shown. */
export interface TagFrame {
  readonly view: View;
  /** The part of the canvas in which they are painted. */
  readonly sight: PxBox;
  /** Canvas pixels per CSS px. */
  readonly ratio: number;
  readonly palette: Palette;
  readonly kinds: Pick<SceneKinds, 'carriedTag'>;
}

/** Shows tags where their blocks or obstacles carry them. */
export interface TagSprites {
  /** Shows these tags, and no others, in a view. */
  prepare(tags: readonly CarriedTag[], frame: TagFrame): void;
  /** Paints those whose thing has moved. @param poses of the blocks and obstacles, by their ids */
  paint(poses: Readonly<Record<string, Pose>>): void;
}

interface Shown {
  readonly one: CarriedTag;
  readonly canvas: HTMLCanvasElement;
  readonly halfPx: number;
  window: PxBox | undefined;
  /** The thing's pose when it was last painted; `undefined`: not yet. */
  pose: Pose | null | undefined;
}

/** Room for the arrow and the number before a tag, in mm and in px: numbers are never too small to be read. */
const LABEL = { mm: 65, px: 55 };

/** @param host the element for their canvases, which have room to move in as those of pushed blocks */
export function createTagSprites(host: () => HTMLElement | null): TagSprites {
  let all: readonly Shown[] = [];
  let frame: TagFrame | null = null;

  function show(shown: Shown, pose: Pose | null, { view, sight, ratio, palette, kinds }: TagFrame): void {
    const { one, canvas, halfPx } = shown;
    const { xMm, yMm } = pose ?? one.shifted ?? { xMm: one.tag.at[0], yMm: one.tag.at[1] };
    const window = roomyWindow(boxAround(toPx(view, { x: xMm, y: yMm }), halfPx), ratio, shown.window);
    if (window !== shown.window) putOn(canvas, window, ratio);
    [shown.window, shown.pose] = [window, pose];
    const context = canvas.getContext('2d');
    if (context === null) return;
    context.setTransform(ratio, 0, 0, ratio, -window.left * ratio, -window.top * ratio);
    context.clearRect(window.left, window.top, window.width, window.height);
    context.save();
    clipTo(context, sight);
    kinds.carriedTag(context, view, one, pose, palette);
    context.restore();
  }
  return {
    prepare(tags, next) {
      frame = next;
      const before = new Map(all.map(({ one, canvas }) => [one.tag.id, canvas]));
      all = tags.map((one) => {
        const canvas = before.get(one.tag.id) ?? document.createElement('canvas');
        before.delete(one.tag.id);
        if (!canvas.isConnected) host()?.append(canvas);
        return { one, canvas, halfPx: reachPx(one, next.view), window: undefined, pose: undefined };
      });
      for (const canvas of before.values()) canvas.remove();
    },
    paint(poses) {
      if (frame === null) return;
      for (const shown of all) {
        const pose = poses[shown.one.carrier.id] ?? null;
        if (!isSame(shown.pose, pose)) show(shown, pose, frame);
      }
    },
  };
}

/** How far a tag reaches from the middle of its thing. */
function reachPx({ tag, carrier }: CarriedTag, { pxPerMm }: View): number {
  const label = Math.max(LABEL.mm * pxPerMm, LABEL.px);
  return Math.ceil((Math.hypot(carrier.tag.xMm, carrier.tag.yMm) + tagSheetMm(tag.side) / 2) * pxPerMm + label);
}

function putOn(canvas: HTMLCanvasElement, { left, top, width }: PxBox, ratio: number): void {
  const side = Math.ceil(width * ratio);
  if (canvas.width !== side) canvas.width = canvas.height = side;
  canvas.style.width = canvas.style.height = `${String(side / ratio)}px`;
  canvas.style.transform = `translate(${String(left)}px, ${String(top)}px)`;
}
