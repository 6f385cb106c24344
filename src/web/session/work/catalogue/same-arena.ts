import type { Scene } from '#scene/scene';
import { serializeScene } from '#scene/serialize';

/** Nothing differs but what examples themselves change: the options of the robot. */
export function isSameArena(one: Scene, other: Scene): boolean {
  const text = (scene: Scene): string => serializeScene({ ...scene, robot: { ...scene.robot, options: {} } });
  return one === other || text(one) === text(other);
}
