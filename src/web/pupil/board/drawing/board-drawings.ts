import type { Component } from 'vue';

import { lateView } from '../../../kit/late-view';

/** How a board is drawn. */
export interface BoardDrawing {
  /** Width by height. */
  readonly aspect: number;
  /** The drawing; loaded when it is first shown. Takes `FaceProps`. */
  readonly face: Component;
}

const microbit: BoardDrawing = {
  aspect: 260 / 214,
  face: lateView<Component>(() => import('./MicrobitView.vue')),
};

const calliope: BoardDrawing = {
  aspect: 252 / 226,
  face: lateView<Component>(() => import('./CalliopeView.vue')),
};

const drawings: Readonly<Record<string, BoardDrawing>> = {
  'microbit-v2': microbit,
  'calliope-mini-3': calliope,
};

/** The drawing of the board type with this id; that of the micro:bit for one that has no drawing. */
export function drawingOf(board: string): BoardDrawing {
  return drawings[board] ?? microbit;
}
