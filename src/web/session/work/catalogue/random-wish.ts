export const randomKinds = ['maze', 'track'] as const;
export type RandomKind = (typeof randomKinds)[number];

export const randomSizes = ['s', 'm', 'l'] as const;
export type RandomSize = (typeof randomSizes)[number];

/** A course that is made from a number. */
export interface RandomWish {
  readonly kind: RandomKind;
  readonly size: RandomSize;
  /** Within `seedRange`. */
  readonly seed: number;
}

/** Numbers short enough to be dictated in a classroom. */
export const seedRange = { min: 1, max: 999_999 } as const;

/** Reads a typed number; `null` when it is not one of `seedRange`. */
export function readSeed(text: string): number | null {
  const digits = text.trim();
  const seed = Number(digits);
  return /^\d+$/.test(digits) && seed >= seedRange.min && seed <= seedRange.max ? seed : null;
}

/** A four-digit number other than `before`. For the page only: no run depends on it. */
export function newSeed(before = 0): number {
  const seed = 1000 + Math.floor(Math.random() * 8999);
  return seed < before || before < 1000 ? seed : seed + 1;
}

/** The name of a random course in addresses: `maze-m-4711`. */
export const randomId = ({ kind, size, seed }: RandomWish): string => `${kind}-${size}-${String(seed)}`;

/** Reads what `randomId` wrote; `null` for the ids of other courses. */
export function readRandomId(id: string): RandomWish | null {
  const [, kind, size, digits] = /^(maze|track)-([sml])-([1-9]\d{0,5})$/.exec(id) ?? [];
  if (kind === undefined || size === undefined || digits === undefined) return null;
  return { kind: kind as RandomKind, size: size as RandomSize, seed: Number(digits) };
}
