import type { Pose } from '#core/geometry';
import type { Form } from '#picture/form';
import type { RobotType } from '#robots/robot';
import type { RobotSnapshot } from '#simulation/snapshot';
import type { LightForm } from '../../../session/work/settings/light-wish';

/** The drawn state of a robot, during a run or at its start. */
export type ArenaRobot = Pick<RobotSnapshot, 'pose' | 'wheelTurnRad' | 'pathMm' | 'turnedRad' | 'state'>;

/** The robot type as the arena sees it: the id of its drawing, its outline and its mount. A `RobotType` fits. */
export type RobotLook = Pick<RobotType, 'id'> &
  Partial<Pick<RobotType, 'mountMm'>> & { readonly body: Pick<RobotType['body'], 'outlineMm'> };

/** A block at its current pose. */
export interface PlacedBlock extends Form {
  readonly id: string;
  readonly pose: Pose;
}

/** The overlays that are switched on. */
export interface ArenaOptions {
  /** The ultrasonic cone with its hit point and distance; the fan of a lidar with those of its rays. */
  readonly cone: boolean;
  /** The spot of floor that each line sensor sees, and its reading. */
  readonly spots: boolean;
  /** The point around which the robot turns. */
  readonly centre: boolean;
  /** The path of the robot so far. */
  readonly trace: boolean;
  /** Forms of the chains of lights that lie on the robot, by the name of their pin's wire. */
  readonly lights: Readonly<Record<string, LightForm>>;
}
