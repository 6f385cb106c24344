/**
 * The course as a document: immutable plain data in the shape of its file, with every default filled in.
 *
 * Frame: whole millimetres, origin in the arena's lower left corner, x right, y up; angles in degrees,
 * counter-clockwise from +x. The robot's `at` is the middle of its axle.
 */

/** A place or an extent `[x, y]` in whole mm. */
export type Point = readonly [x: number, y: number];

/** A straight solid wall; `from` and `to` are the ends of its centre line. */
export interface Wall {
  readonly type: 'wall';
  readonly id: string;
  readonly from: Point;
  readonly to: Point;
  /** Full thickness in mm. */
  readonly thickness: number;
}

/** A box on the floor: a `block` can be pushed, a `fixed-block` cannot. */
export interface Block {
  readonly type: 'block' | 'fixed-block';
  readonly id: string;
  /** Its centre. */
  readonly at: Point;
  /** Extent along its own x and y, in mm. */
  readonly size: Point;
  /** Rotation in eighths of a full turn, 0 … 7, counter-clockwise. */
  readonly turn: number;
}

/** A painted line on the floor: a polyline with round ends and joints. */
export interface Stroke {
  readonly type: 'stroke';
  readonly id: string;
  readonly points: readonly Point[];
  /** Full width in mm. */
  readonly width: number;
  readonly color: StrokeColor;
}

/** The colours a stroke may have; each is a CSS colour name as well. */
export const strokeColors = ['black', 'gray', 'white'] as const;
export type StrokeColor = (typeof strokeColors)[number];

/** Everything that can stand or lie in the arena. */
export type SceneObject = Wall | Block | Stroke;

/** Where the robot starts, and which one it is. */
export interface RobotStart {
  /** Id of a robot type, or `null`: chosen by what the program imports. */
  readonly type: string | null;
  readonly at: Point;
  /** Degrees counter-clockwise from +x. */
  readonly heading: number;
  /** Size of the robot relative to the real one. */
  readonly scale: number;
  /** What is chosen about the robot: id of an option → id of a choice. What is left out is as usual. */
  readonly options: Readonly<Record<string, string>>;
}

/** A course. */
export interface Scene {
  readonly name: string;
  readonly description: string;
  /** Width and height of the arena in mm. */
  readonly size: Point;
  /** Id of a board type, or `null`: chosen by what the program imports. */
  readonly board: string | null;
  readonly robot: RobotStart;
  readonly objects: readonly SceneObject[];
}

/** What a course file calls itself. */
export const SCENE_FORMAT = 'parcours-scene';

/** The version this app writes, and the newest it reads. */
export const SCENE_VERSION = 1;

/** What is taken for properties that a file leaves out. */
export const sceneDefaults = {
  size: [1200, 900] as Point, // chosen: a table top
  thickness: 10,
  turn: 0,
  width: 20, // chosen: what school courses are taped with (15 to 20 mm)
  color: 'black' as StrokeColor,
  scale: 1,
  heading: 0,
} as const;

/** What a course may hold at most. Chosen: far beyond any lesson, small enough for a school tablet. */
export const sceneLimits = {
  textCharacters: 4_000_000,
  nameCharacters: 200,
  descriptionCharacters: 5_000,
  idCharacters: 100,
  objects: 2_000,
  points: 60_000,
  sizeMm: { min: 200, max: 10_000 },
  /** Coordinates; objects may lie partly outside the arena. */
  placeMm: { min: -20_000, max: 20_000 },
  thicknessMm: { min: 2, max: 500 },
  blockMm: { min: 5, max: 5_000 },
  widthMm: { min: 1, max: 500 },
  scale: { min: 0.5, max: 3 },
  headingDeg: { min: -360, max: 360 },
  options: 50,
} as const;

/** The empty course: an arena of 1200 × 900 mm, the robot in its centre heading along +x. */
export function defaultScene(): Scene {
  return {
    name: '',
    description: '',
    size: sceneDefaults.size,
    board: null,
    robot: centreStart(sceneDefaults.size),
    objects: [],
  };
}

/** The start of a robot that a file does not place: the centre of the arena, heading along +x. */
export function centreStart(size: Point): RobotStart {
  return {
    type: null,
    at: [Math.round(size[0] / 2), Math.round(size[1] / 2)],
    heading: sceneDefaults.heading,
    scale: sceneDefaults.scale,
    options: {},
  };
}
