/**
 * What an attachment is: something that a servo moves, fixed to the middle of a robot's front edge (its mount).
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
  /** What its servo's angles mean, in a sentence. */
  readonly about: Texts;
  /**
   * Where its servo stands at the start, in degrees: as on a robot that was just switched on. Nothing holds a servo
   * without a signal, so fork and shovel have sunk to the floor, the claw stands open and the sensor looks ahead.
   */
  readonly restDeg: number;
  attach(context: AttachmentContext): Attachment;
}

/** What an attachment is fixed to. */
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
  /** Whether it holds or carries a block. */
  isHolding(): boolean;
  /** How far it turns the distance sensor away from forward, in rad, left positive; 0 for most. */
  sonarTurnRad(): number;
  /** The visible pose of its moving parts. */
  pose(): AttachmentPose;
  readonly remove: Stop;
}

/** Where the moving parts of an attachment are. */
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
  /** Where it is fixed, robot frame, at the size of the real robot. */
  readonly atMm: Vec;
  /** Where its servo is now, on its way to the angle that was set. */
  readonly angleDeg: number;
  readonly isHolding: boolean;
}
