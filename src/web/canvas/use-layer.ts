import { onBeforeUnmount, type ShallowRef } from 'vue';
import type { CanvasSize } from './view-transform';
import { createFrameGate } from './frame-gate';

/** A canvas and how to paint all of it. */
export interface Layer {
  readonly canvas: Readonly<ShallowRef<HTMLCanvasElement | null>>;
  readonly size: () => CanvasSize;
  /** Canvas pixels per CSS px. */
  readonly ratio: () => number;
  /** Paints in CSS px. */
  readonly paint: (context: CanvasRenderingContext2D) => void;
}

/**
 * Keeps a canvas as large as its place on the screen and paints it when asked, at most once per frame.
 *
 * @returns asks for the layer to be painted
 */
export function useLayer(layer: Layer): () => void {
  const paint = (): void => {
    const canvas = layer.canvas.value;
    const context = canvas?.getContext('2d') ?? null;
    if (canvas === null || context === null) return;
    const ratio = layer.ratio();
    const width = Math.round(layer.size().widthPx * ratio);
    const height = Math.round(layer.size().heightPx * ratio);
    if (canvas.width !== width) canvas.width = width;
    if (canvas.height !== height) canvas.height = height;
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    layer.paint(context);
  };
  const gate = createFrameGate(
    paint,
    (callback) => requestAnimationFrame(callback),
    (handle) => cancelAnimationFrame(handle),
  );
  onBeforeUnmount(() => gate.close());
  return () => gate.soon();
}
