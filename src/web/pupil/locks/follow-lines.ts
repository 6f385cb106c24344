import { changedLines } from '#core/changed-lines';

/** Locked lines of a program that has changed. */
export interface Followed {
  /** Their numbers now, from 1, in order. */
  readonly lines: readonly number[];
  /** The texts of those that are gone. */
  readonly lost: readonly string[];
}

/**
 * The new places of locked lines while the author goes on writing: a lock moves with its line, and stays on one that is
 * written anew. A lock that went comes back with its text: a cut may be taken back, or pasted elsewhere.
 *
 * @param lines their numbers before, from 1
 * @param gone the texts of those that went earlier
 */
export function followLines(
  before: string,
  after: string,
  lines: readonly number[],
  gone: readonly string[] = [],
): Followed {
  const { old, now, head, tail } = changedLines(before, after);
  const [oldEnd, end] = [old.length - tail, now.length - tail];
  const places = new Set<number>();
  const moved: string[] = [];
  for (const place of lines.map((line) => line - 1)) {
    if (place < head) places.add(place);
    else if (place >= oldEnd) places.add(place + end - oldEnd);
    else if (!put(placeOf(place))) moved.push(old[place] ?? '');
  }
  const lost = [...moved, ...gone].filter((text) => text.trim() !== '' && !put(freeWith((line) => line === text)));
  return { lines: [...places].sort((one, other) => one - other).map((place) => place + 1), lost };

  function put(place: number): boolean {
    if (place >= 0) places.add(place);
    return place >= 0;
  }
  /** A line of what was changed that has no lock yet; -1: none. */
  function freeWith(fits: (line: string) => boolean): number {
    for (let at = head; at < end; at += 1) if (!places.has(at) && fits(now[at] ?? '')) return at;
    return -1;
  }
  /** The same line elsewhere, else the one in its place, else a part of it, or one of which it is a part. */
  function placeOf(place: number): number {
    const text = old[place] ?? '';
    const same = freeWith((line) => line === text);
    if (same >= 0 || text.trim() === '') return same;
    const isOne = oldEnd - head === 1 && end - head === 1;
    const inPlace = place < end && oldEnd === end && !places.has(place) && (isOne || isAlike(text, now[place] ?? ''));
    return inPlace ? place : freeWith((line) => isPart(text.trim(), line.trim()));
  }
}

const isPart = (one: string, other: string): boolean => other !== '' && (one.includes(other) || other.includes(one));

/** The same, but for something in the middle or for how far it is indented. */
function isAlike(one: string, other: string): boolean {
  const [text, now] = [one.trim(), other.trim()];
  let [head, tail] = [0, 0];
  const shorter = Math.min(text.length, now.length);
  while (head < shorter && text[head] === now[head]) head += 1;
  while (tail < shorter - head && text.at(-1 - tail) === now.at(-1 - tail)) tail += 1;
  return 2 * (head + tail) >= Math.max(text.length, now.length);
}
