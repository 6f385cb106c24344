import type { Pose, Vec } from '#core/geometry';
import type { Point } from '#scene/scene';
import type { RobotType } from '#robots/robot';
import type { RobotSnapshot } from '#simulation/snapshot';
import type { LightForm } from '../../work/settings/light-wish';

/** What is drawn of a robot, during a run or at its start. */
export type ArenaRobot = Pick<RobotSnapshot, 'pose' | 'wheelTurnRad' | 'pathMm' | 'turnedRad' | 'state'>;

/** What the arena needs to know of a robot type: which drawing it has, and its outline. A `RobotType` fits. */
export type RobotLook = Pick<RobotType, 'id'> &
  Partial<Pick<RobotType, 'mountMm'>> & { readonly body: Pick<RobotType['body'], 'outlineMm'> };

/** What is drawn of a shape: a rectangle, an ellipse or a polygon about its middle. mm. */
export interface Form {
  readonly sizeMm: Vec;
  readonly round?: boolean | undefined;
  readonly corners?: readonly Point[] | undefined;
}

/** A block as it lies now. */
export interface PlacedBlock extends Form {
  readonly id: string;
  readonly pose: Pose;
}

/** The overlays. */
export interface ArenaOptions {
  /** The ultrasonic cone with its hit point and distance. */
  readonly cone: boolean;
  /** What each line sensor sees of the floor, and what it reads. */
  readonly spots: boolean;
  /** The point around which the robot turns. */
  readonly centre: boolean;
  /** The path of the robot so far. */
  readonly trace: boolean;
  /** Forms of the chains of lights that lie on the robot, by the name of their pin's wire. */
  readonly lights: Readonly<Record<string, LightForm>>;
}
