import { computed, onBeforeUnmount, onMounted, shallowRef, watch, type ComputedRef, type ShallowRef } from 'vue';
import type { Vec } from '#core/geometry';
import {
  backingRatio,
  fitView,
  panView,
  resizeView,
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
  panBy(byPx: Vec): void;
  fit(): void;
}

/** Follows the size and the pixel ratio of an element; the arena stays fitted until it is zoomed. */
export function useArenaView(host: Readonly<ShallowRef<HTMLElement | null>>, arena: () => ArenaSize): ArenaView {
  const canvas = shallowRef<CanvasSize>({ widthPx: 600, heightPx: 450 });
  const view = shallowRef(fitView(arena(), canvas.value));
  const pixelRatio = useDevicePixelRatio();
  let fitted = true;
  const fit = (): void => {
    fitted = true;
    view.value = fitView(arena(), canvas.value);
  };
  const change = (changed: View): void => {
    const full = fitView(arena(), canvas.value).pxPerMm;
    fitted = Math.abs(changed.pxPerMm / full - 1) < 0.004; // back at 100 % but for rounding
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
  return {
    view,
    canvas,
    ratio: computed(() => backingRatio(canvas.value, pixelRatio.value)),
    percent: computed(() => zoomPercent(view.value, arena(), canvas.value)),
    zoomBy(factor, aroundPx) {
      const middle = { x: canvas.value.widthPx / 2, y: canvas.value.heightPx / 2 };
      change(zoomView(view.value, factor, aroundPx ?? middle, arena(), canvas.value));
    },
    panBy(byPx) {
      if (!fitted) view.value = panView(view.value, byPx, arena(), canvas.value);
    },
    fit,
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
