/**
 * An attachment: something that a servo moves, fixed to the middle of a robot's front edge (its mount).
 *
 * Frame of an attachment: origin at the mount, x forward, y left, mm, at the size of the real robot.
 */
import type { Stop } from '#core/stop';
import type { Texts } from '#core/languages';
import type { Vec } from '#core/geometry';
import type { Chassis } from '#world/chassis';

/** A kind of attachment, as everyone may know it. */
export interface AttachmentType {
  /** Used in course files and on the command line. */
  readonly id: string;
  readonly title: Texts;
  /** One sentence on the meaning of its servo's angles. */
  readonly about: Texts;
  /**
   * Angle of its servo at the start, in degrees: as on a robot that was just switched on. A servo without a signal
   * exerts no force, so fork and shovel have sunk to the floor, the claw is open and the sensor faces ahead.
   */
  readonly restDeg: number;
  attach(context: AttachmentContext): Attachment;
}

/** The robot's side of an attachment: the chassis and everything else it is fixed to. */
export interface AttachmentContext {
  readonly chassis: Chassis;
  /** Robot frame, at the size of the real robot. */
  readonly mountMm: Vec;
  /** Size of this robot compared with the real one. */
  readonly scale: number;
}

/** One attachment on one robot. */
export interface Attachment {
  /** Moves it to where its servo is now, in degrees. */
  move(angleDeg: number): void;
  /** True while it holds or carries a block. */
  isHolding(): boolean;
  /** Angle by which it turns the distance sensor away from forward, in rad, left positive; 0 for most. */
  sonarTurnRad(): number;
  /** The visible pose of its moving parts. */
  pose(): AttachmentPose;
  readonly remove: Stop;
}

/** Positions of the moving parts of an attachment. */
export interface AttachmentPose {
  /** By part: how far it has turned from its place in the drawing, in rad, counter-clockwise seen from above. */
  readonly turnRad: Readonly<Record<string, number>>;
  /** Height above the floor in mm, for what is lifted; at the size of the real robot. */
  readonly heightMm: number;
}

/** The visible state of an attachment, as plain data. */
export interface AttachmentState extends AttachmentPose {
  /** Id of its type. */
  readonly type: string;
  /** The servo port that moves it. */
  readonly port: string;
  /** Mounting point, robot frame, at the size of the real robot. */
  readonly atMm: Vec;
  /** Current angle of its servo while it moves to the angle that was set. */
  readonly angleDeg: number;
  readonly isHolding: boolean;
}
