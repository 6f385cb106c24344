import { isRecord } from '#core/record';
import { join, type Fields, type Reader } from '#scene/reader';

import { anyHardware, projectLimits, type HardwareWish } from './project';

/** Reads the hardware that a program is meant for, out of the object at `path`. */
export function readHardware(fields: Fields, path: string, reader: Reader): HardwareWish {
  const id = (key: 'device' | 'firmware' | 'robot'): string =>
    reader.text(fields[key], join(path, key), projectLimits.idCharacters, anyHardware[key]);
  return {
    device: id('device'),
    firmware: id('firmware'),
    robot: id('robot'),
    robotOptions: readRobotOptions(fields['robotOptions'], join(path, 'robotOptions'), reader),
  };
}

function readRobotOptions(value: unknown, path: string, reader: Reader): HardwareWish['robotOptions'] {
  const robots = readEntries(value, path, reader);
  return Object.fromEntries(
    robots.map(([robot, options]) => {
      const place = `${path}.${robot.slice(0, 40)}`;
      const own = readEntries(options, place, reader).map(([option, choice]): [string, string] => {
        return [option, reader.text(choice, `${place}.${option.slice(0, 40)}`, projectLimits.idCharacters)];
      });
      return [robot, Object.fromEntries(own)];
    }),
  );
}

function readEntries(value: unknown, path: string, reader: Reader): readonly (readonly [string, unknown])[] {
  if (value === undefined) return [];
  if (!isRecord(value)) {
    reader.wrongType(value, path, 'an object { … }');
    return [];
  }
  const entries = Object.entries(value);
  for (const [key] of entries) {
    reader.text(key, path, projectLimits.idCharacters);
    if (key === '__proto__') reader.report('unknown-value', path, key, '"__proto__" cannot be an id.');
  }
  return reader.list(entries, path, { min: 0, max: projectLimits.options }) as typeof entries;
}
