import { pair, property } from '../json-text';
import { boundsOfOutline, overlapMm, type Outline } from '../outline';
import { sceneDefaults, sceneLimits, strokeColors, type Stroke } from '../scene';
import type { SceneKind } from './kind';
import { readId } from './unread';

/** Painted lines. */
export const stroke: SceneKind<Stroke> = {
  name: 'stroke',
  properties: ['points', 'width', 'color'],
  read(given) {
    const { reader, at, pointsLeft } = given;
    const [value, path] = at('points');
    const points = reader.list(value, path, { min: 1, max: pointsLeft });
    return {
      type: 'stroke',
      id: readId(given),
      points: points.map((point, index) => reader.point(point, `${path}[${index}]`, sceneLimits.placeMm)),
      width: reader.whole(...at('width'), sceneLimits.widthMm, sceneDefaults.width),
      color: reader.word(...at('color'), strokeColors, sceneDefaults.color),
    };
  },
  write: ({ points, width, color }) => [
    `"points": [${points.map(pair).join(', ')}]`,
    ...property('width', width, sceneDefaults.width),
    ...property('color', color, sceneDefaults.color),
  ],
  solid: () => [],
  bounds({ points, width }) {
    const { minX, minY, maxX, maxY } = boundsOfOutline(points.map(([x, y]) => ({ x, y })));
    const half = width / 2;
    return { minX: minX - half, minY: minY - half, maxX: maxX + half, maxY: maxY + half };
  },
  reachesInto,
};

function reachesInto({ points, width }: Stroke, arena: Outline): boolean {
  return points.some(([x, y], index) => {
    const [fromX, fromY] = points[index - 1] ?? [x, y];
    const piece = [
      { x: fromX, y: fromY },
      { x, y },
    ];
    return overlapMm(piece, arena) > -width / 2;
  });
}
