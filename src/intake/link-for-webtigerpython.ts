import { defaultProjectSettings } from '#project/project';
import { programLinkOf, type Linked, type LinkedHardware, type WrittenLink } from '#project/webtigerpython/write-link';
import { AUTO, hardwareIds } from '#simulation/hardware';
import { hardwareOf } from './webtigerpython';

/** The link of a project for WebTigerPython, and what it cannot hold; `null`: it would be too long. */
export function linkForWebTigerPython(project: Linked): WrittenLink | null {
  return programLinkOf(project, linkedHardware(project));
}

function linkedHardware({ files, scene, settings = defaultProjectSettings }: Linked): LinkedHardware {
  const hardware = hardwareOf({ files, scene, settings });
  if ('problem' in hardware) return { device: settings.device, robot: '', meant: '' };
  const { board, robot } = hardwareIds(hardware);
  const device = settings.device === AUTO ? board : settings.device;
  const meant = hardwareOf({ files, scene: null, settings: { ...settings, device, robot: AUTO } });
  return { device, robot, meant: 'problem' in meant ? robot : hardwareIds(meant).robot };
}
