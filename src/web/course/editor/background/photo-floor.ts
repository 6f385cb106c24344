import { packLevels } from '#scene/background';
import type { Background, Point } from '#scene/scene';

import type { Cells } from './even-light';
import { fitBackground, type FloorSize } from './fit-background';
import { pictureOf } from './picture-of';
import type { Pixels } from './pixels';
import { scaledQuad, straightExtentOf, type Extent, type Quad } from './quad';
import { brightnessOfCells } from './raster';
import { LONGEST_PX, type OpenedPicture } from './read-image';
import { evenedIf, levelsOf, type SensorView } from './sensor-view';
import { straightened } from './straighten';

/** How an opened picture is to become the floor. */
export interface FloorWish {
  /** In pixels of the picture. */
  readonly quad: Quad;
  readonly view: SensorView;
  readonly size: FloorSize;
  /** People see the picture; otherwise what the sensors see. */
  readonly showsPicture: boolean;
}

/** The floor from a picture: the levels that the line sensors read, and the picture that is displayed. */
export function floorOf({ pixels, isPhoto }: OpenedPicture, wish: FloorWish, arena: Point): Background {
  const shape = atMost(straightExtentOf(wish.quad), LONGEST_PX);
  const straight = straightened(pixels, wish.quad, shape);
  const place = fitBackground(shape.width, shape.height, arena, wish.size);
  const [columns, rows] = place.cells;
  const cells = evenedIf({ columns, rows, brightness: brightnessOfCells(straight, columns, rows) }, wish.view.isEven);
  return {
    ...place,
    levels: packLevels(levelsOf(cells, wish.view)),
    picture: wish.showsPicture ? pictureOf({ pixels: straight, isPhoto }) : '',
  };
}

/**
 * The floor in few cells, quickly, for its preview.
 *
 * @param small the picture at `scale` of its size
 */
export function previewCells(small: Pixels, scale: number, quad: Quad, longest: number): Cells {
  const { width, height } = atMost(straightExtentOf(quad), longest);
  const straight = straightened(small, scaledQuad(quad, scale), { width, height });
  return { columns: width, rows: height, brightness: brightnessOfCells(straight, width, height) };
}

function atMost({ width, height }: Extent, longest: number): Extent {
  const scale = Math.min(1, longest / Math.max(width, height));
  return { width: Math.max(1, Math.round(width * scale)), height: Math.max(1, Math.round(height * scale)) };
}
