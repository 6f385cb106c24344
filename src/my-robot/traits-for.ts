import type { Traits } from '#robots/traits';
import type { MyRobot } from './my-robot';

/** The traits of this robot for a run with a robot of this type, if it is to be used. */
export function traitsFor(mine: MyRobot | null | undefined, robot: string | undefined): Traits | undefined {
  return mine?.used === true && mine.robot === robot ? mine.traits : undefined;
}
