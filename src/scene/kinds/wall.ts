import { paintProperties, pair, property } from '../json-text';
import { lengthOf, type Outline } from '../outline';
import { sceneDefaults, type Wall } from '../scene';
import { standing, type SceneKind } from './kind';

/** Walls. */
export const wall: SceneKind<Wall> = {
  name: 'wall',
  write: ({ from, to, thickness, height, ...paint }) => [
    `"from": ${pair(from)}`,
    `"to": ${pair(to)}`,
    ...property('thickness', thickness, sceneDefaults.thickness),
    ...property('height', height ?? null, null),
    ...paintProperties(paint),
  ],
  ...standing<Wall>((wall) => [wallOutline(wall)]),
};

/** The rectangle that a wall fills, in world mm. */
export function wallOutline({ from, to, thickness }: Pick<Wall, 'from' | 'to' | 'thickness'>): Outline {
  const dx = to[0] - from[0];
  const dy = to[1] - from[1];
  const half = thickness / 2 / lengthOf(dx, dy);
  const acrossX = -dy * half;
  const acrossY = dx * half;
  return [
    { x: from[0] - acrossX, y: from[1] - acrossY },
    { x: to[0] - acrossX, y: to[1] - acrossY },
    { x: to[0] + acrossX, y: to[1] + acrossY },
    { x: from[0] + acrossX, y: from[1] + acrossY },
  ];
}
