import type { ShallowRef } from 'vue';

import type { LoadedView } from '../loaded-view';

/** The parts of a lesson, in its order. */
export const DESK_PARTS = ['prepare', 'teach', 'check'] as const;

/** The page for teachers, for a card that was chosen. */
export interface DeskHost {
  /** Leaves for another page, from which an arrow leads back. */
  openPage(name: string, id?: string): void;
  /** Leaves for the arena, and does something there. */
  leaveFor(act: () => void): void;
  /** Opens a dialog over the page, which emits `close`. */
  openDialog(load: LoadedView): void;
}

/** Work that somebody has left on a card's page: its name, and a word on it. */
export interface DeskLeft {
  readonly title: string;
  readonly about: string;
}

/** Something that the search of the page for teachers finds behind a card. */
export interface DeskFound {
  /** Unique among those of its card. */
  readonly id: string;
  readonly title: string;
  readonly about: string;
  readonly open: (desk: DeskHost) => void;
}

/** A card on the page for teachers. A feature lists its own in its `desk-cards.ts`, which is loaded with that page. */
export interface DeskCard {
  readonly part: (typeof DESK_PARTS)[number];
  /** Position within the part: smaller ones come first. */
  readonly order: number;
  readonly testId: string;
  readonly icon: string;
  readonly title: () => string;
  /** One sentence on what it is for. */
  readonly about: () => string;
  /** The number of things behind it, beside its title; left out, or 0: none is shown. */
  readonly count?: () => number;
  /** The work that was left there; it stands above the cards. `null`: none. */
  readonly left?: () => DeskLeft | null;
  /** Everything behind it that fits the words of the search, the best first. */
  readonly found?: () => readonly DeskFound[];
  readonly open: (desk: DeskHost) => void;
}

/** The cards of a feature; called in the set-up of the page, so it may ask for models. `search`: its words, trimmed. */
export type DeskCards = (search: Readonly<ShallowRef<string>>) => readonly DeskCard[];
