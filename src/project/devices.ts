import { filesByName, type FurtherDevice, type Project, type SourceFile } from './project';

/** The most microcomputers of a project: as many as a run may have. */
export const MOST_DEVICES = 8;
/** The longest name of a device. Chosen: it fits on its card. */
export const DEVICE_NAME_CHARACTERS = 30;

/** Name of the device of a project that has only one. */
const ONLY = '1';

/** The names of all devices, the first one's first. */
export const deviceNames = ({ devices }: Project): readonly string[] =>
  devices === undefined ? [ONLY] : [devices.first, ...devices.others.map(({ name }) => name)];

/** The device at this place of the list, or `null` for the first one and for a place without a device. */
export const furtherDevice = ({ devices }: Project, place: number): FurtherDevice | null =>
  devices?.others[place - 1] ?? null;

/** The files that the device at this place runs; without such a device those of the first. */
export function filesOfDevice(project: Project, place: number): readonly SourceFile[] {
  const device = furtherDevice(project, place);
  if (device === null) return project.files;
  if (device.sameAs === '') return device.files;
  const named = project.devices?.others.find(({ name }) => name === device.sameAs);
  return named?.files ?? project.files;
}

/** The files of the device at this place as a run takes them: name → text. */
export const runFilesOf = (project: Project, place: number): Readonly<Record<string, string>> =>
  filesByName(filesOfDevice(project, place));

/** The place of the device whose files the one at this place runs: its own place, or another device's. */
export function placeOfFiles(project: Project, place: number): number {
  const sameAs = furtherDevice(project, place)?.sameAs ?? '';
  return sameAs === '' ? place : deviceNames(project).indexOf(sameAs);
}

/** The project with these files on the device at this place; where it runs another one's, on that. */
export function withFiles(project: Project, place: number, files: readonly SourceFile[]): Project {
  const owner = placeOfFiles(project, place);
  return owner === 0 ? { ...project, files } : withDevice(project, owner, { files });
}

/** The project with another choice for the further device at this place. */
export function withDevice(project: Project, place: number, change: Partial<FurtherDevice>): Project {
  const { devices } = project;
  if (devices === undefined) return project;
  const others = devices.others.map((device, at) => (at === place - 1 ? { ...device, ...change } : device));
  return { ...project, devices: { ...devices, others } };
}

/**
 * The project with one device more, at the end of the list.
 *
 * @param first name of the first device, if it was the only one
 */
export function addedDevice(project: Project, device: FurtherDevice, first: string): Project {
  const { devices = { first, others: [] } } = project;
  return { ...project, devices: { ...devices, others: [...devices.others, device] } };
}

/** The project without the further device at this place. Those that ran its files keep them as their own. */
export function removedDevice(project: Project, place: number): Project {
  const gone = furtherDevice(project, place);
  if (gone === null || project.devices === undefined) return project;
  const others = project.devices.others
    .filter((device) => device !== gone)
    .map((device) => (device.sameAs === gone.name ? { ...device, sameAs: '', files: gone.files } : device));
  const { devices, ...alone } = project;
  return others.length === 0 ? alone : { ...project, devices: { ...devices, others } };
}

/**
 * The project with a device back that was taken away from this place. Those that ran its files run them again, unless
 * they were written on since.
 *
 * @param first name of the first device, if it is the only one now
 */
export function putBackDevice(project: Project, device: FurtherDevice, place: number, first: string): Project {
  const { devices = { first, others: [] } } = project;
  const others = devices.others.map((other) =>
    other.files === device.files ? { ...other, sameAs: device.name, files: [] } : other,
  );
  return { ...project, devices: { ...devices, others: others.toSpliced(place - 1, 0, device) } };
}

/** The project whose device at this place has another name, also where others run its files. */
export function renamedDevice(project: Project, place: number, name: string): Project {
  const { devices } = project;
  if (devices === undefined) return project;
  const before = deviceNames(project)[place];
  const others = devices.others.map((device, at) => ({
    ...device,
    ...(at === place - 1 && { name }),
    ...(device.sameAs === before && { sameAs: name }),
  }));
  return { ...project, devices: { first: place === 0 ? name : devices.first, others } };
}

/** The fault of a name for a device, or `null`. `own` is its present name. */
export function deviceNameProblem(
  name: string,
  names: readonly string[],
  own?: string,
): 'nameEmpty' | 'nameTaken' | 'nameLong' | 'nameCharacters' | null {
  if (name.trim() === '') return 'nameEmpty';
  if (name.length > DEVICE_NAME_CHARACTERS) return 'nameLong';
  // Names stand before lines of output and in options of the command line.
  if (/[\p{Cc}=,"]/u.test(name) || name !== name.trim()) return 'nameCharacters';
  return name !== own && names.includes(name) ? 'nameTaken' : null;
}

/** A name like `name` that no device has yet: `Robot`, `Robot 2`, `Robot 3`, … */
export function freeDeviceName(name: string, names: readonly string[]): string {
  for (let number = 2, candidate = name; ; candidate = `${name} ${String(number)}`, number += 1)
    if (!names.includes(candidate)) return candidate;
}
