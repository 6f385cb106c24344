import { computed, onBeforeUnmount, onMounted, shallowRef, type ComputedRef, type ShallowRef } from 'vue';

import type { LayoutKind } from '../../../session/layout/layout-model';

/**
 * The layout of the palette: `bench`: groups with words in a column of their own; `strip` and `row`: two rows, or one,
 * with words below the arena; `pairs`, …: columns of signs beside it.
 */
export type PaletteForm = 'bench' | 'pairs' | 'threes' | 'fours' | 'strip' | 'row';

/** How many tools are side by side. */
export const PALETTE_COLUMNS: Readonly<Record<PaletteForm, number>> = {
  bench: 4,
  pairs: 2,
  threes: 3,
  fours: 4,
  strip: 6,
  row: 12,
};

/** Width of the palette in px; of strip and row, their height. The bench has that of its column. */
export const PALETTE_PX: Readonly<Record<Exclude<PaletteForm, 'bench'>, number>> = {
  pairs: 98,
  threes: 142,
  fours: 186,
  strip: 118,
  row: 64,
};

/** The number of tools, and the least height of each. */
const TOOLS = 12;
const TOOL_PX = 44;
const EDGES_PX = 8;
/** The forms of several columns, the narrowest first: the first that shows all tools is taken. */
const GRIDS = ['pairs', 'threes', 'fours'] as const;

/** Fits the palette of a window without a bench to the room, so that all tools are visible wherever possible. */
export function paletteForm(
  kind: LayoutKind,
  room: { readonly widthPx: number; readonly heightPx: number },
): Exclude<PaletteForm, 'bench'> {
  if (kind !== 'phone') return 'row';
  if (room.widthPx <= room.heightPx * 1.5) return 'strip';
  const rows = Math.floor((room.heightPx - EDGES_PX) / TOOL_PX);
  return GRIDS.find((form) => PALETTE_COLUMNS[form] * rows >= TOOLS) ?? 'fours';
}

/** The form of the palette, which follows the size of the element that holds palette and arena. */
export function usePaletteForm(
  host: Readonly<ShallowRef<HTMLElement | null>>,
  kind: Readonly<ShallowRef<LayoutKind>>,
): ComputedRef<Exclude<PaletteForm, 'bench'>> {
  const room = shallowRef({ widthPx: innerWidth, heightPx: innerHeight });
  const measure = ({ width, height }: { readonly width: number; readonly height: number }): void => {
    room.value = { widthPx: width, heightPx: height };
  };
  const observer = new ResizeObserver((entries) => {
    const box = entries[entries.length - 1]?.contentRect;
    if (box !== undefined) measure(box);
  });
  onMounted(() => {
    if (host.value === null) return;
    measure({ width: host.value.clientWidth, height: host.value.clientHeight });
    observer.observe(host.value);
  });
  onBeforeUnmount(() => observer.disconnect());
  return computed(() => paletteForm(kind.value, room.value));
}
