// The drawings of the robots come apart from their types: a page shows one robot and needs one drawing.
import type { OptionValues } from '#core/option';

/** Loaders by path: `./callibot/robot.svg`. */
const files = import.meta.glob<string>('./*/robot.svg', { query: '?raw', import: 'default' });

const fetched = new Map<string, string>();

/**
 * The drawing of a robot: an SVG document; see ./robot.ts for its frame and the page's `robot-drawing.ts` for the names
 * of its parts. Rejects without a connection, and for an id without a robot.
 *
 * @param options the parts that are plugged in; left out: what comes in the box
 */
export async function fetchDrawing(id: string, options: OptionValues = {}): Promise<string> {
  const load = files[`./${id}/robot.svg`];
  if (load === undefined) throw new Error(`There is no drawing of a robot “${id}”.`);
  const drawing = fetched.get(id) ?? (await load());
  fetched.set(id, drawing);
  return withOptions(drawing, options);
}

/** The same if it has been fetched before, otherwise `null`. */
export function fetchedDrawing(id: string, options: OptionValues = {}): string | null {
  const drawing = fetched.get(id);
  return drawing === undefined ? null : withOptions(drawing, options);
}

/** A group of a drawing that is there only with (`if`) or without (`unless`) a choice of an option; no group is inside. */
const OPTIONAL = /<g data-(if|unless)="(\w+)=(\w+)".*?<\/g>\s*/gs;

const withOptions = (drawing: string, options: OptionValues): string =>
  drawing.replace(OPTIONAL, (group, when: string, option: string, choice: string) =>
    (options[option] === choice) === (when === 'if') ? group : '',
  );
