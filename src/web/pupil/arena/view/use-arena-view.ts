import { computed, onBeforeUnmount, onMounted, shallowRef, watch, type ComputedRef, type ShallowRef } from 'vue';
import type { Vec } from '#core/geometry';
import type { Stop } from '#core/stop';
import { boundsOf, reachesInto } from '#scene/kinds/index';
import type { Bounds } from '#scene/outline';
import type { Scene } from '#scene/scene';
import type { MovedThings } from './near-view';
import {
  backingRatio,
  boxView,
  fitView,
  followView,
  panView,
  placeView,
  resizeView,
  toPx,
  withArena,
  zoomPercent,
  zoomView,
  type ArenaSize,
  type CanvasSize,
  type View,
} from './view-transform';

/** The view of the arena in an element of the page, and how to change it. */
export interface ArenaView {
  readonly view: Readonly<ShallowRef<View>>;
  readonly canvas: Readonly<ShallowRef<CanvasSize>>;
  /** Canvas pixels per CSS px. */
  readonly ratio: ComputedRef<number>;
  /** 100 shows the whole arena. */
  readonly percent: ComputedRef<number>;
  /** Zooms around a place in CSS px, by default the middle. */
  zoomBy(factor: number, aroundPx?: Vec): void;
  /** Moves the picture by hand; does nothing while the whole arena is shown. */
  panBy(byPx: Vec): void;
  /** Shows the whole arena. */
  fit(): void;
  /** Shows the whole arena and everything outside of it. */
  showAll(course: Pick<Scene, 'objects' | 'size'>): void;
  /** Shows a rectangle (world mm) with some room around it. */
  showBox(box: Bounds): void;
  /** Shows the arena at about its real size, based on the browser's idea of an inch. */
  showTrueSize(): void;
  /**
   * Brings a place (world mm; `null`: there is none) into the middle, and everything up to the nearest obstacle into
   * sight.
   */
  showNear(atMm: Vec | null, around: Pick<Scene, 'objects' | 'size'>, now: MovedThings): void;
  /** Brings a place (world mm) into sight and lets it flash. */
  showPlace(atMm: Vec): void;
  /**
   * Moves on towards a place (world mm) that is to stay in the middle third.
   *
   * @param elapsedMs since the last step
   * @returns whether the picture moved
   */
  follow(atMm: Vec, elapsedMs: number): boolean;
}

/** CSS px per mm: 96 to an inch (CSS Values and Units 4, 6.2); screens differ from that by some percent. */
const TRUE_PX_PER_MM = 96 / 25.4;

/** Room around the shown thing, as a share of its longer side, and in mm at least. Chosen by eye. */
const [ROOM_SHARE, LEAST_ROOM_MM] = [0.2, 40];

/** The part of a rectangle that lies in the arena. */
const intoArena = ({ minX, minY, maxX, maxY }: Bounds, [width, height]: ArenaSize): Bounds => ({
  minX: Math.max(0, minX),
  minY: Math.max(0, minY),
  maxX: Math.min(width, maxX),
  maxY: Math.min(height, maxY),
});

/** Time to cover two thirds of the distance to the followed thing, in ms. Chosen by eye: glides without lag. */
const FOLLOW_MS = 140;

/**
 * Follows the size and the pixel ratio of an element; the arena stays fitted until it is zoomed.
 *
 * @param panned called when the picture was moved by hand
 */
export function useArenaView(
  host: Readonly<ShallowRef<HTMLElement | null>>,
  arena: () => ArenaSize,
  panned: () => void = () => undefined,
): ArenaView {
  const canvas = shallowRef<CanvasSize>({ widthPx: 600, heightPx: 450 });
  const view = shallowRef(fitView(arena(), canvas.value));
  const pixelRatio = useDevicePixelRatio();
  const flash = createFlash();
  let fitted = true;
  const fit = (): void => {
    fitted = true;
    view.value = fitView(arena(), canvas.value);
  };
  const change = (changed: View): void => {
    const full = fitView(arena(), canvas.value).pxPerMm;
    fitted = Math.abs(changed.pxPerMm / full - 1) < 0.004; // back at 100 % except for rounding
    view.value = changed;
    if (fitted) fit();
  };
  useElementSize(host, (size) => {
    const before = canvas.value;
    canvas.value = size;
    if (fitted) fit();
    else view.value = resizeView(view.value, arena(), before, size);
  });
  watch(() => arena().join(), fit);
  const ratio = computed(() => backingRatio(canvas.value, pixelRatio.value));
  return {
    view,
    canvas,
    ratio,
    percent: computed(() => zoomPercent(view.value, arena(), canvas.value)),
    zoomBy(factor, aroundPx) {
      const middle = { x: canvas.value.widthPx / 2, y: canvas.value.heightPx / 2 };
      change(zoomView(view.value, factor, aroundPx ?? middle, arena(), canvas.value));
    },
    panBy(byPx) {
      if (fitted) return;
      view.value = panView(view.value, byPx, arena(), canvas.value);
      panned();
    },
    fit,
    ...looks({ view, canvas, arena, change, fit }),
    showPlace(atMm) {
      const shown = placeView(view.value, atMm, arena(), canvas.value);
      if (shown !== view.value) change(shown);
      if (host.value !== null) flash(host.value, () => toPx(view.value, atMm), view);
    },
    follow(atMm, elapsedMs) {
      if (fitted) return false;
      const share = 1 - Math.exp(-elapsedMs / FOLLOW_MS);
      const moved = followView(view.value, atMm, arena(), canvas.value, share, ratio.value);
      if (moved === view.value) return false;
      view.value = moved;
      return true;
    },
  };
}

/** The views that show something in particular. */
function looks({
  view,
  canvas,
  arena,
  change,
  fit,
}: Pick<ArenaView, 'view' | 'canvas' | 'fit'> & {
  readonly arena: () => ArenaSize;
  readonly change: (changed: View) => void;
}): Pick<ArenaView, 'showAll' | 'showBox' | 'showTrueSize' | 'showNear'> {
  return {
    showAll({ objects, size }) {
      const outside = objects.filter((object) => !reachesInto(object, size)).map(boundsOf);
      if (outside.length === 0) fit();
      else change(boxView(withArena(outside, size), arena(), canvas.value));
    },
    showBox({ minX, minY, maxX, maxY }) {
      const roomMm = Math.max(LEAST_ROOM_MM, Math.max(maxX - minX, maxY - minY) * ROOM_SHARE);
      const box = { minX: minX - roomMm, minY: minY - roomMm, maxX: maxX + roomMm, maxY: maxY + roomMm };
      const [width, height] = arena();
      const isOutside = maxX < 0 || maxY < 0 || minX > width || minY > height;
      change(boxView(isOutside ? box : intoArena(box, arena()), arena(), canvas.value));
    },
    showTrueSize() {
      const middle = { x: canvas.value.widthPx / 2, y: canvas.value.heightPx / 2 };
      change(zoomView(view.value, TRUE_PX_PER_MM / view.value.pxPerMm, middle, arena(), canvas.value));
    },
    showNear(atMm, { objects, size }, now) {
      if (atMm === null) return;
      import('./near-view').then(
        ({ nearestMm, nearView }) => change(nearView(atMm, nearestMm(atMm, objects, size, now), arena(), canvas.value)),
        () => undefined, // no connection just now: pressed again
      );
    },
  };
}

/** Loads the pointing ring when it is first wanted. It points out one place at a time. */
function createFlash(): (host: HTMLElement, place: () => Vec, view: ShallowRef<View>) => void {
  let stop: Stop = () => undefined;
  return (host, place, view) => {
    import('./flash-place').then(
      ({ flashAt }) => {
        stop();
        stop = flashAt(host, place, view);
      },
      () => undefined, // without a connection the place is in sight all the same
    );
  };
}

function useElementSize(host: Readonly<ShallowRef<HTMLElement | null>>, resized: (size: CanvasSize) => void): void {
  const observer = new ResizeObserver((entries) => {
    const box = entries[entries.length - 1]?.contentRect;
    if (box !== undefined && box.width > 0 && box.height > 0)
      resized({ widthPx: Math.floor(box.width), heightPx: Math.floor(box.height) });
  });
  onMounted(() => {
    if (host.value !== null) observer.observe(host.value);
  });
  onBeforeUnmount(() => observer.disconnect());
}

/** The screen's pixel ratio; it changes with the browser's zoom and when a window moves to another screen. */
function useDevicePixelRatio(): Readonly<ShallowRef<number>> {
  const ratio = shallowRef(window.devicePixelRatio);
  let query: MediaQueryList | null = null;
  const follow = (): void => {
    query?.removeEventListener('change', follow);
    ratio.value = window.devicePixelRatio;
    query = window.matchMedia(`(resolution: ${String(ratio.value)}dppx)`);
    query.addEventListener('change', follow);
  };
  onMounted(follow);
  onBeforeUnmount(() => query?.removeEventListener('change', follow));
  return ratio;
}
