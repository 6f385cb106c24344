import { computed, onScopeDispose, shallowRef, type ComputedRef, type ShallowRef } from 'vue';

import type { SettingsModel } from './use-settings';

/**
 * How the panes lie: `wide` from 1280 px, `medium` from 1001, `narrow` from 600, `phone` below, and wherever the window is
 * too low for several panes: a phone held across. The same limits stand in the styles of a phone.
 */
export type LayoutKind = 'wide' | 'medium' | 'narrow' | 'phone';

/** Whether panes are stacked or behind tabs, so that an error shows its explanation first. */
export const hasLittleRoom = (kind: LayoutKind): boolean => kind === 'narrow' || kind === 'phone';

/** The four panes. */
export const PANES = ['code', 'board', 'arena', 'console'] as const;
export type Pane = (typeof PANES)[number];

/** What the panes' places depend on. */
export interface LayoutModel {
  readonly kind: Readonly<ShallowRef<LayoutKind>>;
  /** The pane a phone shows. */
  readonly tab: ShallowRef<Pane>;
  readonly isShown: ComputedRef<Readonly<Record<Pane, boolean>>>;
  /** Sizes of the panes in px. */
  readonly sizes: ComputedRef<PaneSizes>;
}

/** Sizes of what a splitter moves, in px. */
export interface PaneSizes {
  readonly code: number;
  readonly board: number;
  readonly console: number;
  /** Height of code and board in the narrow layout; 0: as the window's height suggests. */
  readonly top: number;
}

const QUERIES: readonly [LayoutKind, string][] = [
  ['wide', '(min-width: 1280px) and (min-height: 440px)'],
  ['medium', '(min-width: 1001px) and (min-height: 440px)'],
  ['narrow', '(min-width: 600px) and (min-height: 600px)'],
];

/** Sizes that suit each layout, from the picture of the app's look. */
const SUGGESTED: Readonly<Record<LayoutKind, PaneSizes>> = {
  wide: { code: 420, board: 256, console: 212, top: 0 },
  medium: { code: 380, board: 208, console: 210, top: 0 },
  narrow: { code: 0, board: 264, console: 208, top: 0 },
  phone: { code: 0, board: 0, console: 0, top: 0 },
};

/** Width of the board where no arena needs the room: what is unfolded then stands beside the drawing. Chosen by eye. */
const BOARD_ALONE: Readonly<Record<LayoutKind, number>> = { wide: 560, medium: 480, narrow: 320, phone: 0 };

/** Follows the window's width and the pupil's wishes. */
export function useLayout({ current }: SettingsModel): LayoutModel {
  const lists = QUERIES.map(([kind, query]) => [kind, matchMedia(query)] as const);
  const measure = (): LayoutKind => lists.find(([, list]) => list.matches)?.[0] ?? 'phone';
  const kind = shallowRef(measure());
  const follow = (): void => {
    kind.value = measure();
  };
  for (const [, list] of lists) list.addEventListener('change', follow);
  onScopeDispose(() => {
    for (const [, list] of lists) list.removeEventListener('change', follow);
  });
  const tab = shallowRef<Pane>('code');
  const isShown = computed(() => {
    const { showBoard, showArena } = current.value;
    if (kind.value !== 'phone') return { code: true, board: showBoard, arena: showArena, console: true };
    const only = (pane: Pane): boolean => tab.value === pane;
    return { code: only('code'), board: only('board'), arena: only('arena'), console: only('console') };
  });
  const sizes = computed(() => {
    const suggested = SUGGESTED[kind.value];
    const { codePx, boardPx, consolePx, topPx, showArena } = current.value;
    return {
      code: codePx ?? suggested.code,
      board: boardPx ?? (showArena ? suggested.board : BOARD_ALONE[kind.value]),
      console: consolePx ?? suggested.console,
      top: topPx ?? suggested.top,
    };
  });
  return { kind, tab, isShown, sizes };
}
