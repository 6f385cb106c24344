import { boundsOf } from '#scene/kinds/index';
import { defaultScene, type Point, type Scene } from '#scene/scene';
import type { Clip } from '../clipboard';
import { boundsAll } from '../bounds';
import { movedBy } from '../kinds/index';

/** Floor around a part that stands alone, in mm. Chosen: what is cut out of paper has an edge to hold. */
const RIM_MM = 5;

/** Width and height of a part as it lies there, in whole mm. */
export function sizeOfPart({ objects }: Clip): Point {
  const around = boundsAll(objects.map(boundsOf)) ?? { minX: 0, minY: 0, maxX: 0, maxY: 0 };
  return [Math.ceil(around.maxX - around.minX), Math.ceil(around.maxY - around.minY)];
}

/**
 * A part alone, on a floor that is just large enough, for its picture and for paper. Such a floor may be smaller than any
 * arena.
 */
export function partCourse(clip: Clip, name = ''): Scene {
  const [width, height] = sizeOfPart(clip);
  const around = boundsAll(clip.objects.map(boundsOf));
  const [left, bottom] = around ? [around.minX, around.minY] : [0, 0];
  const objects = clip.objects.map((object) => movedBy(object, Math.ceil(RIM_MM - left), Math.ceil(RIM_MM - bottom)));
  return { ...defaultScene(), name, size: [width + 2 * RIM_MM, height + 2 * RIM_MM], objects };
}
