import type { Reader } from '#scene/reader';

import { projectLimits, type Carried } from './project';

/** Reads what a project only carries along: any object of JSON that is neither too long nor too deep. */
export function readCarried(value: unknown, path: string, reader: Reader): Carried {
  if (typeof value !== 'object' || value === null || Array.isArray(value)) {
    reader.wrongType(value, path, 'an object { … }');
    return {};
  }
  const { carriedCharacters: max, carriedLevels } = projectLimits;
  if (isDeeper(value, carriedLevels)) {
    reader.report('too-many', path, undefined, `has more than ${carriedLevels} levels.`, {
      count: carriedLevels + 1,
      min: 0,
      max: carriedLevels,
    });
    return {};
  }
  const text = JSON.stringify(value);
  const { length } = text;
  // As the file will have it: what JSON cannot say, such as a negative zero, does not survive.
  if (length <= max) return JSON.parse(text) as Carried;
  const what = `${length} characters are too many; the limit is ${max}.`;
  reader.report('too-long', path, undefined, what, { length, max });
  return {};
}

function isDeeper(value: unknown, levels: number): boolean {
  if (typeof value !== 'object' || value === null) return false;
  return levels === 0 || Object.values(value).some((inner) => isDeeper(inner, levels - 1));
}
