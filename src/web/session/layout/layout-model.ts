import { useFirstMatch } from '../../kit/use-first-match';
import { computed, shallowRef, type ComputedRef, type ShallowRef } from 'vue';

import { PARTS, type Part } from '#embed/simulator';

import type { ArenaMode } from '../mode/mode-model';
import type { HostView } from '../visit/host-view';
import type { SettingsModel } from '../work/settings/settings-model';

/**
 * The arrangement of the panes: `wide` from 1280 px, `medium` from 1001, `narrow` from 600, `phone` below, and wherever
 * the window is too low for several panes: a phone held across. The same limits stand in the styles of a phone.
 */
export type LayoutKind = 'wide' | 'medium' | 'narrow' | 'phone';

/** True if panes are stacked or behind tabs; an error then shows its explanation first. */
export const hasLittleRoom = (kind: LayoutKind): boolean => kind === 'narrow' || kind === 'phone';

/** The four panes. */
export const PANES = ['code', 'board', 'arena', 'console'] as const;
export type Pane = (typeof PANES)[number];

/** The card beside the program: unfolded, or its title line alone. */
export type CardForm = 'open' | 'folded';

/** The arrangement of the panes: which are shown, where, and how large. */
export interface LayoutModel {
  readonly kind: Readonly<ShallowRef<LayoutKind>>;
  /** The arrangement of the shown panes; equals `kind`, except for a pair that has room in a small frame. */
  readonly arrangement: ComputedRef<LayoutKind>;
  /** The requested pane of a phone; if it does not exist, the first one is shown. */
  readonly tab: ShallowRef<Pane>;
  /** The panes that a phone has tabs for. */
  readonly tabs: ComputedRef<readonly Pane[]>;
  readonly isShown: ComputedRef<Readonly<Record<Pane, boolean>>>;
  /**
   * The parts chosen by the host, or else by the pupil's settings. On a phone without a host all panes have tabs
   * anyway.
   */
  readonly parts: ComputedRef<readonly Part[]>;
  /** Sizes of the panes in px. */
  readonly sizes: ComputedRef<PaneSizes>;
  /** The card of the task, or the question of a first visit in its place; `null`: there is none. The task sets it. */
  readonly card: ShallowRef<CardForm | null>;
  /** True while a newcomer is asked where to begin, in the card's place. The greeting itself sets it. */
  readonly isGreeting: ShallowRef<boolean>;
  /** True if the board is its display and its two buttons alone, because a card has its place. */
  readonly isBoardSmall: ComputedRef<boolean>;
  /** True if the console has nothing to show and may be folded to its head. The console itself sets it. */
  readonly isConsoleFolded: ShallowRef<boolean>;
  /** Least height of the console, in px; 0: no demand. The card of an error sets it. */
  readonly leastConsolePx: ShallowRef<number>;
  /** True where folding the console gains room: everywhere but on a phone. */
  readonly canFold: ComputedRef<boolean>;
  /** A phone held across, or a window as low: its panes are wide and low, and what belongs to the arena stands beside it. */
  readonly isAcross: ComputedRef<boolean>;
  /** True while the help takes its share of the page. The help itself sets it. */
  readonly isHelpShown: ShallowRef<boolean>;
  /** The mode of the arena, to which the panes belong. The session sets it. */
  readonly mode: ShallowRef<ArenaMode>;
}

/** Sizes of what a splitter moves, in px. */
export interface PaneSizes {
  readonly code: number;
  readonly board: number;
  readonly console: number;
  /** Height of code and board in the narrow layout; 0: as the window's height suggests. */
  readonly top: number;
  /** Height of the board below the program, in the medium layout. */
  readonly below: number;
  /** The console is as high as its head. */
  readonly isConsoleFolded: boolean;
}

type Sizes = Omit<PaneSizes, 'isConsoleFolded'>;

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

/** Windows in which every line counts: laptops whose browser shows all its bars. */
const LOW: readonly [boolean, string][] = [[true, '(max-height: 699px)']];

/** Sizes that suit each layout, from the picture of the app's look: the arena has what the others leave. */
const SUGGESTED: Readonly<Record<LayoutKind, Sizes>> = {
  wide: { code: 344, board: 268, console: 186, top: 0, below: 0 },
  medium: { code: 400, board: 208, console: 174, top: 0, below: 208 },
  narrow: { code: 0, board: 300, console: 208, top: 0, below: 0 },
  phone: { code: 0, board: 0, console: 0, top: 0, below: 0 },
};

/** Larger sizes for wide windows, whose height limits the arena: it stays as large. In px, chosen by eye. */
const ROOMY: readonly [Partial<Sizes>, string][] = [
  [{ code: 528, board: 288, console: 232 }, '(min-width: 1680px) and (min-height: 800px)'],
  [{ code: 384, board: 268 }, '(min-width: 1440px) and (min-height: 440px)'],
];

const ACROSS: readonly [boolean, string][] = [[true, '(min-width: 600px) and (max-height: 599px)']];

/** Heights in a low window, in px: four lines of output above the line for input, or the explanation of an error. */
const LOW_SIZES: Partial<Sizes> = { console: 170, below: 172 };

/** Width of the board where no arena needs the room: what is unfolded then stands beside the drawing. Chosen by eye. */
const BOARD_ALONE: Readonly<Record<LayoutKind, number>> = { wide: 560, medium: 480, narrow: 320, phone: 0 };

/** True if the window is a phone's now, before there is a layout. */
export const isPhoneNow = (): boolean => !QUERIES.some(([, query]) => matchMedia(query).matches);

/** Creates the layout, which follows the window's size, the host's parts and the pupil's settings. */
export function createLayout({ current }: Pick<SettingsModel, 'current'>, host: Pick<HostView, 'parts'>): LayoutModel {
  const isHelpShown = shallowRef(false);
  const kind = useFirstMatch(QUERIES, 'phone');
  const pair = useFirstMatch(PAIRS, 'phone');
  const tab = shallowRef<Pane>('code');
  /** The parts shown: a host's choice wins over the pupil's. */
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
  /**
   * True if the board is hidden: beside the help in a narrow window, and in the wide layout while the arena is watched.
   */
  const isBoardAway = computed(() => {
    const isTight = isHelpShown.value && besideHelp.value === 'some';
    return (isTight || (current.value.cinema && kind.value === 'wide')) && parts.value.includes('arena');
  });
  const mode = shallowRef<ArenaMode>('drive');
  const isShown = computed(() => {
    const has = (pane: Pane): boolean =>
      arrangement.value === 'phone' ? tabNow.value === pane : parts.value.includes(pane);
    const isStacked = arrangement.value === 'phone';
    const board = has('board') && (isStacked || !isBoardAway.value);
    const shown = { code: has('code'), board, arena: has('arena'), console: has('console') };
    return isStacked ? shown : panesOfMode(mode.value, shown);
  });
  const console = useConsolePlace(arrangement);
  const isLow = useFirstMatch(ACROSS, false);
  const isAcross = computed(() => isLow.value && arrangement.value === 'phone');
  const sizes = useSizes(current, kind, console);
  const card = shallowRef<CardForm | null>(null);
  const isBoardSmall = computed(() => card.value === 'open' && arrangement.value !== 'phone');
  const cards = { card, isGreeting: shallowRef(false), isBoardSmall };
  return { kind, arrangement, tab, tabs, parts, isShown, sizes, isAcross, isHelpShown, mode, ...cards, ...console };
}

type ConsolePlace = Pick<LayoutModel, 'isConsoleFolded' | 'leastConsolePx' | 'canFold'>;

/** The state of the console's pane: not folded, no least height. */
function useConsolePlace(arrangement: ComputedRef<LayoutKind>): ConsolePlace {
  return {
    isConsoleFolded: shallowRef(false),
    leastConsolePx: shallowRef(0),
    canFold: computed(() => arrangement.value !== 'phone'),
  };
}

/** The sizes that suit the window, or that the pupil has dragged. */
function useSizes(
  current: SettingsModel['current'],
  kind: LayoutModel['kind'],
  { canFold, isConsoleFolded, leastConsolePx }: ConsolePlace,
): ComputedRef<PaneSizes> {
  const roomy = useFirstMatch<Partial<Sizes>>(ROOMY, {});
  const isLow = useFirstMatch(LOW, false);
  return computed(() => {
    const suggested = {
      ...SUGGESTED[kind.value],
      ...(kind.value === 'wide' && roomy.value),
      ...(kind.value !== 'narrow' && canFold.value && isLow.value && LOW_SIZES),
    };
    const { codePx, boardPx, consolePx, topPx, belowPx, showArena } = current.value;
    return {
      code: codePx ?? suggested.code,
      board: boardPx ?? (showArena ? suggested.board : BOARD_ALONE[kind.value]),
      console: Math.max(consolePx ?? suggested.console, leastConsolePx.value),
      top: topPx ?? suggested.top,
      below: belowPx ?? suggested.below,
      isConsoleFolded: canFold.value && isConsoleFolded.value,
    };
  });
}

/** The first pane of a phone: without a program the arena, which has a small board in it. */
const first = (tabs: readonly Pane[]): Pane | undefined =>
  (['code', 'arena', 'board', 'console'] as const).find((pane) => tabs.includes(pane));

type ShownPanes = Readonly<Record<Pane, boolean>>;

/** The panes that belong to a mode: building needs the arena alone, looking back no board, whose display is on the robot. */
function panesOfMode(mode: ArenaMode, shown: ShownPanes): ShownPanes {
  if (!shown.arena || mode === 'drive') return shown;
  if (mode === 'build') return { code: false, board: false, arena: true, console: false };
  return shown.code ? { ...shown, board: false } : shown;
}
