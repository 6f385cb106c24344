import { back } from './back';

/** Something that lies open: a menu, a dialog, a card or panel beside the page, or a mode of the page. */
export interface Layer {
  /** Asks it to close: Escape or the browser's back button was pressed, or something beside it was clicked. */
  requestClose(by: 'escape' | 'back' | 'beside'): void;
  /** True if the browser's back button closes it. */
  readonly hasBack?: boolean;
  /** True if what it covers cannot be used meanwhile. */
  readonly covers?: boolean;
}

/** A layer over the page: a menu or a dialog. It has the keyboard. */
export interface Overlay extends Layer {
  /** True if a click there is one beside it. */
  isBeside(target: Node): boolean;
  /** The Tab key was pressed. */
  tab(event: KeyboardEvent): void;
}

interface Open {
  readonly layer: Layer;
  readonly overlay: Overlay | null;
  readonly zIndex: number;
}

/** All open layers, in the order in which they were opened: Escape closes the last one, keys and clicks go to the last overlay. */
const open: Open[] = [];
/** True if the click began beside. One that began inside and ends beside (text was selected) closes nothing. */
let beganBeside = false;

const top = (): Overlay | null => open.findLast(({ overlay }) => overlay !== null)?.overlay ?? null;
const isBesideTop = ({ target }: Event): boolean => target instanceof Node && top()?.isBeside(target) === true;

/** The program has its own use for Escape: it closes suggestions there, and lets go of the Tab key. */
const isInProgram = ({ target }: Event): boolean => target instanceof Element && target.closest('.cm-editor') !== null;

function onKeydown(event: KeyboardEvent): void {
  if (event.key === 'Tab') top()?.tab(event);
  const last = open.at(-1);
  if (event.key !== 'Escape' || event.defaultPrevented || last === undefined) return;
  if (last.overlay === null) {
    if (isInProgram(event)) return;
    event.preventDefault();
  }
  last.layer.requestClose('escape');
}

function onPress(event: Event): void {
  beganBeside = isBesideTop(event);
}

function onClick(event: Event): void {
  if (!beganBeside || !isBesideTop(event)) return;
  const overlay = top();
  // What was clicked comes first: it may still ask what is open.
  setTimeout(() => {
    if (open.some((other) => other.overlay === overlay)) overlay?.requestClose('beside');
  });
}

function listen(to: 'addEventListener' | 'removeEventListener'): void {
  window[to]('keydown', onKeydown as EventListener);
  document[to]('pointerdown', onPress, true);
  document[to]('click', onClick, true);
  document[to]('contextmenu', onClick, true);
}

/** The panes, the bar and the cards over them can be used unless a layer covers them; menus and messages always can. */
function cover(): void {
  const isCovered = open.some(({ layer }) => layer.covers === true);
  for (const part of document.querySelectorAll('.app, [data-covered]')) part.toggleAttribute('inert', isCovered);
}

function add(one: Open, isBelow = false): () => void {
  if (open.length === 0) listen('addEventListener');
  if (isBelow) open.unshift(one);
  else open.push(one);
  const closed = one.layer.hasBack === true ? back.add(() => one.layer.requestClose('back')) : null;
  cover();
  return () => {
    const at = open.indexOf(one);
    if (at === -1) return;
    open.splice(at, 1);
    closed?.();
    cover();
    if (open.length === 0) listen('removeEventListener');
  };
}

/**
 * Something lies open beside the page or in it, and Escape closes it before what was opened earlier. Below all others lies what
 * is a state of the page itself.
 *
 * @returns how to tell that it is closed
 */
export const openLayer = (layer: Layer, place: 'top' | 'below' = 'top'): (() => void) =>
  add({ layer, overlay: null, zIndex: 0 }, place === 'below');

/**
 * Puts an overlay on top of those that are open.
 *
 * @param level its `z-index` where no other is open
 * @returns the `z-index` it gets, and how to take it away
 */
export function openOverlay(overlay: Overlay, level: number): { readonly zIndex: number; readonly close: () => void } {
  const zIndex = Math.max(level, ...open.map((other) => other.zIndex + 1));
  beganBeside = false;
  return { zIndex, close: add({ layer: overlay, overlay, zIndex }) };
}
