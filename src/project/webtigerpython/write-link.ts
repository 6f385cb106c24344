/** Makes links that WebTigerPython opens: see `program-link.ts`. */
import LZString from 'lz-string';

import { isSame } from '#core/same';
import { sceneDefaults, type Scene } from '#scene/scene';

import { anyHardware, defaultProjectSettings, type Project, type ProjectSettings } from '../project';
import { deviceNameOf } from './device-names';
import { note, type Note } from './note';
import { MAX_PACKED } from './program-link';
import { writeWorld } from './write-world';

/** The page that opens the links. */
const HOST = 'https://webtigerpython.ethz.ch/';

/** Its name for no microcomputer. */
const NO_DEVICE = '-';

/** A project, a program without a course, or a course without files. */
export interface Linked extends Omit<Project, 'scene' | 'course'> {
  readonly scene: Scene | null;
}

/** The hardware of a project's run, by ids. */
export interface LinkedHardware {
  /** The microcomputer. */
  readonly device: string;
  /** The robot, and the one that the program's imports alone mean: a link does not name any. */
  readonly robot: string;
  readonly meant: string;
}

/** A link, and what it could not hold. */
export interface WrittenLink {
  readonly link: string;
  readonly notes: readonly Note[];
}

/**
 * Makes the link of a project's first device: its files and its course.
 *
 * @returns `null` if it would be longer than a link that is read here
 */
export function programLinkOf(project: Linked, hardware: LinkedHardware): WrittenLink | null {
  const { files, scene } = project;
  const code = packed(files.map(({ name, text }) => ({ name, data: text })));
  const written = scene === null ? null : writeWorld(scene);
  const playground = written === null ? '' : packed(written.world);
  if (code.length > MAX_PACKED || playground.length > MAX_PACKED) return null;
  const device = deviceNameOf(hardware.device);
  const parameters = [
    // The share button's alphabet for the program; the public links have the plain one for the world.
    ...(files.length === 0 ? [] : [`code=${code.replaceAll('+', '-').replaceAll('/', '_')}`]),
    `device=${encodeURIComponent(device ?? NO_DEVICE)}`,
    ...(written === null ? [] : [`playground=${encodeURIComponent(playground)}`]),
  ];
  const notes = [
    ...(written?.notes ?? []),
    ...(scene === null ? [] : notesOfScene(scene)),
    ...notesOfProject(project, hardware),
    ...(device === null ? [note('board', { board: hardware.device })] : []),
  ];
  return { link: `${HOST}#?${parameters.join('&')}`, notes };
}

/** JSON in base64 without the signs that fill it up. */
const packed = (value: unknown): string => LZString.compressToBase64(JSON.stringify(value)).replaceAll('=', '');

function notesOfScene({ name, description, background, robot }: Scene): readonly Note[] {
  const hasLooks = robot.name !== undefined || robot.color !== undefined;
  return [
    ...(background === null ? [] : [note('background')]),
    ...(name === '' && description === '' ? [] : [note('texts')]),
    ...(robot.scale === sceneDefaults.scale ? [] : [note('robotSize', { scale: robot.scale })]),
    ...(hasLooks ? [note('robotLooks')] : []),
  ];
}

function notesOfProject(project: Linked, { robot, meant }: LinkedHardware): readonly Note[] {
  const { scene, task, handIn, devices, settings = defaultProjectSettings } = project;
  const hasTask = task !== undefined || handIn !== undefined || !isSame(scene?.task ?? sceneDefaults.task, sceneDefaults.task); // prettier-ignore
  const options = Object.keys({ ...scene?.robot.options, ...settings.robotOptions[robot] });
  const count = (devices?.others.length ?? 0) + 1;
  return [
    ...(hasTask ? [note('task')] : []),
    ...(robot === meant ? [] : [note('robotType', { robot })]),
    ...(options.length > 0 ? [note('robotOptions', { count: options.length })] : []),
    ...(count > 1 ? [note('devices', { count })] : []),
    ...(isSame(ofRun(settings), ofRun(defaultProjectSettings)) ? [] : [note('settings')]),
  ];
}

/** Settings without the hardware that a link names or means, and without what is usual in new work. */
const ofRun = (settings: ProjectSettings): ProjectSettings => ({
  ...settings,
  ...{ ...anyHardware, firmware: settings.firmware, arenaSenses: false },
});
