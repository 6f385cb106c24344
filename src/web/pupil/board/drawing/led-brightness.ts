/**
 * How bright each of the display's ten levels looks, 0 … 1. The lights get 0, 1, 2, 4 … 128, 255 of 255 parts of the
 * power (micropython-microbit-v2, drv_display.c); shown linearly, levels 1 to 5 would be black on a screen. These steps
 * are those of the Micro:bit Educational Foundation's own simulator
 * (micropython-microbit-v2-simulator, src/board/display.ts), which were chosen to look like the board.
 */
const OPACITIES = [0, 20, 40, 60, 80, 120, 160, 190, 220, 255].map((part) => part / 255);

/** How bright a light of this level looks, 0 … 1; levels beyond 0 … 9 count as the nearest. */
export function ledOpacity(level: number): number {
  return OPACITIES[Math.max(0, Math.min(9, Math.round(level)))] ?? 0;
}
