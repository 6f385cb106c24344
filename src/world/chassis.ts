import type { Pose, Vec } from '#core/geometry';
import type { Stop } from '#core/stop';
import type { DriveLaw } from './drive-law';

/** A wheel of a chassis; its axle lies along y. */
export interface Wheel {
  /** Its contact point with the floor, robot frame, mm. */
  readonly atMm: Vec;
  readonly radiusMm: number;
  /** Friction coefficient between tyre and floor. */
  readonly gripMu: number;
}

/** The body of a robot. Robot frame: x forward, y left, origin on the floor at the middle of the axle; mm and g. */
export interface ChassisType {
  /** Convex solid parts, each with 3 to 12 corners, counter-clockwise. */
  readonly outlineMm: readonly (readonly Vec[])[];
  /** Its top above the floor, for the sensors of others; parts added to it count as that high. */
  readonly heightMm: number;
  readonly massG: number;
  readonly centreOfMassMm: Vec;
  /** Moment of inertia about the centre of mass in g·mm²; left out: that of the evenly filled outline. */
  readonly inertiaGMm2?: number;
  /** Left wheel, right wheel. */
  readonly wheels: readonly [Wheel, Wheel];
  /** Position of the castor, which carries its share of the weight. Left out: the wheels carry everything. */
  readonly castorMm?: Vec;
  readonly drive: DriveLaw;
  /**
   * Strength of the left and the right motor compared with `drive` (stall force and v0 alike); left out: 1 and 1.
   * Unequal motors make a robot drift.
   */
  readonly strength?: readonly [number, number];
}

/** The place of a robot's frame in the world: its origin in the physics engine's units, and its heading. */
export interface Stance {
  readonly x: number;
  readonly y: number;
  readonly sin: number;
  readonly cos: number;
}

/** 0 = left wheel, 1 = right wheel. */
export type WheelSide = 0 | 1;

/** A robot's body in the world. */
export interface Chassis {
  /** Position of the middle of the axle, and the heading. The heading is not wrapped: it grows with every turn. */
  pose(): Pose;
  /** The hand tool: puts the robot there, standing still. Neither path nor turn counts this move. */
  place(pose: Pose): void;
  /** Duty of a motor from −1 (full speed back) to 1; 0 brakes. Values beyond are clamped. Holds until the next call. */
  setDuty(wheel: WheelSide, duty: number): void;
  /** The duty that was set, −1 … 1. */
  duty(wheel: WheelSide): number;
  /**
   * Gives it another battery than a full one that never weakens. `supply` is its voltage compared with that, 0 … 1, while
   * the motors run at these duties: it weakens both like a smaller duty.
   */
  setBattery(supply: (left: number, right: number) => number): void;
  /** Speed of the wheel's rim in mm/s, forward positive. A slipping wheel's floor speed differs. */
  wheelSpeedMmPerS(wheel: WheelSide): number;
  /** How far the wheel has turned since the start, in rad, forward positive. */
  wheelTurnRad(wheel: WheelSide): number;
  /** How far the robot has turned since the start, in rad, counter-clockwise positive, not wrapped. */
  turnedRad(): number;
  /** Length of the path of the middle of the axle since the start, in mm. */
  pathMm(): number;
  /**
   * Number of new touches of a wall or block since the start, with the body, with parts added to it or with what it
   * holds. Jaws and forks that touch movable blocks do their work; these touches do not count.
   */
  collisions(): number;
  /**
   * Ids of everything that touches it now, counted as in `collisions`, in the order of first touches. `null` stands for
   * the arena's edge, other robots and things without an id.
   */
  touching(): readonly (string | null)[];
  /** True if another robot touches it now, counted as in `collisions`. */
  isTouching(other: Chassis): boolean;
  /** From the robot frame to the world, mm. @param stance where it was; left out: where it is now */
  toWorld(point: Vec, stance?: Stance): Vec;
  /** Its place now, for `toWorld` later. */
  stance(): Stance;
  /**
   * Convex outlines of all that is solid on the robot now besides its type's body: added parts, jaws and fork where they
   * stand, and what they hold. Robot frame, mm, counter-clockwise.
   */
  addedMm(): readonly (readonly Vec[])[];
  /**
   * Adds something solid to the body that is not part of its type, such as a bumper or a plate. Mass and drive stay as
   * they are.
   *
   * @param outlineMm convex, counter-clockwise, robot frame (of this robot's size), 3 to 12 corners
   */
  addPart(outlineMm: readonly Vec[]): ChassisPart;
  /** Adds a gripper with two jaws; lengths at this robot's size. The first `setSwing` puts the jaws there at once. */
  addGripper(type: GripperType): Gripper;
  /** Adds a fork or bucket that takes up blocks, lowered to the floor; lengths at this robot's size. */
  addFork(type: ForkType): Fork;
}

/** A part that was added to a body. */
export interface ChassisPart {
  /** Whether a wall, the arena's edge or a block presses against it, as the last step of the world left it. */
  isTouched(): boolean;
  readonly remove: Stop;
}

/** Two jaws that swing about their hinges, mirror images of each other. Robot frame, mm. */
export interface GripperType {
  /** Hinge of the left jaw; the right one's is mirrored at the x axis. */
  readonly hingeMm: Vec;
  /**
   * The left jaw at swing 0, pointing forward, relative to its hinge: one or more convex parts, counter-clockwise. Its
   * inner side, which touches the gripped block, has the smaller y.
   */
  readonly jawMm: readonly (readonly Vec[])[];
  /** How hard a jaw presses at its tip, in newton. Each jaw moves the blocks whose friction on the floor is less. */
  readonly forceN: number;
}

/**
 * A gripper on a robot. Swing: angle of each jaw outwards from pointing straight ahead, in rad; 0 = closed. The jaws
 * are geared together: an obstacle to one stops both.
 *
 * A block (or a few that stand against each other) is held when both jaws touch it and can close no farther. It then
 * moves with the robot as a part of its body, until the jaws are told to open to their present width or wider.
 */
export interface Gripper {
  /**
   * The target of the servo, from 0; the jaws follow at 10 rad/s at most. They push movable blocks aside and stop at
   * everything else. Pushing does not move the robot.
   */
  setSwing(swingRad: number): void;
  /** The present swing of the jaws. */
  swingRad(): number;
  /** True if a block is held and so moves with the robot until the jaws open. */
  isHolding(): boolean;
  readonly remove: Stop;
}

/** A fork, shovel or bucket ahead of the robot that is lowered to the floor and lifted. Robot frame, mm. */
export interface ForkType {
  /** Lies on the floor when it is down: convex, counter-clockwise. Blocks whose middle is above it are lifted. */
  readonly plateMm: readonly Vec[];
  /** Height from which a block is clear of the floor. */
  readonly clearMm: number;
}

/**
 * A fork on a robot. Up to `clearMm` its plate slides under movable blocks and is stopped by everything else. Above, it
 * carries the blocks whose middle is above it, as a part of the robot's body, and every other block stops it.
 */
export interface Fork {
  /** Height of the plate above the floor, 0 = down. It takes effect at once. */
  setHeightMm(heightMm: number): void;
  heightMm(): number;
  /** True if it carries a block clear of the floor. */
  isHolding(): boolean;
  readonly remove: Stop;
}
