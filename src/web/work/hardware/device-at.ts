import { filesOfDevice, furtherDevice } from '#project/devices';
import { filesByName, type Project } from '#project/project';
import { modulesImportedBy } from '#python/imports';
import { AUTO, NO_ROBOT, robotMeant } from '#simulation/hardware';

import type { WorkParts } from '../model/parts';
import type { Settings } from '../settings/settings';

/** A device by itself: its files and what it is to run on, as if the project had no other. */
export interface DeviceAt {
  readonly project: Project;
  readonly settings: Settings;
}

/** The device at this place; left out: the one that is shown. The course's board and robot are the first one's. */
export function deviceAt({ work, settings }: WorkParts, place = work.place.value): DeviceAt {
  const { project } = work.work.value;
  const device = furtherDevice(project, place);
  if (device === null) return { project, settings: settings.current.value };
  const { firmware, robotOptions } = device;
  const files = filesOfDevice(project, place);
  const imports = modulesImportedBy(filesByName(files));
  const robot = device.robot === AUTO ? (robotMeant(imports, null)?.id ?? NO_ROBOT) : device.robot;
  const { scene } = project;
  const free = { ...scene, board: null, robot: { ...scene.robot, type: null, options: {} } };
  return {
    project: { ...project, files, scene: free },
    settings: { ...settings.current.value, device: device.device, firmware, robot, robotOptions, myRobot: null },
  };
}
