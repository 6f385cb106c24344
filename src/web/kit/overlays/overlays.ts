/** An overlay of the page: a menu or a dialog. */
export interface Overlay {
  /** True if a click there is one beside it. */
  isBeside(target: Node): boolean;
  /** Asks it to close: Escape was pressed, or something beside it was clicked. */
  requestClose(by: 'escape' | 'beside'): void;
  /** The Tab key was pressed. */
  tab(event: KeyboardEvent): void;
}

interface Shown {
  readonly overlay: Overlay;
  readonly zIndex: number;
}

/** All open overlays, in the order in which they were opened: the last one is on top, and gets keys and clicks. */
const shown: Shown[] = [];
/** True if the click began beside. One that began inside and ends beside (text was selected) closes nothing. */
let beganBeside = false;

const top = (): Overlay | undefined => shown.at(-1)?.overlay;
const isBesideTop = ({ target }: Event): boolean => target instanceof Node && top()?.isBeside(target) === true;

function onKeydown(event: KeyboardEvent): void {
  if (event.key === 'Escape') top()?.requestClose('escape');
  else if (event.key === 'Tab') top()?.tab(event);
}

function onPress(event: Event): void {
  beganBeside = isBesideTop(event);
}

function onClick(event: Event): void {
  if (!beganBeside || !isBesideTop(event)) return;
  const overlay = top();
  // What was clicked comes first: it may still ask what is open.
  setTimeout(() => {
    if (shown.some((other) => other.overlay === overlay)) overlay?.requestClose('beside');
  });
}

function listen(to: 'addEventListener' | 'removeEventListener'): void {
  window[to]('keydown', onKeydown as EventListener);
  document[to]('pointerdown', onPress, true);
  document[to]('click', onClick, true);
  document[to]('contextmenu', onClick, true);
}

/**
 * Puts an overlay on top of those that are open.
 *
 * @param level its `z-index` where no other is open
 * @returns the `z-index` it gets, and how to take it away
 */
export function openOverlay(overlay: Overlay, level: number): { readonly zIndex: number; readonly close: () => void } {
  const one = { overlay, zIndex: Math.max(level, (shown.at(-1)?.zIndex ?? 0) + 1) };
  if (shown.length === 0) listen('addEventListener');
  beganBeside = false;
  shown.push(one);
  const close = (): void => {
    const at = shown.indexOf(one);
    if (at === -1) return;
    shown.splice(at, 1);
    if (shown.length === 0) listen('removeEventListener');
  };
  return { zIndex: one.zIndex, close };
}
