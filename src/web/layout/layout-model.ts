import { computed, onScopeDispose, shallowRef, type ComputedRef, type Ref, type ShallowRef } from 'vue';

import { PARTS, type Part } from '#embed/simulator';

import type { HostView } from '../visit/host-view';
import type { SettingsModel } from '../work/settings/settings-model';

/**
 * The arrangement of the panes: `wide` from 1280 px, `medium` from 1001, `narrow` from 600, `phone` below, and wherever
 * the window is too low for several panes: a phone held across. The same limits stand in the styles of a phone.
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
  /** The arrangement of the shown panes; equals `kind`, except for a pair that has room in a small frame. */
  readonly arrangement: ComputedRef<LayoutKind>;
  /** The requested pane of a phone; if it does not exist, the first one is shown. */
  readonly tab: ShallowRef<Pane>;
  /** The panes that a phone has tabs for. */
  readonly tabs: ComputedRef<readonly Pane[]>;
  readonly isShown: ComputedRef<Readonly<Record<Pane, boolean>>>;
  /** Everything that there is on this page, behind tabs or not. */
  readonly parts: ComputedRef<readonly Part[]>;
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

/** Room for board and arena together, where a host shows just these two: side by side, or one above the other. */
const PAIRS: readonly [LayoutKind, string][] = [
  ['medium', '(min-width: 560px) and (min-aspect-ratio: 5/4)'],
  ['narrow', '(min-height: 480px)'],
];

/** From this width on the board stays beside the help, too. */
const HELP: readonly ['all' | 'some', string][] = [['all', '(min-width: 1800px)']];

/** Width of the program where the arena's height leaves it more than is usual, in px. Chosen: the arena stays as large. */
const CODE_PX: readonly [number, string][] = [
  [560, '(min-width: 1680px) and (min-height: 440px)'],
  [460, '(min-width: 1400px) and (min-height: 440px)'],
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

/** Follows the window's width and the pupil's wishes. @param isHelpShown whether the help takes its share of the page */
export function createLayout(
  { current }: Pick<SettingsModel, 'current'>,
  host: Pick<HostView, 'parts'>,
  isHelpShown: Readonly<Ref<boolean>>,
): LayoutModel {
  const kind = useFirstMatch(QUERIES, 'phone');
  const pair = useFirstMatch(PAIRS, 'phone');
  const tab = shallowRef<Pane>('code');
  /** What a host shows wins over what the pupil has chosen. */
  const parts = computed((): readonly Part[] => {
    if (host.parts.value !== null) return host.parts.value;
    const { showBoard, showArena } = current.value;
    return PARTS.filter((part) => (part === 'board' ? showBoard : part === 'arena' ? showArena : true));
  });
  /** A pupil's phone has them all: what is hidden on a large page costs no room here. */
  const tabs = computed(() => PANES.filter((pane) => host.parts.value?.includes(pane) ?? true));
  const tabNow = computed(() => (tabs.value.includes(tab.value) ? tab.value : (first(tabs.value) ?? tab.value)));
  const arrangement = computed((): LayoutKind => {
    const isSmall = kind.value === 'phone' || kind.value === 'narrow';
    return isSmall && host.parts.value !== null && tabs.value.join() === 'board,arena' ? pair.value : kind.value;
  });
  const besideHelp = useFirstMatch(HELP, 'some');
  /** Beside the help program and arena come first. */
  const isBoardAway = computed(() => isHelpShown.value && besideHelp.value === 'some' && parts.value.includes('arena'));
  const isShown = computed(() => {
    const has = (pane: Pane): boolean =>
      arrangement.value === 'phone' ? tabNow.value === pane : parts.value.includes(pane);
    const isStacked = arrangement.value === 'phone';
    const board = has('board') && (isStacked || !isBoardAway.value);
    return { code: has('code'), board, arena: has('arena'), console: has('console') };
  });
  const roomyCodePx = useFirstMatch(CODE_PX, 0);
  const sizes = computed(() => {
    const suggested = SUGGESTED[kind.value];
    const { codePx, boardPx, consolePx, topPx, showArena } = current.value;
    return {
      code: codePx ?? Math.max(suggested.code, roomyCodePx.value),
      board: boardPx ?? (showArena ? suggested.board : BOARD_ALONE[kind.value]),
      console: consolePx ?? suggested.console,
      top: topPx ?? suggested.top,
    };
  });
  return { kind, arrangement, tab, tabs, parts, isShown, sizes };
}

/** The name of the first query that matches the window, now and from now on. */
function useFirstMatch<K>(queries: readonly [K, string][], other: K): Readonly<ShallowRef<K>> {
  const lists = queries.map(([kind, query]) => [kind, matchMedia(query)] as const);
  const measure = (): K => lists.find(([, list]) => list.matches)?.[0] ?? other;
  const kind = shallowRef(measure());
  const follow = (): void => {
    kind.value = measure();
  };
  for (const [, list] of lists) list.addEventListener('change', follow);
  onScopeDispose(() => {
    for (const [, list] of lists) list.removeEventListener('change', follow);
  });
  return kind;
}

/** The first pane of a phone: without a program the arena, which has a small board in it. */
const first = (tabs: readonly Pane[]): Pane | undefined =>
  (['code', 'arena', 'board', 'console'] as const).find((pane) => tabs.includes(pane));
