import type { Component } from 'vue';

import type { MenuEntry } from '../controls/menu-entry';
import type { LoadedView } from '../loaded-view';

/**
 * The parts of the main menu, in the order in which they are shown; `run` is a phone's, whose bar has no room for it. The
 * `hints` stand below `view`, on a phone in a list of their own.
 */
export const MENU_PARTS = ['run', 'files', 'view', 'hints', 'help', 'teachers'] as const;
/** The lists that an entry of the menu opens in its place. */
export const MENU_LISTS = ['save', 'language', 'theme', 'panes', 'hints'] as const;
export type MenuList = (typeof MENU_LISTS)[number];
export type MenuGroup = (typeof MENU_PARTS)[number] | MenuList;

/** The main menu, for an entry that was chosen. */
export interface MenuHost {
  /** Closes the menu, gives the keyboard back to its button, and opens something else. */
  leaveFor(open: () => void): void;
  /** Closes the menu and opens a dialog, which emits `close`. */
  openDialog(load: LoadedView): void;
  /** Shows one of the menu's own lists in its place. */
  showList(list: MenuList): void;
  /** Shows another list in the menu's place, which may `stay` while one chooses. It emits `leave` with what to open instead. */
  showInside(load: LoadedView, stays?: boolean): void;
}

/** An entry of the main menu. What may change is asked for when the menu is drawn. */
export type FeatureEntry = MenuEntry<MenuHost>;

/** An entry that opens one of the menu's own lists, with what is chosen there now. */
export const listEntry = (list: MenuList, entry: Pick<FeatureEntry, 'icon' | 'title' | 'value'>): FeatureEntry => ({
  ...entry,
  ...{ id: list, testId: `menu-list-${list}`, leads: true, act: (menu) => menu.showList(list) },
});

/** Entries of a feature in one group of the main menu. */
export interface MenuPart {
  readonly group: MenuGroup;
  /** Position within the group: smaller ones come first. */
  readonly order: number;
  readonly entries: () => readonly FeatureEntry[];
}

/**
 * An entry of the help; a feature lists its own in its `help-entries.ts`, which is loaded with the help. Its name is
 * that of the control it explains, so that both always say the same.
 */
export interface HelpEntry {
  readonly id: string;
  readonly section: 'menu' | 'program' | 'board' | 'arena' | 'tools' | 'console' | 'keys';
  /** The entry of the section that it follows; left out: it is the last. */
  readonly after?: string;
  /** Path of an icon, or a picture of its own. */
  readonly icon: string | Component;
  readonly name: () => string;
  readonly text: () => string;
  /** Controls that it explains, by their `data-testid`, or the names of their labels. */
  readonly covers: readonly string[];
  /** The keys of a shortcut, which is shown by them instead of its name. */
  readonly keys?: readonly string[];
}

/** Everything that a feature brings to the main menu, in its `contribution.ts`; loaded with the menu. */
export interface Contribution {
  /** Called in the set-up of the menu, so it may ask for models. */
  readonly menu: () => readonly MenuPart[];
}

/** The exports of the modules of a file pattern, in the order of their paths. */
export const collected = <T>(modules: Readonly<Record<string, T>>): readonly T[] =>
  Object.keys(modules)
    .sort()
    .map((path) => modules[path] as T);

/** The entries of a group of the main menu, in their order. */
export const entriesOf = (parts: readonly MenuPart[], group: MenuGroup): readonly FeatureEntry[] =>
  parts
    .filter((part) => part.group === group)
    .sort((one, other) => one.order - other.order)
    .flatMap(({ entries }) => entries());
