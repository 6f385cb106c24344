import type { Rng } from '#core/rng';

/** What hostile and broken files have in places where something else belongs. */
const ODD: readonly unknown[] = [
  null,
  true,
  0,
  -1,
  0.5,
  1e9,
  1e308,
  -1e308,
  '',
  'main.py',
  '__proto__',
  'constructor',
  '\ud800',
  'x'.repeat(5_000),
  [],
  {},
  [[]],
  [null, null],
  { length: 1e9 },
  JSON.parse('{"__proto__":{"polluted":true}}'),
];

const pick = (rng: Rng, count: number): number => Math.floor(rng.unit() * count);

/** A copy of a JSON value with one to three things in it changed: replaced, removed, doubled, renamed or nested deeply. */
export function mutatedValue(value: unknown, rng: Rng): unknown {
  let mutated = value;
  for (let times = 1 + pick(rng, 3); times > 0; times -= 1) mutated = mutatedOnce(mutated, rng, 0);
  return mutated;
}

function mutatedOnce(value: unknown, rng: Rng, depth: number): unknown {
  const isLeaf = typeof value !== 'object' || value === null || Object.keys(value).length === 0;
  if (isLeaf || rng.unit() < 0.15) return oddValue(value, rng);
  if (Array.isArray(value)) {
    const list: unknown[] = [...(value as readonly unknown[])];
    const index = pick(rng, list.length);
    const way = rng.unit();
    if (way < 0.1) list.splice(index, 1);
    else if (way < 0.2) list.splice(index, 0, list[pick(rng, list.length)]);
    else list[index] = mutatedOnce(list[index], rng, depth + 1);
    return list;
  }
  const entries = Object.entries(value);
  const index = pick(rng, entries.length);
  const [key, own] = entries[index] ?? ['', null];
  const way = rng.unit();
  if (way < 0.1) entries.splice(index, 1);
  else if (way < 0.15) entries.push([String(oddValue(key, rng)).slice(0, 20), own]);
  else if (way < 0.2) entries[index] = [key, entries[pick(rng, entries.length)]?.[1]];
  else entries[index] = [key, mutatedOnce(own, rng, depth + 1)];
  return Object.fromEntries(entries);
}

function oddValue(value: unknown, rng: Rng): unknown {
  const way = rng.unit();
  if (typeof value === 'number' && way < 0.4) return value * (1 + pick(rng, 3)) - pick(rng, 100);
  if (typeof value === 'string' && way < 0.4) return mutatedText(value, rng);
  if (way < 0.45) {
    let deep = value;
    for (let level = 1 + pick(rng, 300); level > 0; level -= 1) deep = [deep];
    return deep;
  }
  if (way < 0.5) return Array.from({ length: Math.min(pick(rng, 3_000), mostCopies(value)) }, () => value);
  return ODD[pick(rng, ODD.length)];
}

/** Copies of copies of a whole project would be more than a text can hold; this is far beyond what a file may have. */
const COPIED_CHARACTERS = 20_000_000;

const mostCopies = (value: unknown): number =>
  Math.max(1, Math.floor(COPIED_CHARACTERS / ((JSON.stringify(value) ?? '').length + 1)));

/** A text with some characters removed, doubled, swapped or put in. */
export function mutatedText(text: string, rng: Rng): string {
  let mutated = text;
  for (let times = 1 + pick(rng, 4); times > 0; times -= 1) {
    const at = pick(rng, mutated.length + 1);
    const to = Math.min(mutated.length, at + 1 + pick(rng, rng.unit() < 0.2 ? 200 : 4));
    const way = rng.unit();
    if (way < 0.25) mutated = mutated.slice(0, at) + mutated.slice(to);
    else if (way < 0.5) mutated = mutated.slice(0, to) + mutated.slice(at);
    else if (way < 0.6) mutated = mutated.slice(0, at);
    else mutated = mutated.slice(0, at) + SIGNS.charAt(pick(rng, SIGNS.length)) + mutated.slice(to);
  }
  return mutated;
}
const SIGNS = 'AZaz09-_=+/.%#?&{}[]",: \n\u0000ü€';

/** Bytes with some of them changed, removed or put in. */
export function mutatedBytes(bytes: Uint8Array, rng: Rng): Uint8Array {
  const list = Array.from(bytes);
  for (let times = 1 + pick(rng, 4); times > 0; times -= 1) {
    const at = pick(rng, list.length + 1);
    const way = rng.unit();
    if (way < 0.7) list[Math.min(at, Math.max(0, list.length - 1))] = pick(rng, 256);
    else if (way < 0.85) list.splice(at, 1 + pick(rng, 4));
    else list.splice(at, 0, ...Array.from({ length: 1 + pick(rng, 8) }, () => pick(rng, 256)));
  }
  return Uint8Array.from(list);
}
