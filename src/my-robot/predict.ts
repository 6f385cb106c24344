/** Drives a simulated robot through the programs of the measurement, and looks where it ends. */
import { degOf } from '#core/angle';
import { exactCos, exactSin } from '#core/exact-math';
import type { Pose } from '#core/geometry';
import type { RobotType } from '#robots/robot';
import type { Traits } from '#robots/traits';
import { defaultScene, type Scene } from '#scene/scene';
import type { InputEvent } from '#simulation/input';
import { soloRun } from '#simulation/run-setup';
import { Simulation } from '#simulation/simulation';
import { DRIVES, type Drive, type DriveName } from './my-robot';
import { DRIVE_MS, FINGER_MS, programOf, TURN_MS, type Step } from './programs';

/** The effect of the motors: where the robot's nose is after each drive, and how far it has turned. */
export interface Motion {
  readonly drives: Readonly<Record<DriveName, Drive>>;
  readonly turnDeg: number;
}

/** The robot that is driven: as measured here, or as the one on the page or of a test. */
export interface Driving {
  readonly type: RobotType;
  readonly firmware: WebAssembly.Module;
  readonly traits?: Traits;
  /** For tests: a used robot instead of traits. */
  readonly reality?: number;
  readonly seed?: number;
}

/** From the program's start to the first press, in ms: by then it waits for one. */
const READY_MS = 200;
/** Duration of a button press, and the time until the robot has stopped, in ms. */
const PRESS_MS = 50;
const STILL_MS = 700;
/** Side of the arena, in mm: no robot reaches its edge. */
const ARENA_MM = 6000;

/** Start and end of each drive, in ms from the program's start. */
function spans(lengths: readonly number[]): readonly { readonly fromMs: number; readonly toMs: number }[] {
  let now = READY_MS;
  return lengths.map((ms) => {
    const fromMs = now;
    now += FINGER_MS + ms + STILL_MS;
    return { fromMs, toMs: now };
  });
}

/** Runs the two programs of the motors. */
export async function predictMotion(driving: Driving): Promise<Motion> {
  const ways = await posesOf(
    'straight',
    DRIVES.map((name) => DRIVE_MS[name]),
    driving,
  );
  const nose = Math.max(...driving.type.body.outlineMm.flat().map(({ x }) => x));
  const drives = DRIVES.map((name, index): [DriveName, Drive] => [name, driveOf(ways[index] ?? [], nose)]);
  const [turn = []] = await posesOf('turn', [TURN_MS], driving);
  const [before, after] = [turn[0], turn.at(-1)];
  const turnDeg = before && after ? degOf(after.headingRad - before.headingRad) : 0;
  return { drives: Object.fromEntries(drives) as Record<DriveName, Drive>, turnDeg };
}

/** The poses of the robot before and after each drive of a program. */
async function posesOf(
  step: Step,
  lengths: readonly number[],
  driving: Driving,
): Promise<readonly (readonly Pose[])[]> {
  const times = spans(lengths);
  const simulation = await Simulation.create(
    setupOf(
      step,
      times.map(({ fromMs }) => fromMs),
      driving,
    ),
    driving.firmware,
  );
  const poseAt = (ms: number): Pose => {
    simulation.advanceTo(ms * 1000);
    const robot = simulation.snapshot().robot;
    if (robot === null || simulation.ended !== null)
      throw new Error(`The program ${step} has ended: ${simulation.ended?.exception?.message ?? ''}`);
    return robot.pose;
  };
  const poses = times.map(({ fromMs, toMs }) => [poseAt(fromMs), poseAt(toMs)]);
  simulation.dispose();
  return poses;
}

function setupOf(step: Step, pressesMs: readonly number[], { type, traits, reality = 0, seed = 1 }: Driving) {
  const press = (ms: number, down: boolean): InputEvent => ({
    timeUs: ms * 1000,
    action: { type: 'button', button: 'a', down },
  });
  const bare = defaultScene();
  const scene: Scene = {
    ...bare,
    size: [ARENA_MM, ARENA_MM],
    robot: { ...bare.robot, type: type.id, at: [ARENA_MM / 2, ARENA_MM / 2] },
  };
  return soloRun({
    scene,
    files: { 'main.py': programOf(step, type).en },
    robot: type.id,
    board: type.board,
    seed,
    reality,
    ...(traits === undefined ? {} : { traits }),
    inputs: pressesMs.flatMap((ms) => [press(ms, true), press(ms + PRESS_MS, false)]),
  });
}

/** Position of the nose after a drive, relative to the robot's pose before. */
function driveOf(way: readonly Pose[], noseMm: number): Drive {
  const [before, after] = [way[0], way.at(-1)];
  if (before === undefined || after === undefined) return { aheadMm: 0, leftMm: 0 };
  const [from, to] = [noseOf(before, noseMm), noseOf(after, noseMm)];
  const [cos, sin] = [exactCos(before.headingRad), exactSin(before.headingRad)];
  const [dx, dy] = [to.xMm - from.xMm, to.yMm - from.yMm];
  return { aheadMm: dx * cos + dy * sin, leftMm: dy * cos - dx * sin };
}

const noseOf = ({ xMm, yMm, headingRad }: Pose, noseMm: number) => ({
  xMm: xMm + noseMm * exactCos(headingRad),
  yMm: yMm + noseMm * exactSin(headingRad),
});
