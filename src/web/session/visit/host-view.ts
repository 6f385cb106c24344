import { shallowRef, type ShallowRef } from 'vue';

import type { HostSettings, Part, SimulatorEvent } from '#embed/simulator';

/** The settings in the page's address, and the embedding page. */
export interface HostWish {
  /** Settings of this visit; none of them is stored. */
  readonly settings: HostSettings;
  /** The mode in which the arena begins; `null`: as the pupil has left it. A link to a run looks back in any case. */
  readonly mode: 'drive' | 'build' | null;
  /** The dialect that the page speaks before it is asked, or `null`: it then answers only a hello. */
  readonly dialect: 'microbit' | 'webtigerpython' | null;
  /** True if the work of this page is stored in the browser; pages that a host fills forget it. */
  readonly keepsWork: boolean;
  /** Origins that may command; empty: the parent, whatever its origin. */
  readonly origins: readonly string[];
  /** Colour of the play button of the micro:bit dialect, as CSS has it, or `null`. */
  readonly color: string | null;
  /** `flag` parameters of the micro:bit dialect. */
  readonly flags: readonly string[];
}

/** The page as it is without any host. */
export const noHost: HostWish = {
  settings: {},
  mode: null,
  dialect: null,
  keepsWork: true,
  origins: [],
  color: null,
  flags: [],
};

/** The changes that a host has made to the page, and its listeners. */
export class HostView {
  /** The parts that are shown; `null`: as the pupil has chosen. */
  readonly parts: ShallowRef<readonly Part[] | null>;
  /** The host's own words for controls of the board. */
  readonly labels: ShallowRef<Readonly<Record<string, string>>>;
  private readonly listeners = new Set<(event: SimulatorEvent) => void>();

  constructor(readonly wish: HostWish) {
    this.parts = shallowRef(wish.settings.parts ?? null);
    this.labels = shallowRef(wish.settings.labels ?? {});
  }

  /** Notifies all listeners; without a host there are none. */
  tell(event: SimulatorEvent): void {
    for (const listener of this.listeners) listener(event);
  }

  listen(listener: (event: SimulatorEvent) => void): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }
}
