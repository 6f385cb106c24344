import { kindReaders } from './kinds/reading/index';
import { commonProperties, readCommon, unread } from './kinds/reading/unread';
import type { Reader } from './reader';
import type { SceneObject } from './scene';

/**
 * Reads an unchecked object of a course; its mistakes are noted in the reader.
 *
 * @param pointsLeft maximum number of its points
 * @returns `null` if not even its type is known
 */
export function readObject(value: unknown, path: string, pointsLeft: number, reader: Reader): SceneObject | null {
  const type: unknown = typeof value === 'object' && value !== null && 'type' in value ? value.type : undefined;
  if (isKnown(type)) {
    const kind = kindReaders[type];
    const older = kind.properties.includes('angle') ? ['turn'] : [];
    const fields = reader.fields(value, path, [...commonProperties, ...kind.properties, ...older]);
    const given = unread(fields, path, pointsLeft, reader);
    return { ...kind.read(given), ...readCommon(given) };
  }
  const known = Object.keys(kindReaders);
  if (typeof value !== 'object' || value === null) reader.wrongType(value, path, 'an object { … }');
  else if (type === undefined) reader.wrongType(type, `${path}.type`, known.join(', '));
  else reader.word(type, `${path}.type`, known, 'wall');
  return null;
}

const isKnown = (type: unknown): type is SceneObject['type'] =>
  typeof type === 'string' && Object.hasOwn(kindReaders, type);
