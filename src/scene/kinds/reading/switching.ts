import type { Reader } from '../../reader';
import { switchLimits, switchPins, switchWays, type Switching } from '../switching';

/** Reads a switching. */
export function readSwitching(value: unknown, path: string, reader: Reader): Switching {
  if (value === 'hand') return 'hand';
  const before = reader.problems.length;
  const fields = reader.fields(value, path, switchWays.slice(1));
  const given = switchWays.filter((way) => fields[way] !== undefined);
  const [way] = given;
  if (given.length > 1)
    reader.report('said-twice', path, value, `only one of ${given.join(', ')} switches. Leave out the others.`, { other: given[1] ?? '' }); // prettier-ignore
  const [own, ownPath] = [way && fields[way], `${path}.${way ?? 'hand'}`];
  switch (way) {
    case 'time':
      return { time: pairOf(own, ownPath, reader, (one, at) => reader.number(one, at, switchLimits.seconds)) };
    case 'radio':
      return { radio: pairOf(own, ownPath, reader, (one, at) => readText(one, at, reader)) };
    case 'button':
      return { button: reader.word(own, ownPath, ['a', 'b'], 'a') };
    case 'pin':
      return { pin: reader.word(own, ownPath, switchPins, 'P0') };
    default:
      if (reader.problems.length === before)
        reader.wrongType(value, path, '"hand", or an object such as { "time": [3, 2] }');
      return 'hand';
  }
}

function pairOf<T>(value: unknown, path: string, reader: Reader, read: (value: unknown, path: string) => T): [T, T] {
  const [on, off] = reader.list(value, path, { min: 2, max: 2 });
  return [read(on, `${path}[0]`), read(off, `${path}[1]`)];
}

function readText(value: unknown, path: string, reader: Reader): string {
  const text = reader.text(value, path, switchLimits.characters);
  if (value === '') reader.report('missing', path, text, 'must not be empty.');
  return text;
}
