import { onBeforeUnmount, type ShallowRef } from 'vue';
import { createFrameGate } from '../../../kit/drawing/frame-gate';
import type { PxBox } from './moving-window';

/** A canvas and how to paint all of it. */
export interface Layer {
  readonly canvas: Readonly<ShallowRef<HTMLCanvasElement | null>>;
  /** Canvas pixels per CSS px. */
  readonly ratio: () => number;
  /** The part of the arena's place on the page that the canvas covers; read before each painting. */
  readonly place: () => PxBox;
  /** Paints in CSS px of the arena's place; the canvas is empty before, and its state is put back afterwards. */
  readonly paint: (context: CanvasRenderingContext2D) => void;
}

/**
 * Holds a canvas at its place on the page and paints it on request, at most once per frame.
 *
 * @returns a function that requests a repaint of the layer
 */
export function useLayer(layer: Layer): () => void {
  let on: Put | null = null;
  const paint = (): void => {
    const canvas = layer.canvas.value;
    if (canvas === null) return;
    if (on?.canvas !== canvas) on = { canvas, context: canvas.getContext('2d'), at: '' };
    const { context } = on;
    if (context === null) return;
    const ratio = layer.ratio();
    const place = layer.place();
    put(on, place, ratio);
    context.setTransform(ratio, 0, 0, ratio, -place.left * ratio, -place.top * ratio);
    context.clearRect(place.left, place.top, place.width, place.height);
    context.save();
    layer.paint(context);
    context.restore();
  };
  const gate = createFrameGate(paint);
  onBeforeUnmount(() => gate.close());
  return () => gate.soon();
}

/** A canvas at its place. */
interface Put {
  readonly canvas: HTMLCanvasElement;
  readonly context: CanvasRenderingContext2D | null;
  at: string;
}

/** Puts a canvas at its place if that has changed: writing and even reading its style is slow. */
function put(on: Put, { left, top, width, height }: PxBox, ratio: number): void {
  const at = [left, top, width, height, ratio].join();
  if (at === on.at) return;
  on.at = at;
  const { canvas } = on;
  const pixels = { width: Math.round(width * ratio), height: Math.round(height * ratio) };
  if (canvas.width !== pixels.width) canvas.width = pixels.width;
  if (canvas.height !== pixels.height) canvas.height = pixels.height;
  canvas.style.width = `${String(width)}px`;
  canvas.style.height = `${String(height)}px`;
  canvas.style.transform = `translate(${String(left)}px, ${String(top)}px)`;
}
