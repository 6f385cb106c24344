import type { PaintColor } from '#scene/paint/paint';

/** The colours of every day, and those for whoever asks, in the order of the swatches. */
export const usualSwatches = ['red', 'orange', 'yellow', 'green', 'blue', 'purple', 'gray', 'black'] as const satisfies readonly PaintColor[]; // prettier-ignore
export const moreSwatches = ['white', 'brown', 'silver'] as const satisfies readonly PaintColor[];
