import { defineAsyncComponent, type Component } from 'vue';

/** How a board is drawn. */
export interface BoardDrawing {
  /** Width by height. */
  readonly aspect: number;
  /** The drawing; loaded when it is first shown. Takes `FaceProps`. */
  readonly face: Component;
}

/** Most requests for a drawing when the network fails, and the time before the next one, in ms. */
const TRIES = 4;
const RETRY_MS = 1500; // chosen: a wireless network in a classroom comes back after a second or two

const microbit: BoardDrawing = {
  aspect: 260 / 214,
  face: lazy(() => import('./MicrobitView.vue')),
};

const calliope: BoardDrawing = {
  aspect: 252 / 226,
  face: lazy(() => import('./CalliopeView.vue')),
};

const drawings: Readonly<Record<string, BoardDrawing>> = {
  'microbit-v2': microbit,
  'calliope-mini-3': calliope,
};

/** The drawing of the board type with this id; that of the micro:bit for one that has no drawing. */
export function drawingOf(board: string): BoardDrawing {
  return drawings[board] ?? microbit;
}

function lazy(loader: () => Promise<{ readonly default: Component }>): Component {
  return defineAsyncComponent({
    loader,
    onError(_error, retry, fail, attempts) {
      if (attempts < TRIES) setTimeout(retry, RETRY_MS);
      else fail();
    },
  });
}
