/**
 * The course as a document: immutable plain data in the shape of its file, with every default filled in.
 *
 * Frame: whole millimetres, origin in the arena's lower left corner, x right, y up; angles in degrees,
 * counter-clockwise from +x. The robot's `at` is the middle of its axle.
 */

import type { League } from './league/league';
import type { Common, Point, Shaped, Standing } from './kinds/base';
import type { Painted, PaintColor } from './paint/paint';
import type { Barrier, Lamp, Tunnel } from './kinds/lit-things';
import type { Tag } from './kinds/tag-thing';

export type { Point, Shaped } from './kinds/base';
export { lampColors, type Barrier, type Lamp, type LampColor, type Tunnel } from './kinds/lit-things';
export type { Tag } from './kinds/tag-thing';

/** A straight solid wall; `from` and `to` are the ends of its centre line. */
export interface Wall extends Common, Standing, Painted {
  readonly type: 'wall';
  readonly from: Point;
  readonly to: Point;
  /** Full thickness in mm. */
  readonly thickness: number;
}

/** A body on the floor: a `block` can be pushed, a `fixed-block` cannot. Of one that is not round, `round` is left out. */
export interface Block extends Common, Shaped, Standing, Painted {
  readonly type: 'block' | 'fixed-block';
  /** Mass in g of a block that can be pushed; left out: by its area, like beech of 25 mm. */
  readonly mass?: number;
  /** Ratio of the floor's friction to the weight of a block that can be pushed; left out: 0.3, of a ball 0.02. */
  readonly friction?: number;
  /** It is a ball, or a can that lies: it rolls on when it was pushed. Only of round ones. */
  readonly rolls?: true;
}

/** A painted line on the floor: a polyline with round ends and joints. */
export interface Stroke extends Common {
  readonly type: 'stroke';
  readonly points: readonly Point[];
  /** Full width in mm. */
  readonly width: number;
  readonly color: PaintColor;
  /** As of all paint; left out: as usual for strokes of its colour (`reflectance.ts`). */
  readonly infrared?: number;
}

/**
 * A marked field on the floor. It is seen by people and counted by the verdict (`#simulation/task/verdict`); no body feels
 * it, and sensors see it only if it is painted.
 *
 * - `target`: where the robot shall come to, or where `blocks` movable blocks shall lie;
 * - `checkpoint`: to be passed in the order of `number`;
 * - `forbidden`: not to be touched.
 */
export interface Zone extends Common, Shaped, Painted {
  readonly type: 'target' | 'checkpoint' | 'forbidden';
  readonly round: boolean;
  /** Place of a checkpoint in the order, 1 … 99; 0 for other zones. */
  readonly number: number;
  /** How many movable blocks a target wants; 0: the robot itself. 0 for other zones. */
  readonly blocks: number;
  /** The colour of the blocks that a target with `blocks` wants; left out: any. */
  readonly blockColor?: PaintColor;
}

/** A coloured sheet on the floor: seen by people and sensors, without a meaning for the verdict. */
export interface Paper extends Common, Shaped, Painted {
  readonly type: 'paper';
  readonly color: PaintColor;
}

/** A solid thing with spikes that stands still: a robot that touches it has failed. */
export interface Spikes extends Common, Shaped, Standing {
  readonly type: 'spikes';
}

/**
 * A solid body that moves by itself: along a way from stop to stop, whatever is in its path, or after robots as far as
 * solid things let it (`chases`). The simplest goes to and fro between `at`, where its way begins, and `to`.
 */
export interface Mover extends Common, Omit<Shaped, 'corners'>, Standing {
  readonly type: 'mover';
  /** Its centre at the second stop. The same as `at`, and no `stops`: it has no way. */
  readonly to: Point;
  /** In mm/s. */
  readonly speed: number;
  /** Touching it fails the task. */
  readonly spiked: boolean;
  /** Further stops in their order; left out: none. */
  readonly stops?: readonly Point[];
  /** Seconds that it waits at `at`, at `to` and at each further stop; left out, and where the list ends: 0. */
  readonly waits?: readonly number[];
  /** From the last stop straight to the first; left out: back the way that it came. */
  readonly loops?: true;
  /** It starts where it would be after so many seconds; left out: 0. */
  readonly phase?: number;
  /** Degrees per second that it turns about its centre, counter-clockwise positive; left out: 0. */
  readonly spin?: number;
  /** The robots it runs after; left out: none. With it there is no way: only `at` counts. */
  readonly chases?: Chase;
}

/** The robots after which a mover runs; of several, after the nearest. */
export interface Chase {
  /**
   * Id of the zone that it guards: it runs after robots that touch it, and back to its place when none does any more.
   * Left out: after robots wherever they are.
   */
  readonly zone?: string;
  /** Robots farther away than this do not matter, in mm; left out: it notices them at any distance. */
  readonly reach?: number;
}

/** Words on the floor, for people: no sensor sees them. */
export interface Label extends Common {
  readonly type: 'label';
  /** Middle of the text. */
  readonly at: Point;
  /** A single line, not empty. */
  readonly text: string;
  /** Height of its capitals in mm. */
  readonly height: number;
  /** Rotation in degrees counter-clockwise, 0 up to but without 360. */
  readonly angle: number;
}

/**
 * The start of a further device's robot: the first start belongs to the second device with a robot, and so on. The
 * first one's is the course's `robot`. It lies flat on the floor, and nothing feels it.
 */
export interface Start extends Common {
  readonly type: 'start';
  /** The middle of the robot's axle. */
  readonly at: Point;
  /** Degrees counter-clockwise from +x. */
  readonly heading: number;
  /** Id of the robot type that belongs here, or `null`: whatever robot its device has. */
  readonly robot: string | null;
  /** Chosen options of that robot, as those of `RobotStart`. */
  readonly options: Readonly<Record<string, string>>;
  /** Name of its robot; empty: that of its device. */
  readonly name: string;
  /** Colour of the robot's ring, name and trail; `null`: by the place of its device. */
  readonly color: RobotColor | null;
}

/** The colours that tell robots apart, in the order in which devices have them. */
export const robotColors = ['blue', 'purple', 'teal', 'brown', 'violet', 'green', 'pink', 'gray'] as const;
export type RobotColor = (typeof robotColors)[number];

/** Everything that can stand or lie in the arena. */
export type SceneObject =
  Wall | Block | Stroke | Zone | Paper | Spikes | Mover | Lamp | Barrier | Tunnel | Tag | Label | Start;

/** How many points an object holds: a stroke may have tens of thousands, a polygon has some. */
export function countPoints(object: SceneObject): number {
  if ('points' in object) return object.points.length;
  return 'corners' in object ? object.corners.length : 0;
}

/** The task of a course besides its zones. */
export interface Task {
  /** Seconds of simulated time until the task must be done; `null`: no limit. */
  readonly seconds: number | null;
  /** Walls, blocks and the arena's edge must not be touched; spikes never may. */
  readonly noTouch: boolean;
  /** The help with which it still counts as passed; left out: none. */
  readonly allows?: readonly Help[];
  /** How several robots share it; left out: only the first robot counts. */
  readonly robots?: TaskRule;
  /** Passed within so many seconds of simulated time: two stars, three stars. Left out: there are no stars. */
  readonly stars?: readonly [two: number, three: number];
  /** Additions of the task's card to the course's `description`; left out: none. */
  readonly card?: TaskCard;
}

/**
 * How several robots share a task. `all`: each must come to all places. `first`: who has been everywhere first wins.
 * `ring`: who leaves the targets is out, the last one inside wins. `catch`: the first robot touches all others in time.
 * `together`: what one reaches counts for all.
 */
export const taskRules = ['all', 'first', 'ring', 'catch', 'together'] as const;
export type TaskRule = (typeof taskRules)[number];

/** Title, hints and picture of a task, and its words in further languages. The text is the course's `description`. */
export interface TaskCard {
  /** Language of title, description and hints, as its two letters; empty: not said. */
  readonly language: string;
  /** Empty: the name of the course. */
  readonly title: string;
  /** Shown one after the other, on demand. */
  readonly hints: readonly string[];
  /** The same in other languages. */
  readonly translations: readonly TaskText[];
  /** A `data:image/…` address (PNG, JPEG or WebP), or empty. */
  readonly picture: string;
  /** True if pupils may see the solution of the ready course from which the task was made. */
  readonly solution: boolean;
}

/** A task in words, in one language. */
export interface TaskText {
  readonly language: string;
  readonly title: string;
  /** Paragraphs, lists, bold and code: see `FORMAT.md`. */
  readonly text: string;
  readonly hints: readonly string[];
}

/** Help during a run: the hand moves the robot or a block, or the course is edited. */
export const helps = ['hand', 'edits'] as const;
export type Help = (typeof helps)[number];

/**
 * A picture that covers a part of the floor. What the sensors read of it is the grid of `levels`, made once when the
 * picture is taken in, so that it is the same in every browser; `picture` is only for the eye.
 */
export interface Background {
  /** Lower left corner. */
  readonly at: Point;
  /** Extent in mm. */
  readonly size: Point;
  /** Columns and rows of the grid. */
  readonly cells: Point;
  /** Base64 of the deflated grid: a byte per cell, row by row from the upper left; 0 black … 15 bare floor. */
  readonly levels: string;
  /** A `data:image/…` address (PNG, JPEG or WebP), or empty: the grid itself is shown. */
  readonly picture: string;
}

/** The robot's start, and its type. */
export interface RobotStart {
  /** Id of a robot type, or `null`: chosen by what the program imports. */
  readonly type: string | null;
  readonly at: Point;
  /** Degrees counter-clockwise from +x. */
  readonly heading: number;
  /** Size of the robot relative to the real one. */
  readonly scale: number;
  /** Chosen options of the robot: id of an option → id of a choice. Missing options have their defaults. */
  readonly options: Readonly<Record<string, string>>;
  /** Its name where there are several; left out: that of its device. A course never holds an empty one. */
  readonly name?: string;
  /** Its colour where there are several; left out: that of the first device. A course never holds `null`. */
  readonly color?: RobotColor | null;
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
  readonly task: Task;
  readonly background: Background | null;
  /** A line of tiles that is scored by the rules of a league; left out: it is none. */
  readonly league?: League;
  /** Light of the room in lx; left out: an ordinary room's, 300. */
  readonly ambient?: number;
  readonly objects: readonly SceneObject[];
}

/** The name of the format in a course file. */
export const SCENE_FORMAT = 'parcours-scene';

/** The newest version that this app reads and writes. What an older one can say is written in that: `serialize.ts`. */
export const SCENE_VERSION = 8;

/** Defaults of properties that a file leaves out. */
export const sceneDefaults = {
  size: [1200, 900] as Point, // chosen: a table top
  thickness: 10,
  angle: 0,
  width: 20, // chosen: what school courses are taped with (15 to 20 mm)
  color: 'black' as PaintColor,
  paper: 'white' as PaintColor,
  scale: 1,
  heading: 0,
  task: { seconds: null, noTouch: false } as Task,
  round: false,
  blocks: 0,
  speed: 100, // chosen: half as fast as the robots drive
  spiked: false,
  card: { language: '', title: '', hints: [], translations: [], picture: '', solution: false } as TaskCard,
  lampHeight: 260, // chosen: 200 mm above the sensors, which then get 1000 lx right below it
  friction: 0.3, // as the physics has it: wood on wood or plastic
  rollingFriction: 0.02, // likewise: a ball on hard felt or lino
  brightness: 40, // chosen: an LED torch (docs/hardware/light.md)
  ambient: 300,
  tagSide: 60, // chosen: a camera recognises it from a metre away
  labelHeight: 30, // chosen: read on a projector from the last row
} as const;

/** Limits of a course. Chosen: far beyond any lesson, small enough for a school tablet. */
export const sceneLimits = {
  /** More than the longest file that a course within the other limits can become. */
  textCharacters: 8_000_000,
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
  /** Tops of what stands on the floor: from what every sensor looks over to more than any sees. */
  heightMm: { min: 5, max: 1_000 },
  angleDeg: { min: 0, max: 360 },
  corners: { min: 3, max: 60 },
  /** Smallest area of a polygon: that of the smallest block. */
  leastAreaMm2: 25,
  widthMm: { min: 1, max: 500 },
  /** From nothing to glossy metal, which returns more than white paper. */
  infrared: { min: 0, max: 1.4 },
  /** A block's, from a table tennis ball to what no robot moves. */
  massG: { min: 1, max: 5_000 },
  friction: { min: 0, max: 1.5 },
  /** A lamp's, above the sensors, which are 60 mm above the floor. */
  lampMm: { min: 80, max: 3_000 },
  brightnessCd: { min: 0.1, max: 1_000 },
  /** From the dark to the sun. */
  ambientLx: { min: 0, max: 100_000 },
  /** A tag's number and the side of its square. */
  tag: { min: 1, max: 99 },
  tagMm: { min: 10, max: 300 },
  scale: { min: 0.5, max: 3 },
  headingDeg: { min: -360, max: 360 },
  options: 50,
  seconds: { min: 1, max: 3600 },
  titleCharacters: 200,
  hints: 5,
  hintCharacters: 1_000,
  translations: 10,
  languageCharacters: 20,
  /** For the picture of a task: about 300 kB. */
  taskPictureCharacters: 400_000,
  checkpoint: { min: 1, max: 99 },
  blocks: { min: 0, max: 50 },
  speedMmS: { min: 5, max: 500 },
  /** Stops of a mover, the first two included. */
  stops: 20,
  waitSeconds: { min: 0, max: 60 },
  phaseSeconds: { min: 0, max: 3600 },
  /** In either direction. */
  spinDegS: { min: -360, max: 360 },
  reachMm: { min: 10, max: 20_000 },
  labelCharacters: 100,
  labelMm: { min: 5, max: 500 },
  startNameCharacters: 40,
  backgroundMm: { min: 10, max: 20_000 },
  /** Cells of a background's grid; 1000 × 1000 are 2 m at 2 mm. */
  cells: 1_000_000,
  /** For a background's picture, and for its levels. */
  pictureCharacters: 1_500_000,
} as const;

/** The empty course: an arena of 1200 × 900 mm, the robot in its centre heading along +x. */
export function defaultScene(): Scene {
  return {
    name: '',
    description: '',
    size: sceneDefaults.size,
    board: null,
    robot: centreStart(sceneDefaults.size),
    task: sceneDefaults.task,
    background: null,
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
