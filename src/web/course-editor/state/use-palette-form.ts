import { computed, onBeforeUnmount, onMounted, shallowRef, type ComputedRef, type ShallowRef } from 'vue';

import type { LayoutKind } from '../../layout/layout-model';

/** How the palette lies: see `ToolPalette.vue`. */
export type PaletteForm = 'words' | 'icons' | 'pairs' | 'strip';

/** Width of the palette in px; height of the strip. */
export const PALETTE_PX: Readonly<Record<PaletteForm, number>> = { words: 84, icons: 58, pairs: 98, strip: 58 };

/** Height of all tools one below the other, in px: twelve of 44, four lines between them, and the edge. */
const COLUMN_PX = 12 * 44 + 4 * 3 + 8;
/** Least width of the arena's pane that can spare the room for two columns, in px. Chosen by eye. */
const SPARE_PX = 480;
/** Least width that can spare the room for names: with less the course would be smaller for them. Chosen by eye. */
const NAMES_PX = 752;

/** Suits the palette to the room beside the arena, so that all tools are in sight wherever they can be. */
export function paletteForm(
  kind: LayoutKind,
  room: { readonly widthPx: number; readonly heightPx: number },
): PaletteForm {
  if (kind === 'phone') return room.widthPx > room.heightPx * 1.5 ? 'pairs' : 'strip';
  if (room.heightPx >= COLUMN_PX) return room.widthPx >= NAMES_PX ? 'words' : 'icons';
  return room.widthPx >= SPARE_PX ? 'pairs' : 'icons';
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
