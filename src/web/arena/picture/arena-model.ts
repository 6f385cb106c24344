import type { Pose, Vec } from '#core/geometry';
import type { Verdict } from '#simulation/verdict';
import type { LightForm } from '../../work/settings/light-wish';

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
  /** Where the moving obstacles are now, by object id; left out: where they start. */
  readonly movers?: Readonly<Record<string, Pose>>;
  /** How well the robot does what the course asks for; `null` or left out: it asks for nothing. */
  readonly verdict?: Verdict | null;
  /** Chains of colour lights by the name of their pin's wire; red, green, blue 0 … 255 each. */
  readonly lights: readonly { readonly pin: string; readonly colors: readonly (readonly [number, number, number])[] }[];
}

/** The robot at one moment. */
export interface ArenaRobot {
  readonly pose: Pose;
  /** How far each wheel has turned since the start: left, right. */
  readonly wheelTurnRad: readonly [number, number];
  /** Length of the path since the start. */
  readonly pathMm: number;
  /** Turned since the start, counter-clockwise positive, not wrapped. */
  readonly turnedRad: number;
  readonly state: ArenaRobotState;
}

/** The lights and senses of a robot, as far as they can be seen. */
export interface ArenaRobotState {
  /** 0 … 1. */
  readonly leds: { readonly left: number; readonly right: number };
  /** Red, green, blue 0 … 255 per light under the body. */
  readonly rgb: readonly (readonly [number, number, number])[];
  readonly lineSensors: readonly ArenaLineSensor[];
  readonly ultrasonic: ArenaCone | null;
  /** Whether each half of the bumper is pressed; `null` while the robot carries none. */
  readonly bumper: { readonly left: boolean; readonly right: boolean } | null;
  /** Its attachments; left out: none. */
  readonly attachments?: readonly ArenaAttachment[];
}

/** Something that a servo moves, as it is seen. An `AttachmentState` fits. */
export interface ArenaAttachment {
  /** Id of its type. */
  readonly type: string;
  /** Where it is fixed, robot frame, mm of the real robot. */
  readonly atMm: Vec;
  /** How far its parts are turned, counter-clockwise; one that is left out rests. */
  readonly turnRad: Readonly<Record<string, number>>;
  /** How high it lifts, in mm of the real robot. */
  readonly heightMm: number;
  /** It holds or carries a block. */
  readonly isHolding: boolean;
}

/** A line sensor and what it sees. */
export interface ArenaLineSensor {
  readonly name: string;
  /** Robot frame, as on the real robot. */
  readonly atMm: Vec;
  readonly bright: boolean;
  /** What the program reads; left out where the robot knows only light and dark. */
  readonly reading?: number;
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
  /** Where attachments are fixed; left out or `null`: none can be. */
  readonly mountMm?: Vec | null;
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

/** The overlays. */
export interface ArenaOptions {
  /** The ultrasonic cone with its hit point and distance. */
  readonly cone: boolean;
  /** What each line sensor sees of the floor, and what it reads. */
  readonly spots: boolean;
  /** The point around which the robot turns. */
  readonly centre: boolean;
  /** Where the robot has come by. */
  readonly trace: boolean;
  /** Forms of the chains of lights that lie on the robot, by the name of their pin's wire. */
  readonly lights: Readonly<Record<string, LightForm>>;
}
