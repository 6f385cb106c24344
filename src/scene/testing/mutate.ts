import type { Rng } from '#core/rng';
import { inPercent, oneOf, wholeFrom } from './fuzz';

/** Values that do not belong where they are put; all of them can occur in a file. */
const strange: readonly unknown[] = [
  null,
  true,
  false,
  0,
  -1,
  0.5,
  1e9,
  -1e308,
  2 ** 53,
  5e-324,
  '',
  'block',
  'stroke',
  '__proto__',
  'constructor',
  'toString',
  '\ud800',
  '\u0000\n\u2028',
  'x'.repeat(10_000),
  [],
  [[]],
  {},
  { length: 3 },
  { toString: 1, valueOf: null },
  [null, null],
  [1e999, 0],
];

/** Values that can only come in a message, not in a file. */
const strangeInMessages: readonly unknown[] = [NaN, Infinity, -0, undefined, 10n, new Date(NaN), new Map([['a', 1]])];

interface Slot {
  readonly holder: Record<string, unknown>;
  readonly key: string;
}

/**
 * A plain value with some of its parts removed, swapped, repeated, changed or replaced by something strange.
 *
 * @param isMessage also by what cannot be written into a file, such as `NaN`
 */
export function mutatedTree(original: unknown, rng: Rng, isMessage: boolean): unknown {
  const root = { value: structuredClone(original) };
  for (let count = wholeFrom(rng, 1, 4); count > 0; count--) {
    const slots = slotsOf(root);
    if (slots.length > 0) mutateSlot(oneOf(rng, slots), slots, rng, isMessage);
  }
  return root.value;
}

/** Every place of a tree that holds something, not deeper than 50 levels; bytes count as one thing. */
function slotsOf(root: unknown): readonly Slot[] {
  const slots: Slot[] = [];
  const visit = (value: unknown, depth: number): void => {
    if (typeof value !== 'object' || value === null || ArrayBuffer.isView(value) || depth > 50) return;
    for (const key of Object.keys(value).slice(0, 500)) {
      const holder = value as Record<string, unknown>;
      slots.push({ holder, key });
      visit(holder[key], depth + 1);
    }
  };
  visit(root, 0);
  return slots;
}

function mutateSlot({ holder, key }: Slot, slots: readonly Slot[], rng: Rng, isMessage: boolean): void {
  const value = holder[key];
  switch (rng.u32() % 9) {
    case 0:
      holder[key] = structuredClone(oneOf(rng, isMessage ? [...strange, ...strangeInMessages] : strange));
      return;
    case 1:
      remove(holder, key);
      return;
    case 2: {
      const other = oneOf(rng, slots);
      holder[key] = structuredClone(other.holder[other.key]);
      return;
    }
    case 3:
      if (Array.isArray(holder)) holder.splice(Number(key), 0, structuredClone(value));
      else addKey(holder, oneOf(rng, ['x', '__proto__', 'constructor', 'x'.repeat(500), 'type', 'id']), value);
      return;
    case 4:
      holder[key] = nested(value, wholeFrom(rng, 1, 300));
      return;
    case 5:
      if (inPercent(rng, 10)) holder[key] = repeated(value, oneOf(rng, [3, 100, 2001, 5000]));
      else if (Array.isArray(value)) holder[key] = [...(value as unknown[])].reverse();
      return;
    default:
      holder[key] = nudged(value, rng);
  }
}

/** Each a copy of its own, few of what is large: a tree must not grow beyond what a test can look at. */
function repeated(value: unknown, count: number): unknown {
  return Array.from({ length: slotsOf(value).length < 20 ? count : 3 }, () => structuredClone(value));
}

function remove(holder: Record<string, unknown>, key: string): void {
  if (Array.isArray(holder)) holder.splice(Number(key), 1);
  else Reflect.deleteProperty(holder, key);
}

/** As JSON.parse does it: also `__proto__` becomes a property like others. */
function addKey(holder: Record<string, unknown>, key: string, value: unknown): void {
  Object.defineProperty(holder, key, { value, enumerable: true, configurable: true, writable: true });
}

function nested(value: unknown, levels: number): unknown {
  let tree = value;
  for (let level = 0; level < levels; level++) tree = level % 2 === 0 ? [tree] : { type: 'all', edits: [tree] };
  return tree;
}

/** Something of the same kind, a little or much different. */
function nudged(value: unknown, rng: Rng): unknown {
  switch (typeof value) {
    case 'number':
      return oneOf(rng, [value + 1, value - 1, -value, value * 10, value / 2, wholeFrom(rng, -30_000, 30_000)]);
    case 'string':
      return inPercent(rng, 50)
        ? mutatedText(value, rng)
        : oneOf(
            rng,
            strange.filter((other) => typeof other === 'string'),
          );
    case 'boolean':
      return !value;
    default:
      return value;
  }
}

const scraps = [
  '{',
  '}',
  '[',
  ']',
  ',',
  ':',
  '"',
  '-',
  '.',
  '0',
  '9',
  'e',
  'null',
  '\\',
  '\\u0000',
  '\n',
  '/*',
  ' ',
  'é',
  '=',
];

/** A text with some of its letters removed, repeated, swapped or changed. */
export function mutatedText(text: string, rng: Rng): string {
  let mutated = text;
  for (let count = wholeFrom(rng, 1, 4); count > 0; count--) {
    const at = wholeFrom(rng, 0, mutated.length);
    const end = Math.min(mutated.length, at + wholeFrom(rng, 1, inPercent(rng, 20) ? 200 : 3));
    switch (rng.u32() % 5) {
      case 0:
        mutated = mutated.slice(0, at) + mutated.slice(end);
        break;
      case 1:
        mutated = mutated.slice(0, end) + mutated.slice(at);
        break;
      case 2:
        mutated = mutated.slice(0, at);
        break;
      case 3:
        mutated = mutated.slice(0, at) + oneOf(rng, scraps).repeat(inPercent(rng, 2) ? 50_000 : 1) + mutated.slice(at);
        break;
      default:
        mutated = mutated.slice(0, at) + oneOf(rng, scraps) + mutated.slice(end);
    }
  }
  return mutated;
}
