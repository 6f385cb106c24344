import type { Chassis, ChassisPart } from '#world/chassis';
import type { RobotContext } from '../robot';
import { scaled } from '../sonar';
import type { Side } from '#devices/dc-motor';
import { BUMPER_LEFT, BUMPER_RIGHT } from './type';

/** The bar in front with its two switches. */
export interface Bumper {
  /** True if this half is pressed, for a program. The first call puts the bumper on. */
  read(side: Side): boolean;
  /** For each half: true if it is pressed; `null` while the robot carries no bumper. */
  state(): { readonly left: boolean; readonly right: boolean } | null;
  stop(): void;
}

type Halves = Readonly<Record<Side, ChassisPart>>;

/**
 * Makes the bumper of a Calli:bot.
 *
 * @param fitting `when-read`: the robot carries it as soon as a program reads it, so that it never obstructs a program
 *   that does not know it
 */
export function createBumper({ chassis, scale }: RobotContext, fitting: 'never' | 'when-read' | 'always'): Bumper {
  let halves: Halves | null = fitting === 'always' ? putOn(chassis, scale) : null;
  return {
    read: (side) => {
      if (fitting === 'never') return false;
      halves ??= putOn(chassis, scale);
      return halves[side].isTouched();
    },
    state: () => halves && { left: halves.left.isTouched(), right: halves.right.isTouched() },
    stop: () => {
      halves?.left.remove();
      halves?.right.remove();
      halves = null;
    },
  };
}

function putOn(chassis: Chassis, scale: number): Halves {
  return {
    left: chassis.addPart(BUMPER_LEFT.map((corner) => scaled(corner, scale))),
    right: chassis.addPart(BUMPER_RIGHT.map((corner) => scaled(corner, scale))),
  };
}
