/**
 * Fills in what the oldest browsers lack. The first import of the page and of the worker: what comes after may use it
 * while it is loaded.
 */
import { fill, ofCanvas, ofEveryList, ofLists, ofObjects, ofSignals } from './methods';

/** A worker has no canvas, and what it has to stop it hears in messages. */
const { CanvasRenderingContext2D: Canvas, AbortSignal: Signal }: Partial<typeof globalThis> = globalThis;

fill(Array.prototype, { ...ofEveryList, ...ofLists });
fill(Object.getPrototypeOf(Uint8Array.prototype) as object, ofEveryList);
fill(Object, ofObjects);
fill(Signal?.prototype, ofSignals);
fill(Canvas?.prototype, ofCanvas);
