import { filesOfDevice, furtherDevice } from '#project/devices';
import { filesByName, type Project } from '#project/project';
import { modulesImportedBy } from '#python/imports';
import type { RobotStart } from '#scene/scene';
import { furtherRobot, sceneOfFurther } from '#simulation/hardware';
import { furtherStart, startsIn } from '#simulation/several/starts';

import type { WorkParts } from '../model/parts';
import type { Settings } from '../settings/settings';
import { hardwareOf } from './hardware';

type Devices = Pick<WorkParts, 'work' | 'settings'>;

/** A device by itself: its files and its hardware, as if the project had no other. */
export interface DeviceAt {
  readonly project: Project;
  readonly settings: Settings;
}

/** The device at this place; left out: the one that is shown. The course's board and robot are the first one's. */
export function deviceAt({ work, settings }: Devices, place = work.place.value): DeviceAt {
  const { project } = work.work.value;
  const device = furtherDevice(project, place);
  if (device === null) return { project, settings: settings.current.value };
  const { firmware, robotOptions } = device;
  const files = filesOfDevice(project, place);
  const imports = modulesImportedBy(filesByName(files));
  const { scene } = project;
  const start = startOf({ work, settings }, place);
  const robot = furtherRobot({ robot: device.robot, imports, start });
  return {
    project: { ...project, files, scene: sceneOfFurther({ scene, start }) },
    settings: { ...settings.current.value, device: device.device, firmware, robot, robotOptions, myRobot: null },
  };
}

/** The start of a device's robot in the course after the first start; `null`: there is none. */
function startOf(parts: Devices, place: number): RobotStart | null {
  const { scene } = parts.work.work.value.project;
  if (startsIn(scene.objects).length === 0) return null;
  const before = Array.from({ length: place }, (_, earlier) => deviceAt(parts, earlier));
  const robots = before.filter(({ project, settings }) => (hardwareOf(project, settings)?.robot ?? null) !== null);
  return robots.length === 0 ? null : furtherStart(scene, robots.length);
}
