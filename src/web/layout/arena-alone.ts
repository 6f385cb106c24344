import { onScopeDispose, readonly, shallowRef, watch, type ShallowRef } from 'vue';

import '../arena/arena-alone.css';

/** Whether the arena has the whole screen, as for a projector. The page has one arena, so this is said once. */
const isAlone = shallowRef(false);

/** The arena alone on the screen, and back. */
export interface ArenaAlone {
  readonly isAlone: Readonly<ShallowRef<boolean>>;
  /** Fills the screen; the window only, where the browser does not give the screen away. */
  enter(): void;
  leave(): void;
}

/** For controls in the arena's pane: when the last of them goes, the page comes back. */
export function useArenaAlone(): ArenaAlone {
  users += 1;
  if (users === 1) listen(true);
  onScopeDispose(() => {
    users -= 1;
    if (users > 0) return;
    leave();
    listen(false);
  });
  return { isAlone: readonly(isAlone), enter, leave };
}
let users = 0;

// With the state, so that nothing on the page can be seen or reached behind the arena.
watch(isAlone, (alone) => document.documentElement.classList.toggle('arena-alone', alone), { flush: 'sync' });

function enter(): void {
  isAlone.value = true;
  // The whole document, not the pane: menus and dialogs hang elsewhere in it.
  const root: Partial<Pick<Element, 'requestFullscreen'>> = document.documentElement; // an iPhone has no such thing
  root.requestFullscreen?.({ navigationUI: 'hide' }).catch(() => undefined); // refused in many frames: the window will do
}

function leave(): void {
  isAlone.value = false;
  if (document.fullscreenElement !== null) document.exitFullscreen().catch(() => undefined);
}

function listen(on: boolean): void {
  if (on) {
    addEventListener('keydown', onKey);
    document.addEventListener('fullscreenchange', onChange);
  } else {
    removeEventListener('keydown', onKey);
    document.removeEventListener('fullscreenchange', onChange);
  }
}

/** The browser itself leads back with Escape: nothing is left to do but to follow. */
function onChange(): void {
  if (document.fullscreenElement === null) isAlone.value = false;
}

/** Without the screen it is the page that has to listen to Escape, unless a menu, a dialog or a gesture has used it. */
function onKey(event: KeyboardEvent): void {
  if (event.key !== 'Escape' || event.defaultPrevented || !isAlone.value) return;
  if (document.querySelector('.v-overlay--active') === null) leave();
}
