import { onBeforeUnmount, type ShallowRef } from 'vue';
import { createFrameGate } from '../../page/drawing/frame-gate';
import type { PxBox } from './moving-window';

/** A canvas and how to paint all of it. */
export interface Layer {
  readonly canvas: Readonly<ShallowRef<HTMLCanvasElement | null>>;
  /** Canvas pixels per CSS px. */
  readonly ratio: () => number;
  /** What part of the arena's place on the page the canvas covers; asked before each painting. */
  readonly place: () => PxBox;
  /** Paints in CSS px of the arena's place; the canvas is empty before, and its state is put back afterwards. */
  readonly paint: (context: CanvasRenderingContext2D) => void;
}

/**
 * Keeps a canvas on its place on the page and paints it when asked, at most once per frame.
 *
 * @returns asks for the layer to be painted
 */
export function useLayer(layer: Layer): () => void {
  const paint = (): void => {
    const canvas = layer.canvas.value;
    const context = canvas?.getContext('2d') ?? null;
    if (canvas === null || context === null) return;
    const ratio = layer.ratio();
    const place = layer.place();
    putOn(canvas, place, ratio);
    context.setTransform(ratio, 0, 0, ratio, -place.left * ratio, -place.top * ratio);
    context.clearRect(place.left, place.top, place.width, place.height);
    context.save();
    layer.paint(context);
    context.restore();
  };
  const gate = createFrameGate(
    paint,
    (callback) => requestAnimationFrame(callback),
    (handle) => cancelAnimationFrame(handle),
  );
  onBeforeUnmount(() => gate.close());
  return () => gate.soon();
}

function putOn(canvas: HTMLCanvasElement, place: PxBox, ratio: number): void {
  const width = Math.round(place.width * ratio);
  const height = Math.round(place.height * ratio);
  if (canvas.width !== width) canvas.width = width;
  if (canvas.height !== height) canvas.height = height;
  setStyle(canvas, 'width', `${String(place.width)}px`);
  setStyle(canvas, 'height', `${String(place.height)}px`);
  setStyle(canvas, 'transform', `translate(${String(place.left)}px, ${String(place.top)}px)`);
}

/** Writing costs even where nothing changes. */
function setStyle(canvas: HTMLCanvasElement, name: 'width' | 'height' | 'transform', value: string): void {
  if (canvas.style[name] !== value) canvas.style[name] = value;
}
