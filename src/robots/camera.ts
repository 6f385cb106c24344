/** The AI camera that any robot may carry at its front edge: ahead, or tilted down to the line. */
import { radOf } from '#core/angle';
import { exactCos, exactSin, exactTan } from '#core/exact-math';
import type { Vec } from '#core/geometry';
import { attachHuskyLens, HUSKYLENS_ADDRESS, HUSKYLENS_PICTURE, type HuskyLook } from '#devices/huskylens';
import type { OptionValues } from '#core/option';
import type { CameraView } from '#world/probes/camera';
import { colourBlocks, lineArrow, tagBlocks } from './camera-sight';
import type { CameraChoice } from './camera-options';
import { frontOf } from './colour-sensor';
import type { CameraSight, CameraState, Robot, RobotContext, RobotType } from './robot';
import { scaled } from './sonar';

/** Its field of view across; upright it follows from the picture, 35°. Not published: docs/hardware/huskylens.md. */
const ACROSS_DEG = 46;
/** Its height, which is not scaled with the robot, and its tilts: chosen. */
const HEIGHT_MM = 90;
const TILT_DEG: Readonly<Record<Exclude<CameraChoice, 'none'>, number>> = { huskylens: 15, 'huskylens-down': 45 };
const RANGE_MM = 3000;
/** A cell of its picture is 5 × 5 px: chosen, a picture takes a few milliseconds. */
const CELL_PX = 5;
/** For how long the last results are shown: chosen, as those of a lidar. */
const SHOWN_US = 500_000;
/** How far its view on the floor is shown where it reaches to the horizon. */
const SHOWN_MM = 700;

const acrossTan = exactTan(radOf(ACROSS_DEG / 2));

const viewOf = (tiltDeg: number): CameraView => ({
  ...{ heightMm: HEIGHT_MM, tiltRad: radOf(tiltDeg), rangeMm: RANGE_MM, acrossTan },
  uprightTan: (acrossTan * HUSKYLENS_PICTURE.height) / HUSKYLENS_PICTURE.width,
  columns: HUSKYLENS_PICTURE.width / CELL_PX,
  rows: HUSKYLENS_PICTURE.height / CELL_PX,
});

/** Every second row: enough to follow a line. */
const LINE_ROWS = Array.from({ length: HUSKYLENS_PICTURE.height / CELL_PX / 2 }, (_, row) => 2 * row + 1);

/** The middles of these rows in the picture, in px. */
const LINE_HEIGHTS = LINE_ROWS.map((row) => (row + 0.5) * CELL_PX);

/** A robot with the camera that its options say; without one, it is the same robot. */
export function withCamera(robot: Robot, type: RobotType, context: RobotContext): Robot {
  const { board, chassis, clock, options, scale } = context;
  const choice = options['camera'];
  if (choice !== 'huskylens' && choice !== 'huskylens-down') return robot;
  // One address is for one device: the lidar was there first, and the camera's plug stays out.
  if (isTakenByLidar(options)) return robot;
  const atMm = scaled(frontOf(type), scale);
  const view = viewOf(TILT_DEG[choice]);
  const look = looksOf(context, atMm, view);
  const trembling: HuskyLook = (algorithm) => context.seen(look(algorithm));
  const lens = attachHuskyLens(clock, board.i2c, trembling, choice === 'huskylens' ? 'tag' : 'line');
  const sight = sightOf(view);
  const slopes = slopesOf(sight);
  const camera = (): CameraState => ({
    fromMm: chassis.toWorld(atMm),
    headingRad: chassis.pose().headingRad,
    sight,
    endsMm: context.camera(atMm, view).floorEnds(slopes, sight.farMm).map(Math.round), // prettier-ignore
    algorithm: lens.algorithm(),
    seen: lens.seenWithin(SHOWN_US),
  });
  return {
    ...robot,
    state: () => ({ ...robot.state(), camera: camera() }),
    detach: () => {
      robot.detach();
      lens.stop();
    },
  };
}

/** True if a lidar of the robot has the camera's address on the bus. */
const isTakenByLidar = ({ lidar, lidarAddress }: OptionValues): boolean =>
  (lidar === '8x8' || lidar === '4x4') && Number(lidarAddress) === HUSKYLENS_ADDRESS;

/** The sight of its algorithms from there. */
const looksOf =
  ({ camera, colourNumber }: RobotContext, atMm: Vec, view: CameraView): HuskyLook =>
  (algorithm) => {
    if (algorithm === 'tag') return tagBlocks(camera(atMm, view).tags());
    if (algorithm === 'colour') {
      const numberOf = once(colourNumber);
      return colourBlocks(camera(atMm, view).picture(), ({ shares }) => (shares === null ? 0 : numberOf(shares)));
    }
    const arrow = algorithm === 'line' ? lineArrow(camera(atMm, view).picture(LINE_ROWS), LINE_HEIGHTS) : null;
    return arrow === null ? [] : [arrow];
  };

/** Asks anew only for another value than the last one: neighbouring cells mostly see the same thing. */
function once<T>(ask: (of: T) => number): (of: T) => number {
  let last: { readonly of: T; readonly number: number } | null = null;
  return (of) => {
    if (last?.of !== of) last = { of, number: ask(of) };
    return last.number;
  };
}

/** The part of the floor that it sees, from the lens. */
function sightOf({ heightMm, tiltRad, acrossTan, uprightTan }: CameraView): CameraSight {
  const [cos, sin] = [exactCos(tiltRad), exactSin(tiltRad)];
  const edge = (v: number): { readonly mm: number; readonly slope: number } => {
    const forward = cos + v * sin;
    const rise = (v * cos - sin) / forward;
    return { mm: Math.min(rise < 0 ? heightMm / -rise : Infinity, SHOWN_MM), slope: acrossTan / forward };
  };
  const [near, far] = [edge(-uprightTan), edge(uprightTan)];
  return { nearMm: near.mm, nearSlope: near.slope, farMm: far.mm, farSlope: far.slope };
}

/** How many parts of its view on the floor are shown: chosen, each is 18 mm wide at the end. */
const SHOWN_PARTS = 32;

/** The slopes at which its view on the floor may end, from the right to the left. */
const slopesOf = ({ farSlope }: CameraSight): readonly number[] =>
  Array.from({ length: SHOWN_PARTS + 1 }, (_, part) => farSlope * ((2 * part) / SHOWN_PARTS - 1));
