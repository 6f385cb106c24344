/**
 * A robot consists of data (RobotType, in its folder's type.ts: everything visible about it) and wiring (RobotBuild, in
 * its robot.ts: what a run needs besides). Read this first.
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
import type { Rgb } from '#core/rgb';
import type { Stop } from '#core/stop';
import type { HuskyAlgorithm, HuskyResult } from '#devices/huskylens';
import type { InfraredLight } from '#devices/nec-remote';
import type { Texts } from '#core/languages';
import type { Chassis, ChassisType } from '#world/chassis';
import type { Camera, CameraView } from '#world/probes/camera';
import type { DepthCell, DepthView } from '#world/probes/depth-grid';
import type { Cone, ConeHit } from '#world/probes/distance-cone';
import type { Light } from '#devices/tcs34725';
import type { Shares } from '#world/shapes';
import type { ColourName, RawColour } from './colour-names';
import type { LightEye } from './light-eyes';
import type { LineReadings } from './traits';

/** A kind of robot, as everyone may know it. Light, as the page loads it before anything runs. */
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
  /** The body with these options, of the same shape; left out: all of them have `body`. */
  readonly bodyWith?: (options: OptionValues) => ChassisType;
  /** Names of the Python modules it brings along. Importing one of them only hints at this robot. */
  readonly modules: readonly string[];
  /**
   * Modules that are another one under a second name: name → the one whose file it has. Such names may differ in capitals
   * alone, as files on many computers cannot.
   */
  readonly sameModules?: Readonly<Record<string, string>>;
  /**
   * The lines of Python, below an import of all of its board's module, by which a program that measures it gets
   * `setSpeed` (percent), `forward`, `left`, `stop`, `delay` (ms) and `getDistance` (cm). Left out: its first module has
   * these names.
   */
  readonly measuring?: string;
  /**
   * Common names of drivers by others: hints like `modules`. A name in lower case without underscores stands for all
   * its spellings; any other name stands for itself and takes precedence.
   */
  readonly driverNames?: readonly string[];
  /** Its options; those of its servo ports have the names of the ports. */
  readonly options: readonly Option[];
  /** `false`: it does not hear an infrared remote control. Left out: it has a receiver. */
  readonly hearsRemote?: false;
  /** The mount of an attachment: in the middle of the front edge. `null`: nothing can be fixed. */
  readonly mountMm: Vec | null;
}

/** The body of a robot with these options. */
export const bodyOf = ({ body, bodyWith }: RobotType, options: OptionValues): ChassisType =>
  bodyWith?.(options) ?? body;

/** The parts of a robot that a run needs. */
export interface RobotBuild {
  readonly type: RobotType;
  /** The Python files of its modules: file name → source. */
  readonly libraries: Readonly<Record<string, string>>;
  /** Wires a robot of this kind to a board and a body. */
  attach(context: RobotContext): Robot;
}

/** The page of the gallery about a robot, for pupils and teachers. In its folder's sheet.ts, loaded late. */
export interface RobotSheet {
  /** Id of its type. */
  readonly robot: string;
  /** Two or three sentences: what it is and what it can do. */
  readonly about: Texts;
  /** Parts that length and width of its body leave out, e.g. `without its bumper`. */
  readonly sizeNote?: Texts;
  readonly examples: readonly RobotExample[];
  /** The wiring, one row per part. */
  readonly wiring: readonly WiringRow[];
  /** The devices that answer on the I2C bus. */
  readonly registers: readonly RegisterTable[];
}

/** A part and its place on the wires. */
export interface WiringRow {
  readonly part: Texts;
  /** Pins or bus address, e.g. `P13, P14` or `I2C 0x10`. */
  readonly at: string;
  /** The meaning of its values. */
  readonly note?: Texts;
}

/** The registers behind one I2C address, or behind several consecutive addresses that do the same. */
export interface RegisterTable {
  readonly address: number;
  /** The last of several consecutive addresses. */
  readonly lastAddress?: number;
  readonly title: Texts;
  readonly rows: readonly { readonly register: string; readonly access: 'R' | 'W' | 'RW'; readonly meaning: Texts }[];
}

/** A program for pupils that comes with a robot. */
export interface RobotExample {
  /** Name of its file in `examples/`, such as `line.py`. */
  readonly file: string;
  readonly title: Texts;
  /** One program: only its comments and strings differ between languages (`build/programs.ts`). */
  readonly source: Texts;
  /** Id of the ready course that it is made for, e.g. `empty` for driving around; left out: any arena will do. */
  readonly course?: string;
  /** The options it needs, e.g. a claw on the servo port that it moves: id of an option → id of a choice. */
  readonly options?: OptionValues;
}

/** The surroundings of a robot, which multiplies the places in its data (of the real robot) by `scale`. */
export interface RobotContext {
  readonly clock: Clock;
  readonly board: Board;
  readonly chassis: Chassis;
  /**
   * Reflectance under a round spot, 0 black … 1 bare floor. Spot in the robot frame, at the scale of this robot.
   *
   * @param stepsAgo where the robot was so many steps of the world ago, up to `MOST_STEPS_BACK`. Left out: where it is now
   */
  readonly ground: (spot: Vec, radiusMm: number, stepsAgo?: number) => number;
  /** Calls something each time before the floor changes. */
  readonly beforePaint: (act: () => void) => Stop;
  /** The reading of a distance sensor at `from` (robot frame) that looks along `headingRad` (0 = forward). */
  readonly distance: (from: Vec, headingRad: number, cone: Cone) => ConeHit;
  /** The picture of a multizone ranger whose lens is at `from` (robot frame) and looks ahead. */
  readonly depths: (from: Vec, view: DepthView) => readonly DepthCell[];
  /** Shares of red, green and blue light that the floor returns in a round spot, of white paper about 0.85. Spot in the robot frame. */
  readonly light: (spot: Vec, radiusMm: number) => Light;
  /** The nearest thing ahead of `from` (robot frame) and the light that it returns; `null`: nothing is in range. */
  readonly lightAhead: (from: Vec, cone: Cone) => { readonly distanceMm: number; readonly light: Light } | null;
  /** The sight of a camera whose lens is at `from` (robot frame) and looks ahead. It costs nothing until it is asked. */
  readonly camera: (from: Vec, view: CameraView) => Camera;
  /** The results of a camera as they come from a robot that was used: they tremble. */
  readonly seen: (results: readonly HuskyResult[]) => readonly HuskyResult[];
  /** The number under which a camera knows a colour: 1 red, 2 yellow, 3 green, 4 blue, 5 orange, 6 purple, 7 brown; 0: none. */
  readonly colourNumber: (shares: Shares) => number;
  /**
   * The level that a light sensor sees, 0 … 255 like a board's and on the same law: as the board's was set by hand, or in
   * an arena with lamps as the light falls on this eye.
   */
  readonly lightLevel: (eye: LightEye) => number;
  /** How far a move that the robot measures by itself misses its end now, in standard deviations; 0 on an ideal robot. */
  readonly miss: () => number;
  /** Present voltage of the battery, in mV. */
  readonly supplyMv: () => number;
  /** The light of a remote control on this robot. */
  readonly infrared: InfraredLight;
  /** A value for each option of the type. */
  readonly options: OptionValues;
  /** Size of this robot compared with the real one: 1 = as built. */
  readonly scale: number;
  /** The readings of its line sensors by name, where they differ from the type's. */
  readonly lineReadings: Readonly<Record<string, LineReadings>>;
  /** Called when the program sets an output that is not a wire's level; left out: these are not reported. */
  readonly onSet?: OnSet;
}

/**
 * The outputs of a robot that a program sets: the motor of a wheel, a red light, a colour light by its place in `rgb`, a servo by its
 * port.
 */
export type RobotOutput =
  'wheel-left' | 'wheel-right' | 'light-left' | 'light-right' | `color-${number}` | `servo-${string}`;

/** Called when the program sets an output, even to the value that it has: `value` is then the same as before. */
export type OnSet = (output: RobotOutput, value: string | number) => void;

/** The lights of a robot without any, for all that a robot's own leave as it is. */
export const noLights: RobotLights = { leds: { left: 0, right: 0 }, rgb: [], lamps: [] };

/** The state of a robot without any part, for all that a robot's own state leaves as it is. */
export const bareState: RobotState = {
  ...noLights,
  ...{ lineSensors: [], servos: {}, attachments: [] },
  duty: { left: 0, right: 0 },
  ...{ ultrasonic: null, lidar: null, bumper: null },
};

/** One attached robot. */
export interface Robot {
  /** Its wires on the board, by name, with the outputs that a program sets by what it writes there, if any. */
  readonly wires: Readonly<Record<string, readonly RobotOutput[]>>;
  /** Its lights now: a small part of its state, which asks the world for nothing. */
  lights(): RobotLights;
  /** Its visible state now. Asks the world for the beam of the distance sensor: call it per picture, not per step. */
  state(): RobotState;
  /** Called after each step of the world (every STEP_US), to look at the ground and to move servos. */
  step(): void;
  /** Takes the robot off the board: afterwards its wires float and its addresses are free. The motors stop. */
  readonly detach: Stop;
}

/** The lights of a robot, as plain data. */
export interface RobotLights {
  /** The two red lights, 1 = on; on a robot with colour lamps off. */
  readonly leds: { readonly left: 0 | 1; readonly right: 0 | 1 };
  /** Colour lights, any number, the left half first: front left, back left, back right, front right; left, right; two arms. */
  readonly rgb: readonly Rgb[];
  /** Colour lamps in front, left and right, that its controller drives; none on a robot with red lights or `rgb` alone. */
  readonly lamps: readonly Rgb[];
}

/** The visible state of a robot, as plain data. */
export interface RobotState extends RobotLights {
  readonly lineSensors: readonly LineSensorState[];
  /** Angle in degrees by port as the program set it, for each servo that was ever set. */
  readonly servos: Readonly<Record<string, number>>;
  /** The attachments on the servo ports, with their present positions. */
  readonly attachments: readonly AttachmentState[];
  /** Duty of the motors, −1 … 1. */
  readonly duty: { readonly left: number; readonly right: number };
  /** The beam of the distance sensor now, or `null` for a robot without one. */
  readonly ultrasonic: UltrasonicState | null;
  /** The picture of the lidar now, or `null` for a robot without one. */
  readonly lidar: LidarState | null;
  /** The colour sensors that it carries; left out: none. */
  readonly colours?: readonly ColourState[];
  /** The camera that it carries; left out: none. */
  readonly camera?: CameraState;
  /** For each half of the bumper: true if it is pressed; `null` while the robot carries none. */
  readonly bumper: { readonly left: boolean; readonly right: boolean } | null;
}

/** A line sensor, as seen from outside; its indicator LED is lit while `bright`. */
export interface LineSensorState {
  readonly name: string;
  /** Robot frame, on the real robot. */
  readonly atMm: Vec;
  readonly bright: boolean;
  /** The present value of `read_analog`, in the robot's own unit; left out if the robot knows only light and dark. */
  readonly reading?: number;
}

/** A colour sensor, as seen from outside. */
export interface ColourState {
  readonly side: 'down' | 'ahead';
  /** Its place, world frame. */
  readonly atMm: Vec;
  /** The present readings clear, red, green and blue, at gain 4 and 24 ms. */
  readonly raw: RawColour;
  /** The colour of what it sees, for eyes. */
  readonly color: Rgb;
  /** Hue in whole degrees, white-balanced. */
  readonly hue: number;
  readonly name: ColourName;
}

/** A camera, as seen from outside. */
export interface CameraState {
  /** Its lens, world frame. */
  readonly fromMm: Vec;
  readonly headingRad: number;
  /** The floor that it sees, ahead of its lens. Slopes are mm to the left per mm of depth. */
  readonly sight: CameraSight;
  /** How far the floor is in sight in even steps from the right to the left, in whole mm: a thing that hides the rest ends it. */
  readonly endsMm: readonly number[];
  readonly algorithm: HuskyAlgorithm;
  /** The last answer to the program; `null`: it has not asked within the last half second. */
  readonly seen: readonly HuskyResult[] | null;
}

/** The part of an empty floor that a camera sees: between two depths, with the slopes of its left corners there. */
export interface CameraSight {
  readonly nearMm: number;
  readonly nearSlope: number;
  readonly farMm: number;
  readonly farSlope: number;
}

/** A distance sensor's beam, world frame. */
export interface UltrasonicState {
  readonly fromMm: Vec;
  readonly headingRad: number;
  /** Full opening angle. */
  readonly openingRad: number;
  /** To the nearest thing in the beam, as the sensor gives it: never below 20 mm; `null` if nothing is in range. */
  readonly distanceMm: number | null;
  readonly hitMm: Vec | null;
}

/** The picture of a lidar: cells in rows from the top and columns from the left. */
export interface LidarState {
  /** The lens, world frame. */
  readonly fromMm: Vec;
  readonly headingRad: number;
  /** Full angle of view, across and upright alike. */
  readonly openingRad: number;
  /** Cells per row, and rows. */
  readonly size: 4 | 8;
  /** Depth along the axis in whole mm, row by row; `null`: nothing in range. */
  readonly depthMm: readonly (number | null)[];
  /** For each cell: true if it sees the floor. */
  readonly floor: readonly boolean[];
  /** For each cell: true if the program has read it within the last half second. */
  readonly asked: readonly boolean[];
}
