import { paintProperties, pair, property } from '../json-text';
import { boundsOfOutline, overlapMm, type Outline } from '../outline';
import { sceneDefaults, type Stroke } from '../scene';
import type { SceneKind } from './kind';

/** Painted lines. */
export const stroke: SceneKind<Stroke> = {
  name: 'stroke',
  write: ({ points, width, ...paint }) => [
    `"points": [${points.map(pair).join(', ')}]`,
    ...property('width', width, sceneDefaults.width),
    ...paintProperties(paint, sceneDefaults.color),
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
