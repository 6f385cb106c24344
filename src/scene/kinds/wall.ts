import { pair, property } from '../json-text';
import { lengthOf, type Outline } from '../outline';
import { sceneDefaults, sceneLimits, type Wall } from '../scene';
import { standing, type SceneKind } from './kind';
import { readId, readPlace, type Unread } from './unread';

/** Walls; one without length has no direction, and is refused. */
export const wall: SceneKind<Wall> = {
  name: 'wall',
  properties: ['from', 'to', 'thickness'],
  read,
  write: ({ from, to, thickness }) => [
    `"from": ${pair(from)}`,
    `"to": ${pair(to)}`,
    ...property('thickness', thickness, sceneDefaults.thickness),
  ],
  ...standing<Wall>((wall) => [wallOutline(wall)]),
};

function read(given: Unread): Wall {
  const { reader, at } = given;
  const before = reader.problems.length;
  const id = readId(given);
  const from = readPlace(given, 'from');
  const to = readPlace(given, 'to');
  const thickness = reader.whole(...at('thickness'), sceneLimits.thicknessMm, sceneDefaults.thickness);
  if (from[0] === to[0] && from[1] === to[1] && reader.problems.length === before) {
    const what = `the wall has length 0: it starts and ends at [${to.join(', ')}]. Move one end or remove the wall.`;
    reader.report('wall-without-length', at('to')[1], to, what, { x: to[0], y: to[1] });
  }
  return { type: 'wall', id, from, to, thickness };
}

/** The rectangle that a wall fills, in world mm. */
export function wallOutline({ from, to, thickness }: Wall): Outline {
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
