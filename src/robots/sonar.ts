/** What robots with a distance sensor share: where it looks from and how its beam shows. */
import { exactCos, exactSin } from '#core/exact-math';
import type { Vec } from '#core/geometry';
import { FARTHEST_MM } from '#devices/hc-sr04';
import type { Cone } from '#world/world';
import type { RobotContext, UltrasonicState } from './robot';

/** Its cans end so far ahead of its board, about whose middle a servo turns it. Chosen after the drawings. */
const HEAD_MM = 11;

/**
 * The beam of an HC-SR04 and of its like: 20° as in TigerJython's own simulators (Tiger-Jython/Aplu-Libraries, MbRobotSim
 * and CallibotSim), as far as the sensor measures. For the Calli:bot, whose sensor nobody names, chosen.
 */
export const SR04_CONE: Cone = { openingRad: Math.PI / 9, rangeMm: FARTHEST_MM };

/** A distance sensor's place on its robot, looking ahead. */
export interface SonarMount {
  /** Robot frame, as on the real robot. */
  readonly atMm: Vec;
  readonly cone: Cone;
  /** How far it is turned away from forward now, in rad, left positive. */
  readonly turnRad: () => number;
}

/** A mounted distance sensor. */
export interface Sonar {
  /** What it faces now, in mm; `Infinity` when nothing is in range. */
  readonly distanceMm: () => number;
  /** How its beam shows. */
  state(): UltrasonicState;
}

/** Mounts a distance sensor on a robot of any scale. */
export function mountSonar(context: RobotContext, { atMm, cone, turnRad }: SonarMount): Sonar {
  const from = (): Vec => {
    const turn = turnRad();
    const ahead = HEAD_MM * (exactCos(turn) - 1);
    return scaled({ x: atMm.x + ahead, y: atMm.y + HEAD_MM * exactSin(turn) }, context.scale);
  };
  const look = () => context.distance(from(), turnRad(), cone);
  return {
    distanceMm: () => look().distanceMm,
    state: () => {
      const { distanceMm, hitMm } = look();
      return {
        fromMm: context.chassis.toWorld(from()),
        headingRad: context.chassis.pose().headingRad + turnRad(),
        openingRad: cone.openingRad,
        distanceMm: distanceMm === Infinity ? null : distanceMm,
        hitMm,
      };
    },
  };
}

/** A place on the real robot, on one of another size. */
export const scaled = ({ x, y }: Vec, scale: number): Vec => ({ x: x * scale, y: y * scale });
