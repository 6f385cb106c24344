/** Shared by robots with a distance sensor: its position, and the display of its beam. */
import { exactCos, exactSin } from '#core/exact-math';
import type { Vec } from '#core/geometry';
import { FARTHEST_MM, NEAREST_MM } from '#devices/hc-sr04';
import type { Cone } from '#world/probes/distance-cone';
import type { RobotContext, UltrasonicState } from './robot';

/** Distance of its cans ahead of its board, about whose middle a servo turns it. Chosen after the drawings. */
const HEAD_MM = 11;

/**
 * The beam of an HC-SR04 and similar sensors: 20° as in TigerJython's own simulators (Tiger-Jython/Aplu-Libraries,
 * MbRobotSim and CallibotSim), as far as the sensor measures. Chosen for the Calli:bot, whose sensor is not documented.
 * Its height is chosen: the cans of all these robots sit a little above the wheels. It is not scaled with the robot, as a
 * large one would look over every block.
 */
export const SR04_CONE: Cone = { openingRad: Math.PI / 9, rangeMm: FARTHEST_MM, heightMm: 40 };

/** A distance sensor's place on its robot, looking ahead. */
export interface SonarMount {
  /** Robot frame, on the real robot. */
  readonly atMm: Vec;
  readonly cone: Cone;
  /** Its present angle from forward, in rad, left positive. */
  readonly turnRad: () => number;
}

/** A mounted distance sensor. */
export interface Sonar {
  /** Its present reading, in mm; `Infinity` if nothing is in range. */
  readonly distanceMm: () => number;
  /** The display of its beam. */
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
        distanceMm: distanceMm === Infinity ? null : Math.max(distanceMm, NEAREST_MM),
        hitMm,
      };
    },
  };
}

/** A place on the real robot, converted to a robot of another size. */
export const scaled = ({ x, y }: Vec, scale: number): Vec => ({ x: x * scale, y: y * scale });
