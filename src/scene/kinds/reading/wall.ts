import { sceneDefaults, sceneLimits, type Wall } from '../../scene';
import type { KindReader } from './kind-reader';
import { readHeight, readId, readPaint, readPlace, type Unread } from './unread';

/** Reads walls. One without length has no direction, and is refused. */
export const wall: KindReader<Wall> = {
  properties: ['from', 'to', 'thickness', 'height', 'color', 'infrared'],
  read: (given) => ({ type: 'wall', ...readLine(given, 'wall'), ...readHeight(given), ...readPaint(given) }),
};

/** Reads id, ends and thickness of a wall or a barrier. */
export function readLine(given: Unread, name: 'wall' | 'barrier'): Pick<Wall, 'id' | 'from' | 'to' | 'thickness'> {
  const { reader, at } = given;
  const before = reader.problems.length;
  const id = readId(given);
  const from = readPlace(given, 'from');
  const to = readPlace(given, 'to');
  const thickness = reader.whole(...at('thickness'), sceneLimits.thicknessMm, sceneDefaults.thickness);
  if (from[0] === to[0] && from[1] === to[1] && reader.problems.length === before) {
    const what = `the ${name} has length 0: it starts and ends at [${to.join(', ')}]. Move one end or remove the ${name}.`;
    reader.report('wall-without-length', at('to')[1], to, what, { x: to[0], y: to[1] });
  }
  return { id, from, to, thickness };
}
