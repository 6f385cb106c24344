import { shallowRef, watch, type ShallowRef } from 'vue';

import { openLayer } from '../../kit/overlays/overlays';

/** The arena alone on the screen, as for a projector: whether it is, and the ways in and out. */
export class ArenaAlone {
  private readonly alone = shallowRef(false);
  readonly isAlone: Readonly<ShallowRef<boolean>> = this.alone;
  /** True in the projector view: task and timer stand beside the arena. */
  readonly hasSide = shallowRef(false);
  /** Number of controls in the arena's pane that can lead back. */
  private users = 0;
  /** Ends the hearing of Escape. */
  private unhear: (() => void) | null = null;

  constructor() {
    // With the state, so that nothing on the page can be seen or reached behind the arena.
    watch(
      this.alone,
      (alone) => {
        document.documentElement.classList.toggle('arena-alone', alone);
        if (!alone) this.hasSide.value = false;
        this.hear();
      },
      { flush: 'sync' },
    );
  }

  /** Shows the arena alone: on the whole screen, or in the window if the browser refuses full screen. */
  readonly enter = (): void => {
    import('./arena-alone.css').catch(() => undefined); // without it the page stays as it is
    this.alone.value = true;
    // The whole document, not the pane: menus and dialogs hang elsewhere in it.
    const root: Partial<Pick<Element, 'requestFullscreen'>> = document.documentElement; // an iPhone has no such thing
    root.requestFullscreen?.({ navigationUI: 'hide' }).catch(() => undefined); // refused in many frames: the window will do
  };

  readonly leave = (): void => {
    this.alone.value = false;
    // An iPhone knows neither of the two.
    if (document.fullscreenElement instanceof Element) document.exitFullscreen().catch(() => undefined);
  };

  /** Counts a control that can lead back. When the last of them goes, the page comes back. */
  attach(): () => void {
    this.users += 1;
    this.hear();
    if (this.users === 1) document.addEventListener('fullscreenchange', this.onChange);
    return () => {
      this.users -= 1;
      if (this.users > 0) return;
      this.leave();
      document.removeEventListener('fullscreenchange', this.onChange);
    };
  }

  /** Escape leads back where the browser is not in full screen, unless something lies over it. */
  private hear(): void {
    this.unhear?.();
    this.unhear = this.alone.value && this.users > 0 ? openLayer({ requestClose: this.leave }) : null;
  }

  /** Follows when the browser leaves full screen, as it does for Escape. */
  private readonly onChange = (): void => {
    if (document.fullscreenElement === null) this.alone.value = false;
  };
}
