import type { Vec } from '#core/geometry';
import { distanceMm } from '../plane';

/** Distance of the averaged places, in mm; larger for very long lines, which would have too many. */
const STEP_MM = 5;
const MOST_PLACES = 4000;

/**
 * How often each place is brought halfway to the middle of its neighbours. Chosen: 12 times at 5 mm average over about
 * 12 mm, which leaves 4 % of a tremble every 30 mm and 97 % of an arc of 50 mm radius.
 */
const ROUNDS = 12;

/** A trembling line made smooth. Its ends stay; of a closed line (first place = last) all places are alike. */
export function smooth(path: readonly Vec[]): readonly Vec[] {
  const even = evenly(path);
  const first = even[0];
  const last = even[even.length - 1];
  if (!first || !last || even.length < 3) return even;
  const isClosed = first.x === last.x && first.y === last.y;
  let places = isClosed ? even.slice(0, -1) : even;
  for (let round = 0; round < ROUNDS; round += 1) places = averaged(places, isClosed);
  const start = places[0];
  return isClosed && start ? [...places, start] : places;
}

function averaged(places: readonly Vec[], isClosed: boolean): readonly Vec[] {
  const last = places.length - 1;
  return places.map((place, index) => {
    const before = places[index - 1] ?? (isClosed ? places[last] : undefined);
    const after = places[index + 1] ?? (isClosed ? places[0] : undefined);
    if (!before || !after) return place;
    return { x: (before.x + 2 * place.x + after.x) / 4, y: (before.y + 2 * place.y + after.y) / 4 };
  });
}

/** The same line with places at equal distances along it, both ends included. */
function evenly(path: readonly Vec[]): readonly Vec[] {
  const [start] = path;
  if (!start) return [];
  let length = 0;
  path.forEach((place, index) => (length += distanceMm(path[index - 1] ?? place, place)));
  const pieces = Math.max(1, Math.min(MOST_PLACES, Math.round(length / STEP_MM)));
  const step = length / pieces;
  const places: Vec[] = [start];
  let walked = 0;
  path.forEach((place, index) => {
    const before = path[index - 1] ?? place;
    const piece = distanceMm(before, place);
    while (places.length < pieces && places.length * step <= walked + piece) {
      const share = piece === 0 ? 0 : (places.length * step - walked) / piece;
      places.push({ x: before.x + (place.x - before.x) * share, y: before.y + (place.y - before.y) * share });
    }
    walked += piece;
  });
  const end = path[path.length - 1];
  if (end && path.length > 1) places.push(end);
  return places;
}
