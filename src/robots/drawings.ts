// The drawings of the robots come apart from their types: a page shows one robot and needs one drawing.

/** Loaders by path: `./callibot/robot.svg`. */
const files = import.meta.glob<string>('./*/robot.svg', { query: '?raw', import: 'default' });

const fetched = new Map<string, string>();

/**
 * The drawing of a robot: an SVG document; see ./robot.ts for its frame and the page's `robot-drawing.ts` for the names
 * of its parts. Rejects without a connection, and for an id without a robot.
 */
export async function fetchDrawing(id: string): Promise<string> {
  const load = files[`./${id}/robot.svg`];
  if (load === undefined) throw new Error(`There is no drawing of a robot “${id}”.`);
  const drawing = fetched.get(id) ?? (await load());
  fetched.set(id, drawing);
  return drawing;
}

/** The same if it has been fetched before, otherwise `null`. */
export const fetchedDrawing = (id: string): string | null => fetched.get(id) ?? null;
