import { shown } from '#scene/problem';
import { type Reader } from '#scene/reader';

import { DEVICE_NAME_CHARACTERS, deviceNameProblem, MOST_DEVICES } from './devices';
import type { ProjectProblem } from './problem';
import { anyHardware, projectLimits, type FurtherDevice, type ProjectDevices } from './project';
import { readFiles } from './read-files';
import { readHardware } from './read-hardware';

/** A device as its file holds it: with files of its own, or with the name of the device whose files it runs. */
export const deviceValue = ({ sameAs, files, ...device }: FurtherDevice): object =>
  sameAs === '' ? { ...device, files } : { ...device, sameAs };

/** Several devices as they stand in a project file. */
export function devicesText({ first, others }: ProjectDevices): string {
  const lines = others.map((device) => JSON.stringify(deviceValue(device)));
  return `{\n    "first": ${JSON.stringify(first)},\n    "others": [\n      ${lines.join(',\n      ')}\n    ]\n  }`;
}

/** Reads the devices of a project, with what is wrong with their names and files. */
export function readDevices(
  value: unknown,
  reader: Reader,
): { readonly devices: ProjectDevices; readonly problems: readonly ProjectProblem[] } {
  const fields = reader.fields(value, 'devices', ['first', 'others']);
  const first = reader.text(fields['first'], 'devices.first', projectLimits.textCharacters);
  const tooMany = tooManyProblem(fields['others']);
  if (tooMany !== null) return { devices: { first, others: [] }, problems: [tooMany] };
  const entries = reader.list(fields['others'], 'devices.others', { min: 1, max: MOST_DEVICES - 1 });
  const problems: ProjectProblem[] = nameProblems(first, [], 'devices.first');
  const others: FurtherDevice[] = [];
  for (const [index, entry] of entries.entries()) {
    const path = `devices.others[${String(index)}]`;
    const read = readDevice(entry, path, reader);
    const names = [first, ...others.map(({ name }) => name)];
    problems.push(...nameProblems(read.device.name, names, `${path}.name`), ...read.problems);
    others.push(read.device);
  }
  others.forEach((device, index) => {
    const owners = [first, ...others.filter(({ sameAs }) => sameAs === '').map(({ name }) => name)];
    const path = `devices.others[${String(index)}].sameAs`;
    if (device.sameAs !== '' && !owners.includes(device.sameAs)) problems.push(sameAsProblem(device, path));
  });
  return { devices: { first, others }, problems };
}

function tooManyProblem(others: unknown): ProjectProblem | null {
  if (!Array.isArray(others) || others.length < MOST_DEVICES) return null;
  const params = { count: others.length + 1, most: MOST_DEVICES };
  const message = `devices: ${String(params.count)} devices are too many: at most ${String(MOST_DEVICES)} share a run. Take some away.`;
  return { code: 'too-many-devices', path: 'devices', value: String(params.count), params, message };
}

function readDevice(
  value: unknown,
  path: string,
  reader: Reader,
): { readonly device: FurtherDevice; readonly problems: readonly ProjectProblem[] } {
  const fields = reader.fields(value, path, ['name', ...Object.keys(anyHardware), 'files', 'sameAs']);
  const name = reader.text(fields['name'], `${path}.name`, projectLimits.textCharacters);
  const sameAs = reader.text(fields['sameAs'], `${path}.sameAs`, DEVICE_NAME_CHARACTERS, '');
  const hasOwn = sameAs === '' || fields['files'] !== undefined;
  const { files, problems } = hasOwn
    ? readFiles(fields['files'], `${path}.files`, reader)
    : { files: [], problems: [] };
  if (sameAs !== '' && hasOwn)
    reader.report(
      'unknown-property',
      `${path}.files`,
      undefined,
      'a device has files of its own or "sameAs", not both.',
      {
        known: 'sameAs',
      },
    );
  return { device: { name, ...readHardware(fields, path, reader), files, sameAs }, problems };
}

function nameProblems(name: string, before: readonly string[], path: string): ProjectProblem[] {
  const wrong = deviceNameProblem(name, before);
  if (wrong === null) return [];
  const message = `${path}: ${shown(name)} cannot be the name of a device: ${NAME_RULES[wrong]}`;
  return [{ code: 'device-name', path, value: shown(name), params: { rule: wrong }, message }];
}

function sameAsProblem({ name, sameAs }: FurtherDevice, path: string): ProjectProblem {
  const message = `${path}: ${shown(name)} cannot run the program of ${shown(sameAs)}. Name another device that has files of its own.`;
  return { code: 'same-as', path, value: shown(sameAs), params: { name, sameAs }, message };
}

const NAME_RULES = {
  nameEmpty: 'it is empty.',
  nameTaken: 'another device has it.',
  nameCharacters: 'it may have no spaces around it and none of , = ".',
  nameLong: `it is longer than ${String(DEVICE_NAME_CHARACTERS)} characters.`,
} as const;
