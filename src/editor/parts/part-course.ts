import { boundsOf } from '#scene/kinds/index';
import { defaultScene, type Point, type Scene } from '#scene/scene';
import type { Clip } from '../clipboard';
import { boundsAll } from '../bounds';
import { movedBy } from '../kinds/index';
import { frameAround, frameOf, lengthOf } from '../snap/frames';

/** Floor around a part that stands alone, in mm. Chosen: what is cut out of paper has an edge to hold. */
const RIM_MM = 5;

/** Width and height of a part in mm; a line counts from end to end, as what is joined to it does. */
export function sizeOfPart({ objects }: Clip): Point {
  const frame = frameAround(objects.map(frameOf));
  return frame ? [lengthOf(frame.x), lengthOf(frame.y)] : [0, 0];
}

/**
 * A part alone, on a floor that is just large enough, for its picture and for paper. Such a floor may be smaller than any
 * arena.
 */
export function partCourse({ objects }: Clip, name = ''): Scene {
  const { minX, minY, maxX, maxY } = boundsAll(objects.map(boundsOf)) ?? NOWHERE;
  const [dx, dy] = [Math.ceil(RIM_MM - minX), Math.ceil(RIM_MM - minY)];
  const course = defaultScene();
  return {
    ...course,
    robot: { ...course.robot, at: ELSEWHERE },
    name,
    size: [Math.ceil(maxX - minX) + 2 * RIM_MM, Math.ceil(maxY - minY) + 2 * RIM_MM],
    objects: objects.map((object) => movedBy(object, dx, dy)),
  };
}

/** The robot's start is not in the picture. */
const ELSEWHERE: Point = [-10_000, -10_000];

const NOWHERE = { minX: 0, minY: 0, maxX: 0, maxY: 0 };
