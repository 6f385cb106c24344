import type { ShallowRef } from 'vue';
import type { PlacedBlock } from '../model/arena-model';
import { lieStill, liesStill } from '../picture/arranged';
import { createBlockSprites } from './block-sprites';
import { sightPx } from '../picture/draw-floor';
import { drawBlocks, type MovingScene } from './draw-moving';
import { clipTo } from '../view/clip-to';
import { useViewRest } from '../picture/kept-picture';
import { wholeCanvas } from '../view/moving-window';
import type { Palette } from '../model/palette';
import { createStillCache } from '../picture/still-cache';
import type { ArenaView } from '../view/use-arena-view';
import { useLayer } from '../view/use-layer';

/** Sources of the layer of blocks. */
export interface BlockSources {
  readonly canvas: Readonly<ShallowRef<HTMLCanvasElement | null>>;
  /** Over the canvas: blocks that have moved lately are put here. */
  readonly pushed: Readonly<ShallowRef<HTMLElement | null>>;
  readonly picture: ArenaView;
  readonly palette: () => Palette;
  readonly scene: () => MovingScene;
}

/** The layer of the blocks that nothing holds. */
export interface BlocksLayer {
  /** Requests a repaint of the layer: the view has changed. */
  draw(): void;
  /** Shows the blocks of a new picture. */
  update(scene: MovingScene): void;
}

/** From this number of blocks on, those at rest are cached as a picture. Chosen: fewer are painted in 2 ms. */
const MANY = 40;

/** At most this many blocks have a canvas of their own. Chosen: far more would cost as much as painting all. */
const MOST_PUSHED = 24;

/** Draws the blocks that nothing holds: recently moved ones on canvases of their own, the others on a large one. */
export function useBlocksLayer(sources: BlockSources): BlocksLayer {
  const { picture } = sources;
  const cache = createStillCache<PlacedBlock>(liesStill);
  const rest = useViewRest(() => draw());
  const parted = createRestSplitter();
  const sprites = createBlockSprites(() => sources.pushed.value);
  let lying: readonly PlacedBlock[] = [];
  let pushed: readonly PlacedBlock[] = [];
  const frame = () => ({
    view: picture.view.value,
    canvas: picture.canvas.value,
    ratio: picture.ratio.value,
    palette: sources.palette(),
  });
  const draw = useLayer({
    canvas: sources.canvas,
    ratio: () => picture.ratio.value,
    place: () => wholeCanvas(picture.canvas.value),
    paint(context) {
      const { arena } = sources.scene();
      const now = frame();
      const paint = (on: CanvasRenderingContext2D, some: readonly PlacedBlock[]): void =>
        drawBlocks(on, now.view, some, now.palette);
      clipTo(context, sightPx(now.view, arena, now.canvas));
      if (lying.length < MANY) paint(context, lying);
      else if (!cache.draw(context, { ...now, look: null }, lying, paint, rest.settled({ ...now, look: null })))
        rest.sharpenSoon();
      sprites.show(pushed, { ...now, arena });
      sprites.keepOnly(pushed); // only after the others are painted, so that nothing flickers
    },
  });
  return {
    draw,
    update({ blocks, heldBlock, arena }) {
      const { still, restless } = parted(heldBlock === null ? blocks : blocks.filter(({ id }) => id !== heldBlock));
      const before = pushed.length;
      const lain = restless.length > MOST_PUSHED ? [...still, ...restless.slice(MOST_PUSHED)] : still;
      pushed = restless.slice(0, MOST_PUSHED);
      sprites.show(pushed, { ...frame(), arena });
      if (before === pushed.length && lieStill(lying, lain)) return;
      lying = lain;
      draw();
    },
  };
}

/** Consecutive pictures without movement after which a block counts as at rest. */
const LIES_AFTER = 30;

/** Separates blocks that have moved recently from those at rest; to be called once per picture. */
export function createRestSplitter() {
  let before = new Map<string, PlacedBlock>();
  const stirred = new Map<string, number>();
  let count = 0;
  let shown: readonly PlacedBlock[] = [];
  return (blocks: readonly PlacedBlock[]): { still: readonly PlacedBlock[]; restless: readonly PlacedBlock[] } => {
    if (stirred.size === 0 && lieStill(shown, blocks)) return { still: shown, restless: [] };
    shown = blocks;
    count += 1;
    for (const block of blocks) {
      const last = before.get(block.id);
      if (last !== undefined && !liesStill(last, block)) stirred.set(block.id, count);
    }
    before = new Map(blocks.map((block) => [block.id, block]));
    for (const [id, at] of stirred) if (count - at > LIES_AFTER || !before.has(id)) stirred.delete(id);
    if (stirred.size === 0) return { still: blocks, restless: [] };
    return {
      still: blocks.filter(({ id }) => !stirred.has(id)),
      restless: blocks.filter(({ id }) => stirred.has(id)),
    };
  };
}
