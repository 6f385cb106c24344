/**
 * What a robot is: data and wiring. Read this first.
 *
 * Robot frame: origin on the floor in the middle of the axle, x forward, y left. Millimetres, grams, radians,
 * counter-clockwise positive. Heading 0 looks along the world's +x.
 *
 *               x, forward
 *               ↑
 *          ┌────┴────┐
 *        ┌─┘  sensor └─┐
 *        └┐           ┌┘
 *       ▐█│     ·     │█▌     · = origin, wheels at y = ± half the track
 *   y ←─▐█│───────────│█▌
 *       ▐█└───────────┘█▌
 *
 * A drawing (robot.svg) shows the robot from above in the same millimetres and with the same origin; as SVG's y points
 * down, forward is −y there and left is −x.
 *
 * A robot never sees the program: it is attached to a board's wires and bus and to a body in the world, and asks about
 * the surroundings through the functions it is given.
 */
import type { Board } from '#board/board';
import type { Clock } from '#core/clock';
import type { Vec } from '#core/geometry';
import type { Rng } from '#core/rng';
import type { Stop } from '#core/stop';
import type { Rgb } from '#devices/ws2812';
import type { Chassis, ChassisType } from '#world/chassis';
import type { Cone, ConeHit } from '#world/world';

/** A kind of robot. */
export interface RobotType {
  /** The folder's name; used in course files and on the command line. */
  readonly id: string;
  /** The name printed on the box. */
  readonly name: string;
  /** Id of the board type that is plugged in by default. */
  readonly board: string;
  readonly body: ChassisType;
  /** Python files the robot brings along: file name → source. Importing one of them hints at this robot, nothing more. */
  readonly libraries: Readonly<Record<string, string>>;
  readonly examples: readonly RobotExample[];
  /** An SVG document; see the frame above. */
  readonly drawing: string;
  /** Wires a robot of this kind to a board and a body. */
  attach(context: RobotContext): Robot;
}

/** A program for pupils that comes with a robot. */
export interface RobotExample {
  /** File name, ending in .py. */
  readonly file: string;
  readonly title: { readonly de: string; readonly en: string };
  readonly source: string;
}

/** What a robot is attached to. Its places in the data above are those of the real robot: it multiplies them by `scale`. */
export interface RobotContext {
  readonly clock: Clock;
  readonly board: Board;
  readonly chassis: Chassis;
  /** Reflectance under a round spot, 0 black … 1 bare floor. Spot in the robot frame, at the scale of this robot. */
  readonly ground: (spot: Vec, radiusMm: number) => number;
  /** What a distance sensor at `from` (robot frame) faces that looks along `headingRad` (0 = forward). */
  readonly distance: (from: Vec, headingRad: number, cone: Cone) => ConeHit;
  readonly rng: Rng;
  /** 0 ideal … 1 like a used school robot. Accepted; every robot is ideal for now. */
  readonly reality: number;
  /** Size of this robot compared with the real one: 1 = as built. */
  readonly scale: number;
}

/** One attached robot. */
export interface Robot {
  /** What can be seen of it now. Asks the world for the beam of the distance sensor: call it per picture, not per step. */
  state(): RobotState;
  /** Takes the robot off the board: afterwards its wires float and its addresses are free. The motors stop. */
  readonly detach: Stop;
}

/** What can be seen of a robot: plain data. */
export interface RobotState {
  /** The two red lights, 1 = on. */
  readonly leds: { readonly left: 0 | 1; readonly right: 0 | 1 };
  /** Colour lights below the body: front left, back left, back right, front right. */
  readonly rgb: readonly Rgb[];
  readonly lineSensors: readonly LineSensorState[];
  /** Angle in degrees by port, for each servo that was ever set. */
  readonly servos: Readonly<Record<string, number>>;
  /** Duty of the motors, −1 … 1. */
  readonly duty: { readonly left: number; readonly right: number };
  /** The beam of the distance sensor now, or `null` for a robot without one. */
  readonly ultrasonic: UltrasonicState | null;
}

/** A line sensor as seen from outside; its indicator LED is lit while `bright`. */
export interface LineSensorState {
  readonly name: string;
  /** Robot frame, as on the real robot. */
  readonly atMm: Vec;
  readonly bright: boolean;
}

/** A distance sensor's beam, world frame. */
export interface UltrasonicState {
  readonly fromMm: Vec;
  readonly headingRad: number;
  /** Full opening angle. */
  readonly openingRad: number;
  /** To the nearest thing in the beam, or `null` when nothing is in range. */
  readonly distanceMm: number | null;
  readonly hitMm: Vec | null;
}
