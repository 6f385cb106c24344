import { computed, type ShallowRef } from 'vue';
import type { Vec } from '#core/geometry';
import { createTrailLayer, type ShownTrail } from '../robot/draw-trail';
import { deviceColor } from '#picture/device-colors';
import type { Palette } from '../model/palette';
import type { ArenaView } from '../view/use-arena-view';
import type { ArenaSize } from '../view/view-transform';
import type { Trail } from '../../../session/run/trail';

/** The newest piece of a trail, which the canvas does not show yet, in px; may be empty. */
export interface Tail {
  readonly pointsPx: readonly Vec[];
  readonly palette: Palette;
}

/** Sources of the trails. */
export interface OtherTrailSources {
  /** `null` while trails are hidden. */
  readonly canvas: Readonly<ShallowRef<HTMLCanvasElement | null>>;
  readonly picture: () => ArenaView;
  readonly arena: () => ArenaSize;
  readonly palette: () => Palette;
  /** The visible trails, each with its place and with its colour as `deviceColor` takes it. */
  readonly trails: () => readonly { readonly place: number; readonly color: number; readonly trail: Trail }[];
}

/**
 * The trails of other robots and of ghosts, on one canvas. Requesting a tail repaints the canvas if it is too old.
 *
 * @returns a function that gives the tail of a device's trail
 */
export function useSharedTrails(sources: OtherTrailSources): (place: number) => Tail | null {
  const layer = createTrailLayer();
  const paletteOf = coloredPalettes();
  const paint = (trails: readonly ShownTrail[], canvas: HTMLCanvasElement): void => {
    const picture = sources.picture();
    const frame = { canvas, ...picture.canvas.value, ratio: picture.ratio.value, view: picture.view.value };
    layer.paint(trails, { ...frame, arena: sources.arena() }, performance.now());
  };
  const shown = computed(() =>
    sources.trails().map(({ color, trail }) => ({ trail, palette: paletteOf(sources.palette(), color) })),
  );
  return (place) => {
    const canvas = sources.canvas.value;
    const own = sources.trails().find((one) => one.place === place);
    if (canvas === null || own === undefined) return null;
    paint(shown.value, canvas);
    const pointsPx = layer.tail(own.trail, sources.picture().view.value);
    return { pointsPx, palette: paletteOf(sources.palette(), own.color) };
  };
}

/**
 * Palettes with the trace in a device's colour. The same object is returned each time: another one repaints all the
 * trails.
 */
function coloredPalettes(): (palette: Palette, color: number) => Palette {
  const made = new Map<Palette, Map<number, Palette>>();
  return (palette, color) => {
    const known = made.get(palette) ?? new Map<number, Palette>();
    const colored = known.get(color) ?? { ...palette, trace: deviceColor(color) };
    made.set(palette, known.set(color, colored));
    return colored;
  };
}
