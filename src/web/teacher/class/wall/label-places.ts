import type { Size } from './wall-cards';

/** A rectangle in a picture, from its top left corner. */
export interface Box extends Size {
  readonly left: number;
  readonly top: number;
}

/** A dot that wants a name of this size beside it. */
export interface Named {
  readonly x: number;
  readonly y: number;
  /** Radius of the dot, with the gap to its name. */
  readonly radius: number;
  readonly label: Size;
}

/**
 * The places of names: at the right of their dot, at its left, above, below, wherever no other name is yet. `null`: nowhere,
 * and the dot goes without. Names over one another can be read by nobody; who comes first has the first choice.
 *
 * @param picture names stay inside of it
 */
export function labelPlaces(dots: readonly Named[], picture: Size): readonly (Box | null)[] {
  const taken: Box[] = [];
  return dots.map((dot) => {
    const place = placesAround(dot, picture).find(
      (box) => isInside(box, picture) && !taken.some((other) => meet(box, other)),
    );
    if (place !== undefined) taken.push(place);
    return place ?? null;
  });
}

function placesAround({ x, y, radius, label }: Named, picture: Size): readonly Box[] {
  const within = (value: number, most: number): number => Math.max(0, Math.min(value, most));
  const middle = within(y - label.height / 2, picture.height - label.height);
  const centre = within(x - label.width / 2, picture.width - label.width);
  return [
    { ...label, left: x + radius, top: middle },
    { ...label, left: x - radius - label.width, top: middle },
    { ...label, left: centre, top: y - radius - label.height },
    { ...label, left: centre, top: y + radius },
  ];
}

const isInside = ({ left, top, width, height }: Box, picture: Size): boolean =>
  left >= 0 && top >= 0 && left + width <= picture.width && top + height <= picture.height;

const meet = (one: Box, other: Box): boolean =>
  one.left < other.left + other.width &&
  other.left < one.left + one.width &&
  one.top < other.top + other.height &&
  other.top < one.top + one.height;
