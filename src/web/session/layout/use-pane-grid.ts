import { computed, onMounted, onScopeDispose, shallowRef, type Ref } from 'vue';

import type { TextKey } from '../../kit/i18n/texts';
import { cardGrid } from './card-grid';
import { gridOfMode } from './mode-grid';
import { limitsOf, withDeviceRow, withLargeArena, withRoomForPanel, type SplitterId } from './pane-grid';
import type { WorkParts } from '../work/model/parts';
import type { LayoutParts } from './parts';

/** One bar between panes, ready for `PaneSplitter`. */
export interface Splitter {
  readonly id: SplitterId;
  readonly label: TextKey;
  readonly axis: 'x' | 'y';
  readonly sign: 1 | -1;
  readonly sizePx: number;
  readonly minPx: number;
  readonly maxPx: number;
  resize(px: number | null): void;
}

const SETTING = { code: 'codePx', board: 'boardPx', console: 'consolePx', top: 'topPx', below: 'belowPx' } as const;

/** Height of the row of devices with the gap below it. */
const DEVICE_ROW_PX = 84;

/** The panes' grid as CSS variables, and the splitters that are in it. Sizes always fit the window. */
export function usePaneGrid(
  { layout, settings, work }: WorkParts & Pick<LayoutParts, 'layout'>,
  root: Ref<HTMLElement | null>,
) {
  const room = shallowRef({ widthPx: innerWidth, heightPx: innerHeight });
  const observer = new ResizeObserver(([entry]) => {
    if (entry !== undefined) room.value = { widthPx: entry.contentRect.width, heightPx: entry.contentRect.height };
  });
  onMounted(() => {
    if (root.value !== null) observer.observe(root.value);
  });
  onScopeDispose(() => observer.disconnect());

  const isUnfolded = computed(
    () => layout.isShown.value.board && !layout.isBoardSmall.value && settings.current.value.panel !== null,
  );
  const sizes = computed(() => {
    const wished = withRoomForPanel(layout.sizes.value, isUnfolded.value);
    return settings.current.value.cinema ? withLargeArena(wished, room.value) : wished;
  });
  /** An arena that has two thirds of the window, or the help beside it, leaves one column for all the others. */
  const isArenaFirst = (hasBoard: boolean): boolean =>
    settings.current.value.cinema || (layout.isHelpShown.value && !hasBoard);
  const hasRow = (): boolean => work.hasSeveral.value && layout.mode.value !== 'build';
  const grid = computed(() => {
    // The row of devices takes its height from all others.
    const rowPx = hasRow() ? DEVICE_ROW_PX : 0;
    const free = { ...room.value, heightPx: room.value.heightPx - rowPx };
    const [kind, shown, card] = [layout.arrangement.value, layout.isShown.value, layout.card.value];
    const mode = layout.mode.value;
    const panes =
      card === null
        ? gridOfMode(mode, kind, shown, sizes.value, free)
        : cardGrid(kind === 'wide' && isArenaFirst(shown.board) ? 'medium' : kind, shown, sizes.value, free, card);
    return hasRow() ? withDeviceRow(panes) : panes;
  });
  const style = computed(() => ({
    '--columns': grid.value.columns,
    '--rows': grid.value.rows,
    '--areas': grid.value.areas,
  }));
  const splitters = computed<Splitter[]>(() =>
    grid.value.splitters.map(({ id, axis, sign, sizePx }) => ({
      id,
      axis,
      sign,
      sizePx,
      label: `splitter.${id}` as const,
      ...limitsOf(id, room.value),
      resize: (px) => settings.change({ [SETTING[id]]: px, cinema: false }),
    })),
  );
  return { style, splitters };
}
