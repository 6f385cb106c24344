import { computed, onBeforeUnmount, onMounted, shallowRef, type ComputedRef, type ShallowRef } from 'vue';

import type { LayoutKind } from '../../layout/layout-model';

/** How the palette lies: see `ToolPalette.vue`. */
export type PaletteForm = 'words' | 'icons' | 'pairs' | 'threes' | 'fours' | 'strip';

/** How many tools lie side by side. */
export const PALETTE_COLUMNS: Readonly<Record<PaletteForm, number>> = {
  words: 1,
  icons: 1,
  pairs: 2,
  threes: 3,
  fours: 4,
  strip: 6,
};

/** Width of the palette in px; height of the strip. */
export const PALETTE_PX: Readonly<Record<PaletteForm, number>> = {
  words: 84,
  icons: 58,
  pairs: 98,
  threes: 142,
  fours: 186,
  strip: 98,
};

/** So many tools there are, each at least this high. */
const TOOLS = 12;
const TOOL_PX = 44;
/** Height of all tools one below the other, in px: with four lines between them, and the edge. */
const COLUMN_PX = TOOLS * TOOL_PX + 4 * 3 + 8;
const EDGES_PX = 8;
/** As many columns as it takes, and no more than a part of the arena. */
const GRIDS = ['pairs', 'threes', 'fours'] as const;
/** Least width that can spare the room for names: with less the course would be smaller for them. Chosen by eye. */
const NAMES_PX = 752;

/** Suits the palette to the room beside the arena, so that all tools are in sight wherever they can be. */
export function paletteForm(
  kind: LayoutKind,
  room: { readonly widthPx: number; readonly heightPx: number },
): PaletteForm {
  if (kind === 'phone' && room.widthPx <= room.heightPx * 1.5) return 'strip';
  if (kind !== 'phone' && room.heightPx >= COLUMN_PX) return room.widthPx >= NAMES_PX ? 'words' : 'icons';
  const rows = Math.floor((room.heightPx - EDGES_PX) / TOOL_PX);
  return GRIDS.find((form) => PALETTE_COLUMNS[form] * rows >= TOOLS) ?? 'fours';
}

/** Follows the size of what holds palette and arena. */
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
