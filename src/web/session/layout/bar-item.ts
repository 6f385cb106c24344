import type { Component } from 'vue';

import type { LayoutKind } from './layout-model';

/**
 * Something in the bar at the top. A feature lists its own in its `bar-items.ts`, which comes with the app. On a page
 * without the bar, the items in place `run` have a strip of their own.
 */
export interface BarItem {
  readonly place: 'brand' | 'run' | 'speed' | 'work' | 'share';
  /** Position within the place: smaller ones come first. */
  readonly order?: number;
  /** The layouts that have room for it; left out: all. */
  readonly kinds?: readonly LayoutKind[];
  readonly view: Component;
}

/** The items of a place in this layout, in their order. */
export const itemsAt = (items: readonly BarItem[], place: BarItem['place'], kind: LayoutKind): readonly BarItem[] =>
  items
    .filter((item) => item.place === place && (item.kinds?.includes(kind) ?? true))
    .sort((one, other) => (one.order ?? 0) - (other.order ?? 0));
