import { computed, onBeforeUnmount, onMounted, shallowRef, type ComputedRef, type ShallowRef } from 'vue';

import type { LayoutKind } from '../../../session/layout/layout-model';

/** The layout of the palette: see `ToolPalette.vue`. */
export type PaletteForm = 'words' | 'icons' | 'pairs' | 'threes' | 'fours' | 'strip';

/** How many tools are side by side. */
export const PALETTE_COLUMNS: Readonly<Record<PaletteForm, number>> = {
  words: 1,
  icons: 1,
  pairs: 2,
  threes: 3,
  fours: 4,
  strip: 6,
};

/** Width of the palette in px; of the strip, its height. */
export const PALETTE_PX: Readonly<Record<PaletteForm, number>> = {
  words: 84,
  icons: 58,
  pairs: 98,
  threes: 142,
  fours: 186,
  strip: 98,
};

/** The number of tools, and the least height of each. */
const TOOLS = 12;
const TOOL_PX = 44;
/** Height of all tools in one column, in px, with the four lines between them and the border. */
const COLUMN_PX = TOOLS * TOOL_PX + 4 * 3 + 8;
const EDGES_PX = 8;
/** The forms of several columns, the narrowest first: the first that shows all tools is taken. */
const GRIDS = ['pairs', 'threes', 'fours'] as const;
/** The least width that leaves room for names: below it they would make the course smaller. Chosen by eye. */
const NAMES_PX = 752;

/** Fits the palette to the room beside the arena, so that all tools are visible wherever possible. */
export function paletteForm(
  kind: LayoutKind,
  room: { readonly widthPx: number; readonly heightPx: number },
): PaletteForm {
  if (kind === 'phone' && room.widthPx <= room.heightPx * 1.5) return 'strip';
  if (kind !== 'phone' && room.heightPx >= COLUMN_PX) return room.widthPx >= NAMES_PX ? 'words' : 'icons';
  const rows = Math.floor((room.heightPx - EDGES_PX) / TOOL_PX);
  return GRIDS.find((form) => PALETTE_COLUMNS[form] * rows >= TOOLS) ?? 'fours';
}

/** The form of the palette, which follows the size of the element that holds palette and arena. */
export function usePaletteForm(
  host: Readonly<ShallowRef<HTMLElement | null>>,
  kind: Readonly<ShallowRef<LayoutKind>>,
): ComputedRef<PaletteForm> {
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
