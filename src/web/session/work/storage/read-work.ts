/** Reads stored work. Loaded where there is some: a first visit needs no reader. */
import { isRecord } from '#core/record';
import {
  MAIN,
  type FurtherDevice,
  type Project,
  type ProjectDevices,
  type ProjectSettings,
  type SourceFile,
} from '#project/project';
import { parseSceneValue } from '#scene/parse';

import type { Deleted, Previous, Work } from './history';

/** Reads what `workToText` wrote; `null` for anything else, so that a broken store never stops the app. */
export function workFromText(text: string): Work | null {
  let value: unknown;
  try {
    value = JSON.parse(text);
  } catch {
    return null;
  }
  if (typeof value !== 'object' || value === null) return null;
  const read: Partial<Readonly<Record<string, unknown>>> = value;
  const project = unpackProject(read['project']);
  if (read['version'] !== 1 || project === null) return null;
  const open = project.files.find((file) => file.name === read['open'])?.name ?? project.files[0]?.name;
  const previous = listOf(read['previous'], readPrevious);
  const deleted = listOf(read['deleted'], readDeleted);
  if (open === undefined) return null;
  const handedIn = read['isHandedIn'] === true && ({ isHandedIn: true } as const);
  return { project, open, ...fileOf(read['file']), ...handedIn, previous, ...(deleted.length > 0 && { deleted }) };
}

const listOf = <T>(value: unknown, read: (entry: unknown) => T | null): readonly T[] =>
  Array.isArray(value) ? value.map(read).filter((entry) => entry !== null) : [];

function readDeleted(value: unknown): Deleted | null {
  const read = readPrevious(value);
  if (read === null || !isRecord(value) || typeof value['deletedMs'] !== 'number') return null;
  return { ...read, deletedMs: value['deletedMs'] };
}

function readPrevious(value: unknown): Previous | null {
  if (!isRecord(value)) return null;
  const { name, atMs, project, file, isOfTab } = value;
  const read = unpackProject(project);
  if (typeof name !== 'string' || typeof atMs !== 'number' || read === null) return null;
  return { name, atMs, ...fileOf(file), ...(isOfTab === true && { isOfTab }), project: read };
}

const fileOf = (file: unknown): Pick<Work, 'file'> => (typeof file === 'string' ? { file } : {});

/** Reads what `packedText` made; `null` for anything else. */
export function unpackProject(value: unknown): Project | null {
  if (!isRecord(value)) return null;
  const { files, scene, course, settings, devices, task, handIn } = value;
  const parsed = parseSceneValue(scene);
  if (!('scene' in parsed) || !isProgram(files)) return null;
  return {
    files,
    scene: parsed.scene,
    course: typeof course === 'string' ? course : null,
    ...(isSettings(settings) && { settings }),
    ...(isDevices(devices) && { devices }),
    ...(isRecord(task) && { task }),
    ...(isRecord(handIn) && { handIn }),
  };
}

function isProgram(value: unknown): value is readonly SourceFile[] {
  return Array.isArray(value) && value.every(isFile) && value[0]?.name === MAIN;
}

const isFile = (value: unknown): value is SourceFile =>
  isRecord(value) && typeof value['name'] === 'string' && typeof value['text'] === 'string';

/** Checks the shape of settings that this app itself stored; the names in them are checked when they are used. */
function isSettings(value: unknown): value is ProjectSettings {
  if (!isRecord(value)) return false;
  const { reality, seed, arenaSenses, myRobot } = value;
  return (
    isHardware(value) &&
    typeof reality === 'number' &&
    typeof seed === 'number' &&
    typeof arenaSenses === 'boolean' &&
    (myRobot === undefined || isRecord(myRobot))
  );
}

function isHardware({ device, firmware, robot, robotOptions }: Readonly<Record<string, unknown>>): boolean {
  return (
    [device, firmware, robot].every((id) => typeof id === 'string') &&
    isRecord(robotOptions) &&
    Object.values(robotOptions).every(isRecord)
  );
}

/** Checks the shape of devices in the same way. */
function isDevices(value: unknown): value is ProjectDevices {
  if (!isRecord(value) || typeof value['first'] !== 'string' || !Array.isArray(value['others'])) return false;
  return value['others'].length > 0 && value['others'].every(isFurther);
}

function isFurther(value: unknown): value is FurtherDevice {
  if (!isRecord(value) || !isHardware(value)) return false;
  const { name, files, sameAs } = value;
  if (typeof name !== 'string' || typeof sameAs !== 'string') return false;
  return sameAs === '' ? isProgram(files) : Array.isArray(files) && files.length === 0;
}
