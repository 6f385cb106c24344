import { boardOf } from '#board/boards/board-of-device';
import { traitsFor } from '#my-robot/traits-for';
import { deviceNames } from '#project/devices';
import { defaultProjectSettings, type Project, type ProjectSettings } from '#project/project';
import { modulesImportedBy } from '#python/imports';
import type { Scene } from '#scene/scene';
import { feelingInputs } from '#simulation/feeling';
import { chooseFurtherHardware, chooseHardware, hardwareIds } from '#simulation/hardware';
import type { InputEvent } from '#simulation/input';
import type { DeviceSetup, RunSetup } from '#simulation/run-setup';
import { furtherStart } from '#simulation/several/starts';
import type { Files } from '../program/facts';
import type { ClassTask, WorldVariant } from '../task/task';
import { courseOfWorld } from '../task/world-course';
import { programsOf } from './programs';

type Problem = { readonly problem: string };

/**
 * The run of a hand-in in a world: course, hardware and chance are the task's, only the programs are the pupil's. A
 * device that the pupil lacks runs the task's program for it.
 *
 * @returns the run, or the reason why there is none, in an English sentence
 */
export function setupOf(task: ClassTask, handedIn: Project, world: WorldVariant): RunSetup | Problem {
  const course = courseOfWorld(task.project.scene, world);
  if ('problem' in course) return course;
  const { scene } = course;
  const settings = task.project.settings ?? defaultProjectSettings;
  const [files, ...others] = programsOf(task.project, handedIn);
  const first = firstDevice(task.project, settings, files, scene);
  if ('problem' in first) return first;
  const further = furtherDevices(task.project, others, scene, first.robot !== 'none');
  if ('problem' in further) return further;
  const devices = [first, ...further.devices] as const;
  const reality = world.reality ?? settings.reality;
  const sensors = Object.entries(world.sensors).map(([id, value]): InputEvent => {
    return { timeUs: 0, action: { type: 'sensor', id, value } };
  });
  return {
    scene,
    devices,
    inputs: [...(settings.arenaSenses ? feelingInputs(devices) : []), ...sensors, ...world.inputs],
    reality,
    // As the page and the command line have it: an ideal robot has no number.
    seed: world.seed ?? (reality > 0 ? settings.seed : 1),
  };
}

function firstDevice(task: Project, settings: ProjectSettings, files: Files, scene: Scene): DeviceSetup | Problem {
  const { robot, device, firmware, robotOptions } = settings;
  const imports = modulesImportedBy(files);
  const wish = { scene, imports, robot, board: boardOf(device), firmware };
  const found = chooseHardware(wish);
  if ('problem' in found) return found;
  const ids = hardwareIds(found);
  const traits = traitsFor(settings.myRobot, ids.robot);
  return {
    name: deviceNames(task)[0] ?? '1',
    files,
    ...ids,
    robotOptions: robotOptions[ids.robot] ?? {},
    ...(traits !== undefined && { traits }),
  };
}

function furtherDevices(
  task: Project,
  programs: readonly Files[],
  scene: Scene,
  hasFirstRobot: boolean,
): { readonly devices: readonly DeviceSetup[] } | Problem {
  const made: DeviceSetup[] = [];
  let robots = hasFirstRobot ? 1 : 0;
  for (const [index, device] of (task.devices?.others ?? []).entries()) {
    const { name, robot, firmware, robotOptions } = device;
    const files = programs[index] ?? {};
    const start = robots === 0 ? null : furtherStart(scene, robots);
    const wish = { scene, start, robot, board: boardOf(device.device), firmware, robotOptions };
    const hardware = chooseFurtherHardware({ ...wish, imports: modulesImportedBy(files) });
    if ('problem' in hardware) return { problem: `device "${name}": ${hardware.problem}` };
    if (hardware.robot !== null) robots += 1;
    made.push({ name, files, ...hardwareIds(hardware), robotOptions: hardware.options });
  }
  return { devices: made };
}
