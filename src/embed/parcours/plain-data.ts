import { isPlainObject } from '../plain-object';

/** Maximum size of a message, checked before its content. */
export interface DataRoom {
  readonly values: number;
  readonly characters: number;
  readonly depth: number;
}

/**
 * Checks that a message is plain data (objects, lists, texts, numbers, booleans, `null`) within its limits. The cost is
 * bounded by the limits: a message that contains itself is found by its size.
 *
 * @returns the problem, or `null`
 */
export function dataProblem(message: object, room: DataRoom): 'not-plain' | 'too-large' | null {
  let { values, characters } = room;
  let level: readonly unknown[] = [message];
  for (let depth = 0; level.length > 0; depth += 1) {
    if (depth > room.depth) return 'too-large';
    const next: unknown[] = [];
    for (const value of level) {
      if (typeof value === 'string') characters -= value.length;
      if (typeof value === 'function' || typeof value === 'symbol' || typeof value === 'bigint') return 'not-plain';
      if (typeof value !== 'object' || value === null) continue;
      if (!Array.isArray(value) && !isPlainObject(value)) return 'not-plain';
      if (Array.isArray(value) && value.length > values) return 'too-large';
      // A list may also have named properties: they count like its entries.
      const inner: readonly unknown[] = Object.values(value);
      values -= inner.length;
      if (!Array.isArray(value)) for (const key of Object.keys(value)) characters -= key.length;
      if (values < 0 || characters < 0) return 'too-large';
      for (const entry of inner) next.push(entry);
    }
    if (characters < 0) return 'too-large';
    level = next;
  }
  return null;
}
