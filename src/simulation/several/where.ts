import type { Vec } from '#core/geometry';
import type { Scene } from '#scene/scene';
import type { Device } from '../device';

/** The place of a board without a robot: a person holds it at the lower edge of the arena. World mm. */
export const heldIn = ({ size: [width] }: Pick<Scene, 'size'>): Vec => ({ x: width / 2, y: 0 });

/** The place of a device: that of its robot, or of the hand that holds it. World mm. */
export function whereIs({ mounted }: Device, scene: Scene): Vec {
  const pose = mounted?.chassis.pose();
  return pose ? { x: pose.xMm, y: pose.yMm } : heldIn(scene);
}
