import type { Scene } from '#scene/scene';
import { serializeScene } from '#scene/serialize';

/** True if two scenes differ in nothing but the options of the robot, which examples change. */
export function isSameArena(one: Scene, other: Scene): boolean {
  const text = (scene: Scene): string => serializeScene({ ...scene, robot: { ...scene.robot, options: {} } });
  return one === other || text(one) === text(other);
}
