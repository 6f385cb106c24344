import type { Vec } from '#core/geometry';

/** Callbacks that move the picture. */
export interface PicturePorts {
  readonly pan: (byPx: Vec) => void;
  readonly zoom: (factor: number, aroundPx: Vec) => void;
}

/** Fingers nearer to each other count as this far apart, in CSS px. Chosen: so that the zoom stays finite. */
const LEAST_SPREAD_PX = 10;

/**
 * Moves the picture by a pointer that has moved: alone it pans, beside another one it pinches.
 *
 * @param other place of the second pointer, if there is one; all places in CSS px
 */
export function movePicture({ pan, zoom }: PicturePorts, before: Vec, at: Vec, other: Vec | undefined): void {
  const [dx, dy] = [at.x - before.x, at.y - before.y];
  if (other === undefined) return pan({ x: dx, y: dy });
  const spread = ({ x, y }: Vec): number => Math.max(LEAST_SPREAD_PX, Math.hypot(x - other.x, y - other.y));
  pan({ x: dx / 2, y: dy / 2 });
  zoom(spread(at) / spread(before), { x: (at.x + other.x) / 2, y: (at.y + other.y) / 2 });
}
