/**
 * What a robot is: data (RobotType, in its folder's type.ts: all that is seen of it) and wiring (RobotBuild, in its
 * robot.ts: what a run needs besides). Read this first.
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
import type { AttachmentState } from '#attachments/attachment';
import type { Board } from '#board/board';
import type { Clock } from '#core/clock';
import type { Vec } from '#core/geometry';
import type { Option, OptionValues } from '#core/option';
import type { Stop } from '#core/stop';
import type { Texts } from '#core/texts';
import type { Rgb } from '#devices/ws2812';
import type { Chassis, ChassisType } from '#world/chassis';
import type { Cone, ConeHit } from '#world/world';

/** A kind of robot: what everyone may know of it. Light, as the page loads it before anything runs. */
export interface RobotType {
  /** The folder's name; used in course files and on the command line. */
  readonly id: string;
  /** The name printed on the box. */
  readonly name: string;
  /** Place in lists, lowest first. The first robot that carries a board is taken when a program names none. */
  readonly place: number;
  /** Id of the board type that it carries. On another board nothing of the robot is connected. */
  readonly board: string;
  readonly body: ChassisType;
  /** Names of the Python modules it brings along. Importing one of them hints at this robot, nothing more. */
  readonly modules: readonly string[];
  /**
   * Names under which drivers by others go around: hints like `modules`. Small and without underscores a name stands for all
   * its spellings; spelled otherwise it stands for itself and comes first.
   */
  readonly driverNames?: readonly string[];
  /** What can be chosen about it; those of its servo ports are called like the ports. */
  readonly options: readonly Option[];
  /** Where an attachment is fixed: in the middle of the front edge. `null`: nothing can be fixed. */
  readonly mountMm: Vec | null;
  /** An SVG document; see the frame above and `robot-drawing.ts` for the names of its parts. */
  readonly drawing: string;
}

/** What a run needs of a robot. */
export interface RobotBuild {
  readonly type: RobotType;
  /** The Python files of its modules: file name → source. */
  readonly libraries: Readonly<Record<string, string>>;
  /** Wires a robot of this kind to a board and a body. */
  attach(context: RobotContext): Robot;
}

/** What pupils and teachers may read about a robot: the page of the gallery. In its folder's sheet.ts, loaded late. */
export interface RobotSheet {
  /** Id of its type. */
  readonly robot: string;
  /** Two or three sentences: what it is, what it can do. */
  readonly about: Texts;
  /** What length and width of its body leave out, e.g. `without its bumper`. */
  readonly sizeNote?: Texts;
  readonly examples: readonly RobotExample[];
  /** What is plugged where, one row per part. */
  readonly wiring: readonly WiringRow[];
  /** What answers on the I2C bus. */
  readonly registers: readonly RegisterTable[];
}

/** A part and its place on the wires. */
export interface WiringRow {
  readonly part: Texts;
  /** Pins or bus address, e.g. `P13, P14` or `I2C 0x10`. */
  readonly at: string;
  /** What its values mean. */
  readonly note?: Texts;
}

/** The registers behind one I2C address, or behind several in a row that do the same. */
export interface RegisterTable {
  readonly address: number;
  /** The last address of several in a row. */
  readonly lastAddress?: number;
  readonly title: Texts;
  readonly rows: readonly { readonly register: string; readonly access: 'R' | 'W' | 'RW'; readonly meaning: Texts }[];
}

/** A program for pupils that comes with a robot. */
export interface RobotExample {
  /** What it is called, ending in .py; its two sources stand in `examples/`, as `line.de.py` and `line.en.py`. */
  readonly file: string;
  readonly title: Texts;
  /** The same program in both languages: only comments and texts in quotes differ. */
  readonly source: Texts;
  /** Id of the ready course that it is made for, e.g. `empty` for one that drives about; left out: any arena will do. */
  readonly course?: string;
  /** What it needs of the robot, e.g. a claw on the servo port that it moves: id of an option → id of a choice. */
  readonly options?: OptionValues;
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
  /** What the battery gives now, in mV. */
  readonly supplyMv: () => number;
  /** A value for each option of the type. */
  readonly options: OptionValues;
  /** Size of this robot compared with the real one: 1 = as built. */
  readonly scale: number;
}

/** One attached robot. */
export interface Robot {
  /** What can be seen of it now. Asks the world for the beam of the distance sensor: call it per picture, not per step. */
  state(): RobotState;
  /** Called after each step of the world (every STEP_US): the time to look at the ground and to move servos. */
  step(): void;
  /** Takes the robot off the board: afterwards its wires float and its addresses are free. The motors stop. */
  readonly detach: Stop;
}

/** What can be seen of a robot: plain data. */
export interface RobotState {
  /** The two red lights, 1 = on. */
  readonly leds: { readonly left: 0 | 1; readonly right: 0 | 1 };
  /** Colour lights: front left, back left, back right, front right; on a robot with two: left, right. */
  readonly rgb: readonly Rgb[];
  readonly lineSensors: readonly LineSensorState[];
  /** Angle in degrees by port as the program set it, for each servo that was ever set. */
  readonly servos: Readonly<Record<string, number>>;
  /** What hangs on the servo ports, and where it is on its way. */
  readonly attachments: readonly AttachmentState[];
  /** Duty of the motors, −1 … 1. */
  readonly duty: { readonly left: number; readonly right: number };
  /** The beam of the distance sensor now, or `null` for a robot without one. */
  readonly ultrasonic: UltrasonicState | null;
  /** Whether each half of the bumper is pressed; `null` while the robot carries none. */
  readonly bumper: { readonly left: boolean; readonly right: boolean } | null;
}

/** A line sensor as seen from outside; its indicator LED is lit while `bright`. */
export interface LineSensorState {
  readonly name: string;
  /** Robot frame, as on the real robot. */
  readonly atMm: Vec;
  readonly bright: boolean;
  /** What `read_analog` would give now, in the robot's own unit; left out where the robot knows only light and dark. */
  readonly reading?: number;
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
