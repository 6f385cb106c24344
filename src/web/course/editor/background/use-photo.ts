import { computed, shallowRef } from 'vue';

import type { Background, Point } from '#scene/scene';

import type { FloorSize } from './fit-background';
import { floorOf, previewCells } from './photo-floor';
import { canvasOf, scaled } from './picture-of';
import { quarterTurned, type Pixels } from './pixels';
import { quarterTurnedQuad, turnedQuad, wholeOf, withCorner, withSide, type Quad } from './quad';
import type { OpenedPicture } from './read-image';
import { goodThreshold, evenedIf, levelsOf } from './sensor-view';

/** Longest side of the picture from which the preview is made, and of the preview; in pixels and cells. */
const [SMALL_PX, PREVIEW_CELLS] = [640, 320];

/** A picture that is becoming the floor: which part of it, how it is turned, and how the sensors see it. */
export function usePhoto({ pixels, isPhoto }: OpenedPicture) {
  const picture = shallowRef(pixels);
  /** The part before it is turned finely. */
  const base = shallowRef<Quad>(wholeOf(pixels));
  const turnDeg = shallowRef(0);
  const quad = computed(() =>
    turnDeg.value === 0 ? base.value : turnedQuad(base.value, turnDeg.value, picture.value),
  );
  const steps = shallowRef<'line' | 'greys'>(isPhoto ? 'line' : 'greys');
  const isEven = shallowRef(isPhoto);
  const ownThreshold = shallowRef<number | null>(null);
  const size = shallowRef<FloorSize>('fit');
  const showsPicture = shallowRef(true);

  const small = computed(() => shrunk(picture.value));
  const cells = computed(() =>
    evenedIf(previewCells(small.value.pixels, small.value.scale, quad.value, PREVIEW_CELLS), isEven.value),
  );
  /** Found in the picture until it is set by hand. */
  const thresholdPercent = computed(() => ownThreshold.value ?? goodThreshold(cells.value));
  const view = computed(() => ({
    steps: steps.value,
    thresholdPercent: thresholdPercent.value,
    isEven: isEven.value,
  }));

  /** Makes a dragged corner count as shown: the fine turn is then part of it. */
  function settle(next: Quad): void {
    base.value = next;
    turnDeg.value = 0;
  }
  function quarterRight(): void {
    base.value = quarterTurnedQuad(base.value, picture.value);
    picture.value = quarterTurned(picture.value);
  }
  return {
    ...{ picture, quad, turnDeg, steps, isEven, size, showsPicture, thresholdPercent },
    /** A preview of the sensors' view, in few cells. */
    preview: computed(() => ({ ...cells.value, levels: levelsOf(cells.value, view.value) })),
    setThreshold: (percent: number): void => void (ownThreshold.value = percent),
    moveCorner: (index: number, to: Point): void => settle(withCorner(quad.value, index, to, picture.value)),
    moveSide: (index: number, by: Point): void => settle(withSide(quad.value, index, by, picture.value)),
    takeWhole: (): void => settle(wholeOf(picture.value)),
    quarterRight,
    quarterLeft(): void {
      for (let turn = 0; turn < 3; turn += 1) quarterRight();
    },
    /** The floor of an arena of this size. */
    floor: (arena: Point): Background =>
      floorOf(
        { pixels: picture.value, isPhoto },
        { quad: quad.value, view: view.value, size: size.value, showsPicture: showsPicture.value },
        arena,
      ),
  };
}

/** A smaller copy of a picture, and how much smaller it is. */
function shrunk(picture: Pixels): { readonly scale: number; readonly pixels: Pixels } {
  const canvas = canvasOf(picture);
  const scale = Math.min(1, SMALL_PX / Math.max(canvas.width, canvas.height));
  const less = scaled(canvas, scale);
  return { scale, pixels: less.getContext('2d')?.getImageData(0, 0, less.width, less.height) ?? picture };
}
