import { defaultProjectSettings } from '#project/project';
import { hasRobotOf } from '#project/webtigerpython/device-names';
import { note, type Note } from '#project/webtigerpython/note';
import { programLinkOf, type Linked, type LinkedHardware, type WrittenLink } from '#project/webtigerpython/write-link';
import { AUTO, hardwareIds, type Hardware } from '#simulation/hardware';
import { hardwareOf } from './webtigerpython';

/** The link of a project for WebTigerPython, and what it cannot hold; `null`: it would be too long. */
export function linkForWebTigerPython(project: Linked): WrittenLink | null {
  const { files, scene, settings = defaultProjectSettings } = project;
  const hardware = hardwareOf({ files, scene, settings });
  if ('problem' in hardware) return programLinkOf(project, { device: settings.device, robot: '', meant: '' });
  const device = settings.device === AUTO ? hardwareIds(hardware).board : settings.device;
  const itsOwn = hardwareOf({ files, scene: null, settings: { ...settings, device, robot: AUTO } });
  const meant = 'problem' in itsOwn ? hardware : itsOwn;
  const linked: LinkedHardware = { device, robot: hardwareIds(hardware).robot, meant: hardwareIds(meant).robot };
  const written = programLinkOf(project, linked);
  return written && { ...written, notes: [...written.notes, ...notSimulated(meant)] };
}

/** A note on a robot that a program means and that is not simulated there. */
const notSimulated = ({ robot }: Hardware): readonly Note[] =>
  robot === null || hasRobotOf(robot.modules) ? [] : [note('robotAbsent', { robot: robot.id })];
