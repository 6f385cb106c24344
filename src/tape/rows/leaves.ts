/**
 * Plain data as a list of leaves: each has a place in a tree of keys, found again from moment to moment without comparing
 * names, and a whole number for its value.
 */

/** A key of an object, or a place in a list. */
export type Key = string | number;

/** The value at the end of a path; empty lists and objects are leaves, too. */
export type Leaf = number | string | boolean | null | readonly [] | Readonly<Record<string, never>>;

/** All leaves at one path, over time. */
export interface Column {
  readonly path: readonly Key[];
  /** Figures are rounded to multiples of this. */
  readonly step: number;
}

interface Node {
  readonly path: readonly Key[];
  /** Number of the column, once a leaf was seen here. */
  column: number;
  readonly children: Map<Key, Node>;
}

/** Gives every leaf its column. */
export class LeafTree {
  readonly columns: Column[] = [];
  private readonly root: Node = nodeAt([]);

  /** Calls `visit` for every leaf of a value made of plain objects, lists, numbers, texts, booleans and `null`. */
  walk(value: unknown, visit: (column: number, leaf: Leaf) => void): void {
    this.into(this.root, value, visit);
  }

  private into(node: Node, value: unknown, visit: (column: number, leaf: Leaf) => void): void {
    if (value === undefined) return;
    if (Array.isArray(value) && value.length > 0) {
      for (let at = 0; at < value.length; at++) this.into(childOf(node, at), value[at], visit);
    } else if (isFilled(value)) {
      for (const key in value) this.into(childOf(node, key), value[key], visit);
    } else {
      if (node.column < 0) node.column = this.columns.push({ path: node.path, step: stepOf(node.path) }) - 1;
      visit(node.column, value as Leaf);
    }
  }
}

const nodeAt = (path: readonly Key[]): Node => ({ path, column: -1, children: new Map() });

function childOf(node: Node, key: Key): Node {
  let child = node.children.get(key);
  if (child === undefined) node.children.set(key, (child = nodeAt([...node.path, key])));
  return child;
}

function isFilled(value: unknown): value is Readonly<Record<string, unknown>> {
  if (typeof value !== 'object' || value === null || Array.isArray(value)) return false;
  for (const _ in value) return true;
  return false;
}

/** The steps to which figures are rounded, by the unit at the end of their name. Chosen: finer than a screen shows. */
const STEPS: readonly (readonly [ending: RegExp, step: number])[] = [
  [/Us$/, 1],
  [/Mm$/, 0.1],
  [/Rad$/, 0.001],
];
const USUAL_STEP = 0.01;

/** The step of a leaf, by the unit in the name nearest to it: `fromMm/x` is in mm. */
export function stepOf(path: readonly Key[]): number {
  for (const key of path.toReversed()) {
    const found = STEPS.find(([ending]) => ending.test(String(key)));
    if (found) return found[1];
  }
  return USUAL_STEP;
}

/** Puts a leaf at its place in data that is being built up; the way there is made. */
export function putLeaf(root: { value: unknown }, path: readonly Key[], leaf: Leaf): void {
  if (path.length === 0) {
    root.value = leaf;
    return;
  }
  root.value ??= containerFor(path[0]);
  let at = root.value as Record<Key, unknown>;
  for (const [index, key] of path.entries()) {
    if (index === path.length - 1) at[key] = leaf;
    else at = (at[key] ??= containerFor(path[index + 1])) as Record<Key, unknown>;
  }
}

const containerFor = (key: Key | undefined): unknown => (typeof key === 'number' ? [] : {});
