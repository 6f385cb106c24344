import type { Pose, Vec } from '#core/geometry';
import type { DriveLaw } from './drive-law';

/** A wheel of a chassis; its axle lies along y. */
export interface Wheel {
  /** Where it touches the floor, robot frame, mm. */
  readonly atMm: Vec;
  readonly radiusMm: number;
  /** Friction coefficient between tyre and floor. */
  readonly gripMu: number;
}

/** The body of a robot. Robot frame: x forward, y left, origin on the floor at the middle of the axle; mm and g. */
export interface ChassisType {
  /** Convex parts that bump into things, each with 3 to 12 corners, counter-clockwise. */
  readonly outlineMm: readonly (readonly Vec[])[];
  readonly massG: number;
  readonly centreOfMassMm: Vec;
  /** Moment of inertia about the centre of mass in g·mm²; left out: that of the outline, evenly filled. */
  readonly inertiaGMm2?: number;
  /** Left wheel, right wheel. */
  readonly wheels: readonly [Wheel, Wheel];
  /** Where the castor stands; it carries its share of the weight. Left out: the wheels carry everything. */
  readonly castorMm?: Vec;
  readonly drive: DriveLaw;
}

/** 0 = left wheel, 1 = right wheel. */
export type WheelSide = 0 | 1;

/** A robot's body in the world. */
export interface Chassis {
  /** Where the middle of the axle is and where the robot looks. The heading is not wrapped: it grows with every turn. */
  pose(): Pose;
  /** The hand: puts the robot there, standing still. Neither path nor turn counts the way. */
  place(pose: Pose): void;
  /** Duty of a motor from −1 (full speed back) to 1; 0 brakes. Values beyond are clamped. Holds until the next call. */
  setDuty(wheel: WheelSide, duty: number): void;
  /** Speed of the wheel's rim in mm/s, forward positive; on a slipping wheel not that of the floor. */
  wheelSpeedMmPerS(wheel: WheelSide): number;
  /** How far the wheel has turned since the start, in rad, forward positive. */
  wheelTurnRad(wheel: WheelSide): number;
  /** How far the robot has turned since the start, in rad, counter-clockwise positive, not wrapped. */
  turnedRad(): number;
  /** Length of the way of the middle of the axle since the start, in mm. */
  pathMm(): number;
  /** How many times the robot has touched a wall or block anew since the start. */
  collisions(): number;
  /** From the robot frame to the world, mm. */
  toWorld(point: Vec): Vec;
}
