import type { Pose, Vec } from '#core/geometry';

/**
 * What the arena needs to know of a run, as plain data. The simulation's snapshots have this shape (and more), so
 * the drawing depends on no engine and can be fed from a file as well.
 */
export interface ArenaSnapshot {
  /** Simulated time in µs; the cone's arcs breathe with it. */
  readonly timeUs: number;
  /** 25 brightness levels 0 … 9, row by row; mirrored on the robot's back. */
  readonly display: ArrayLike<number>;
  readonly robot: ArenaRobot | null;
  /** Where the movable blocks are now, by object id. */
  readonly blocks: Readonly<Record<string, Pose>>;
}

/** The robot at one moment. */
export interface ArenaRobot {
  readonly pose: Pose;
  /** How far each wheel has turned since the start: left, right. */
  readonly wheelTurnRad: readonly [number, number];
  readonly state: ArenaRobotState;
}

/** The lights and senses of a robot, as far as they can be seen. */
export interface ArenaRobotState {
  /** 0 … 1. */
  readonly leds: { readonly left: number; readonly right: number };
  /** Red, green, blue 0 … 255 per light under the body. */
  readonly rgb: readonly (readonly [number, number, number])[];
  readonly lineSensors: readonly { readonly name: string; readonly bright: boolean }[];
  readonly ultrasonic: ArenaCone | null;
}

/** An ultrasonic sensor and what it faces. */
export interface ArenaCone {
  /** World mm. */
  readonly fromMm: Vec;
  readonly headingRad: number;
  /** Full opening angle. */
  readonly openingRad: number;
  /** `null` when nothing is in range. */
  readonly distanceMm: number | null;
  readonly hitMm: Vec | null;
}

/** What the arena needs to know of a robot type: its drawing and its outline. A `RobotType` fits. */
export interface RobotLook {
  readonly id: string;
  /** The text of its robot.svg, see `robot-drawing.ts` for its rules. */
  readonly drawing: string;
  readonly body: {
    /** Convex parts in the robot's frame: x forward, y left, mm. */
    readonly outlineMm: readonly (readonly Vec[])[];
  };
}

/** A block as it lies now. */
export interface PlacedBlock {
  readonly id: string;
  readonly pose: Pose;
  /** Extent along its own x and y. */
  readonly sizeMm: Vec;
}

/** Where the hand puts a thing. */
export interface PlacedPose {
  readonly xMm: number;
  readonly yMm: number;
  /** Degrees counter-clockwise from +x, more than −180 up to 180. */
  readonly headingDeg: number;
}

/** What is drawn besides the things themselves. */
export interface ArenaOptions {
  /** The ultrasonic cone with its hit point and distance. */
  readonly cone: boolean;
}
