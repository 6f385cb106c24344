import { feelingInputs } from '#simulation/feeling';
import { AUTO, chooseHardware, hardwareIds, sceneOfFurther } from '#simulation/hardware';
import type { DeviceSetup, RunSetup } from '#simulation/run-setup';
import { furtherStart } from '#simulation/several/starts';
import type { RobotStart, Scene } from '#scene/scene';
import type { RunEnd } from '../run-end';

/** The files of a program's board. */
export type Files = Readonly<Record<string, string>>;

/**
 * A match is over when the task is decided, or when nothing more can happen; at the latest after ten minutes, longer than any
 * task.
 */
export const MATCH_END: RunEnd = { untilUs: 600_000_000, untilProgramEnds: false, untilVerdict: true };

/** True if the programs do not meet in a course: its task is for one robot, or there is one start only. */
export const isForOne = (scene: Scene): boolean => scene.task.robots === undefined || furtherStart(scene, 1) === null;

/** The run of a match. Each program gets the robot of its start, whatever it imports. */
export function matchSetup(
  scene: Scene,
  a: Files,
  b: Files | null,
  seed: number,
): RunSetup | { readonly problem: string } {
  const first = deviceOf('a', a, scene);
  if ('problem' in first) return first;
  const start = furtherStart(scene, 1);
  const second = b === null || start === null ? null : deviceOf('b', b, sceneAt(scene, start, first.robot));
  if (second !== null && 'problem' in second) return second;
  const devices = second === null ? ([first] as const) : ([first, second] as const);
  return { scene, devices, inputs: feelingInputs(devices), seed, reality: 0 };
}

/** The course as the second program sees it; at a start for any robot stands one like the first. */
const sceneAt = (scene: Scene, start: RobotStart, robot: string): Scene =>
  sceneOfFurther({ scene, start: { ...start, type: start.type ?? robot } });

function deviceOf(name: string, files: Files, scene: Scene): DeviceSetup | { readonly problem: string } {
  const hardware = chooseHardware({ scene, imports: new Set(), robot: AUTO, board: AUTO });
  return 'problem' in hardware ? hardware : { name, files, ...hardwareIds(hardware), robotOptions: hardware.options };
}
