import { usualForm, type LightForm, type LightPlace, type LightWish } from '../../../session/work/settings/light-wish';

/**
 * Form and place of a chain of this many lights: as chosen, otherwise the usual form beside the board. Without a robot
 * none lies on it.
 */
export function shownAs(
  count: number,
  wish: LightWish | undefined,
  hasRobot: boolean,
): { readonly form: LightForm; readonly place: LightPlace } {
  return { form: wish?.form ?? usualForm(count), place: wish?.place === 'robot' && hasRobot ? 'robot' : 'board' };
}

/** Places of lights; 1 is the distance from one to the next, the origin the middle. */
export interface LightLayout {
  readonly form: LightForm;
  /** x to the right, y down, in the order of the wire. */
  readonly places: readonly { readonly x: number; readonly y: number }[];
  /** Half of the extent, half a unit around the outer lights included. */
  readonly halfWidth: number;
  readonly halfHeight: number;
  /** On a ring: from the middle to its lights. */
  readonly radius: number;
}

/**
 * Lays out a chain.
 *
 * - `ring`: the first light on top, then clockwise, as on the rings by Adafruit and its copies seen from their front.
 * - `strip`: rows from left to right like the lines of a text; the wire runs back at the end of each.
 * - `matrix`: the same, as wide as high or wider, as on Adafruit's 8 × 8 boards.
 * - `zigzag`: every second row from right to left, as on flexible panels, which is how most 16 × 16 are made.
 */
export function layOut(form: LightForm, count: number): LightLayout {
  if (form === 'ring') return ring(count);
  const columns = form === 'strip' ? stripColumns(count) : matrixColumns(count);
  const rows = Math.ceil(count / columns);
  const places = Array.from({ length: count }, (_, light) => {
    const row = Math.floor(light / columns);
    const column = form === 'zigzag' && row % 2 === 1 ? columns - 1 - (light % columns) : light % columns;
    return { x: column - (columns - 1) / 2, y: row - (rows - 1) / 2 };
  });
  return { form, places, halfWidth: columns / 2, halfHeight: rows / 2, radius: 0 };
}

function ring(count: number): LightLayout {
  const radius = Math.max(1, count / (2 * Math.PI));
  const places = Array.from({ length: count }, (_, light) => {
    const angle = (2 * Math.PI * light) / count;
    return { x: radius * Math.sin(angle), y: -radius * Math.cos(angle) };
  });
  return { form: 'ring', places, halfWidth: radius + 0.6, halfHeight: radius + 0.6, radius };
}

/** Chosen: short sticks have 8 lights or up to 10; longer strips are wrapped. */
function stripColumns(count: number): number {
  if (count <= 10) return Math.max(1, count);
  if (count % 8 === 0 && count <= 64) return 8;
  return count <= 100 ? 10 : count <= 400 ? 20 : 32;
}

/** The two factors nearest to each other, the larger one across. More than 4 : 1 is not a matrix: then 8 across. */
function matrixColumns(count: number): number {
  let height = Math.max(1, Math.floor(Math.sqrt(count)));
  while (count % height !== 0) height -= 1;
  const width = count / height;
  return width > 4 * height ? Math.min(8, count) : width;
}

/** How many of these lights are on. */
export function litCount(colors: readonly (readonly number[])[]): number {
  return colors.filter((color) => color.some((channel) => channel > 0)).length;
}
