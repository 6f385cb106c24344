import { radOf } from '#core/angle';
import { exactCos, exactSin } from '#core/exact-math';
import { robotOutlines, placementProblems } from '#scene/placement';
import { lengthOf, overlapMm, type Outline } from '#scene/outline';
import type { RobotStart, Scene } from '#scene/scene';
import { chooseHardware, type Hardware } from './hardware';
import { NO_ROBOT, MOST_DEVICES, type DeviceSetup, type RunSetup } from './run-setup';
import { furtherStart } from './several/starts';

/** A device of a run with its hardware found, and its robot's place. */
export interface FittedDevice {
  readonly setup: DeviceSetup;
  readonly hardware: Hardware;
  /** The start of its robot; the first device's is the course's. */
  readonly start: RobotStart;
}

type Problem = { readonly problem: string };

/** Robots may overlap by this much: the numbers of a course are whole mm. */
const TOLERANCE_MM = 1;
/** Chosen: a finger fits between two robots side by side. */
const GAP_MM = 20;

/**
 * Finds the hardware of each device and the place of each robot: where its set-up says; else the first robot where the
 * course's `robot` is, the next ones at the course's starts in their order, and those for which there is none beside the
 * first.
 *
 * @returns for what cannot run, a problem that names device, place and value
 */
export function fitDevices({ scene, devices }: RunSetup): { readonly devices: readonly FittedDevice[] } | Problem {
  const naming = namesProblem(devices);
  if (naming !== null) return { problem: naming };
  const fitted: FittedDevice[] = [];
  for (const setup of devices) {
    const device = fit(setup, scene, fitted);
    if ('problem' in device)
      return devices.length === 1 ? device : { problem: `Device "${setup.name}": ${device.problem}` };
    fitted.push(device);
  }
  return { devices: fitted };
}

function namesProblem(devices: readonly DeviceSetup[]): string | null {
  if (devices.length < 1) return 'A run needs at least one device.';
  if (devices.length > MOST_DEVICES)
    return `${devices.length} devices are too many: at most ${MOST_DEVICES} share a run. Take some away.`;
  const names = devices.map(({ name }) => name);
  const twice = names.find((name, place) => names.indexOf(name) !== place);
  return twice === undefined ? null : `Two devices are named "${twice}". Give one of them another name.`;
}

function fit(setup: DeviceSetup, scene: Scene, before: readonly FittedDevice[]): FittedDevice | Problem {
  const { robot, board, firmware, robotOptions } = setup;
  const chosen = { robot, board, ...(firmware && { firmware }), ...(robotOptions && { robotOptions }) };
  const hardware = chooseHardware({ ...chosen, scene: sceneFor(setup, scene, before), imports: new Set() });
  if ('problem' in hardware) return hardware;
  if (hardware.robot === null) return { setup, hardware, start: scene.robot };
  const { outlineMm } = hardware.robot.body;
  const placed = before.filter((device) => device.hardware.robot !== null);
  const given = startInCourse(scene, setup, before);
  const start = given ?? besideStart(scene, outlineMm, placed);
  if (start === null) return { problem: NO_ROOM };
  const [misplaced] = placementProblems({ ...scene, robot: start }, outlineMm);
  if (misplaced) return { problem: misplaced.message.replace(/^robot\.at/, placeIn(scene, start)) };
  const other = placed.find((device) => isOn(robotOutlines(start, outlineMm), device));
  return other === undefined ? { setup, hardware, start } : { problem: onRobot(start, other) };
}

const NO_ROOM =
  'There is no room for its robot beside the others. Place it in the course, or take something out of the way.';

const onRobot = ({ at: [x, y] }: RobotStart, { setup }: FittedDevice): string =>
  `At [${x}, ${y}] its robot stands on the robot of "${setup.name}". Move one of them.`;

/** The course as this device sees it: with its own robot's start and type. */
function sceneFor(setup: DeviceSetup, scene: Scene, before: readonly FittedDevice[]): Scene {
  const start = startInCourse(scene, setup, before);
  return start === null || setup.robot === NO_ROBOT ? scene : { ...scene, robot: start };
}

/** The start of a device's robot by its set-up or the course; `null`: neither gives one. */
function startInCourse(scene: Scene, { start }: DeviceSetup, before: readonly FittedDevice[]): RobotStart | null {
  if (start !== undefined) return start;
  const robots = before.filter(({ hardware }) => hardware.robot !== null).length;
  return robots === 0 ? scene.robot : furtherStart(scene, robots);
}

/** The place of a start in the course's file. */
function placeIn({ objects }: Scene, { at }: RobotStart): string {
  const index = objects.findIndex((object) => object.type === 'start' && object.at === at);
  return index < 0 ? 'robot.at' : `objects[${index}].at`;
}

const isOn = (parts: readonly Outline[], { hardware, start }: FittedDevice): boolean =>
  robotOutlines(start, hardware.robot?.body.outlineMm ?? []).some((other) =>
    parts.some((part) => overlapMm(part, other) > TOLERANCE_MM),
  );

/** The nearest free place beside the first robot: left, right, behind, ahead; `null` if there is none. */
function besideStart(scene: Scene, outlineMm: readonly Outline[], placed: readonly FittedDevice[]): RobotStart | null {
  const [first] = placed;
  if (first === undefined) return scene.robot;
  const { at, heading, scale } = first.start;
  const reachOf = (parts: readonly Outline[]): number => Math.max(0, ...parts.flat().map(({ x, y }) => lengthOf(x, y)));
  const step = scale * (reachOf(outlineMm) + reachOf(first.hardware.robot?.body.outlineMm ?? [])) + GAP_MM;
  const headingRad = radOf(heading);
  const [ahead, left] = [
    { x: exactCos(headingRad), y: exactSin(headingRad) },
    { x: -exactSin(headingRad), y: exactCos(headingRad) },
  ];
  const sides = [left, { x: -left.x, y: -left.y }, { x: -ahead.x, y: -ahead.y }, ahead];
  for (let far = 1; far <= MOST_DEVICES; far++)
    for (const { x, y } of sides) {
      const place = [Math.round(at[0] + far * step * x), Math.round(at[1] + far * step * y)] as const;
      const start: RobotStart = { type: null, at: place, heading, scale, options: {} };
      const isFree = placementProblems({ ...scene, robot: start }, outlineMm).length === 0;
      if (isFree && !placed.some((device) => isOn(robotOutlines(start, outlineMm), device))) return start;
    }
  return null;
}
