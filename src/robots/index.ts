// Written by `npm run robots`: do not edit.
import { bitbotXl } from './bitbot-xl/type';
import { callibot } from './callibot/type';
import { cutebot } from './cutebot/type';
import { maqueenLite } from './maqueen-lite/type';
import { maqueenPlusV1 } from './maqueen-plus-v1/type';
import { maqueenPlusV2 } from './maqueen-plus-v2/type';
import { maqueenPlusV3 } from './maqueen-plus-v3/type';
import { motionkit2 } from './motionkit-2/type';
import type { RobotType } from './robot';

/** Every robot there is, in the order in which they are offered. */
export const robotTypes: readonly RobotType[] = [
  bitbotXl,
  callibot,
  cutebot,
  maqueenLite,
  maqueenPlusV1,
  maqueenPlusV2,
  maqueenPlusV3,
  motionkit2,
].sort((one, other) => one.place - other.place);

/** The robot with this id, or `null`. */
export function findRobot(id: string): RobotType | null {
  return robotTypes.find((type) => type.id === id) ?? null;
}
