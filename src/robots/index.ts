import { maqueenLite } from './maqueen-lite/robot';
import type { RobotType } from './robot';

/** Every robot there is, in the order in which they are offered. */
export const robotTypes: readonly RobotType[] = [maqueenLite];

/** The robot with this id, or `null`. */
export function findRobot(id: string): RobotType | null {
  return robotTypes.find((type) => type.id === id) ?? null;
}
