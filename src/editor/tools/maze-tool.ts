import type { Vec } from '#core/geometry';
import type { Replacement, SceneEdit } from '#scene/edit';
import { heightOf } from '#scene/kinds/heights';
import type { Point, Scene, Wall } from '#scene/scene';
import { endOf, isTap, startOf } from '../drag';
import { combined, replacing, roomIn } from '../edits';
import { freeIds, type IdSource } from '../ids';
import { newWallLook } from '../kinds/wall';
import {
  edgeAlong,
  endsOf,
  isTaken,
  keyOf,
  lineKeyOf,
  nearestEdge,
  overhangMm,
  spanOf,
  wallEndsAlong,
  wallsOn,
  type GridEdge,
  type LineWall,
  type Span,
} from './maze-grid';
import { distanceMm, within } from '../plane';
import { alongPath } from './path-fold';
import { toolOptionRanges } from './tool-options';
import type { Drag, Mark, Tool, ToolContext, ToolOptions } from './tool';

/** A tap that is farther than this share of a cell from every edge means none. */
const TAP_WITHIN = 0.35;

/** Builds mazes on the edges of a grid: a tap adds or removes a wall, a drag along edges does so for all of them. */
export const mazeTool: Tool = {
  id: 'maze',
  cursor: 'cell',
  edit(drag, context): SceneEdit | null {
    const { scene, options } = context;
    const edges = isTap(drag) ? tappedEdges(drag, context) : [...edgesAlong(drag, context).edges.values()];
    const [first] = edges;
    if (!first) return null;
    const cellMm = cellOf(options);
    const erases = isTaken(spanOf(first, cellMm, scene.size), wallsOn(scene, first, cellMm));
    return erases ? taken(scene, edges, cellMm) : built(scene, edges, cellMm, newWallLook(options));
  },
  marks(drag, context, isDown): readonly Mark[] {
    const { scene, options } = context;
    const cellMm = cellOf(options);
    const tap: Drag = isDown && !isTap(drag) ? drag : { ...drag, path: [endOf(drag)] };
    const [edge] = isTap(tap) ? tappedEdges(tap, context) : [];
    return [{ type: 'grid', cellMm, edge: edge ? endsOf(edge, cellMm, scene.size) : null }];
  },
  marksAtRest: ({ options }) => [{ type: 'grid', cellMm: cellOf(options), edge: null }],
};

/** The side of a cell in mm: never so small that a drag would pass thousands of edges. */
const cellOf = ({ mazeCell }: ToolOptions): number => Math.round(within(mazeCell, toolOptionRanges.mazeCell));

function tappedEdges(drag: Drag, { scene, options }: ToolContext): readonly GridEdge[] {
  const mazeCell = cellOf(options);
  const edge = nearestEdge(startOf(drag), mazeCell, scene.size, Math.max(drag.reachMm, TAP_WITHIN * mazeCell));
  return edge ? [edge] : [];
}

/** The length of the path along each edge, and the edges with enough of it, in their order. */
interface Travel {
  readonly mm: ReadonlyMap<string, number>;
  readonly edges: ReadonlyMap<string, GridEdge>;
}

/** How near an edge a drag follows it, and for how much of its length, both in cells. Chosen: crossing it is neither. */
const FOLLOWS_WITHIN = 0.3;
const FOLLOWS_FOR = 0.4;
/** The edge where the drag began needs less: one begins in its middle. */
const BEGINS_WITH = 0.15;

const edgesAlong = alongPath<Travel>({
  block: 16, // chosen: the maps are copied for every block
  start: () => ({ mm: new Map(), edges: new Map() }),
  after(travel, places, drag, { scene, options }) {
    const mm = new Map(travel.mm);
    const edges = new Map(travel.edges);
    const cellMm = cellOf(options);
    const begun = nearestEdge(startOf(drag), cellMm, scene.size, FOLLOWS_WITHIN * cellMm);
    const beginsWith = begun ? keyOf(begun) : null;
    for (const { at, dx, dy } of steps(places, cellMm, scene.size)) {
      const along = Math.abs(dx) >= Math.abs(dy) ? 'x' : 'y';
      const edge = edgeAlong(along, at, cellMm, scene.size, FOLLOWS_WITHIN * cellMm);
      if (!edge) continue;
      const key = keyOf(edge);
      const gone = (mm.get(key) ?? 0) + Math.max(Math.abs(dx), Math.abs(dy));
      mm.set(key, gone);
      const { from, to } = spanOf(edge, cellMm, scene.size);
      if (gone >= (key === beginsWith ? BEGINS_WITH : FOLLOWS_FOR) * (to - from) && !edges.has(key))
        edges.set(key, edge);
    }
    return { mm, edges };
  },
});

/** A path in short steps: the middle and the length of each. */
function* steps(
  places: readonly Vec[],
  cellMm: number,
  [width, height]: Point,
): Generator<{ readonly at: Vec; readonly dx: number; readonly dy: number }> {
  // Outside the arena there are no edges; far away is equivalent to just outside.
  const near = ({ x, y }: Vec): Vec => ({
    x: within(x, { min: -cellMm, max: width + cellMm }),
    y: within(y, { min: -cellMm, max: height + cellMm }),
  });
  for (let i = 1; i < places.length; i += 1) {
    const from = near(places[i - 1] ?? { x: 0, y: 0 });
    const to = near(places[i] ?? from);
    const count = Math.ceil((distanceMm(from, to) * STEPS_PER_CELL) / cellMm);
    const dx = (to.x - from.x) / count;
    const dy = (to.y - from.y) / count;
    for (let step = 0; step < count; step += 1)
      yield { at: { x: from.x + (step + 0.5) * dx, y: from.y + (step + 0.5) * dy }, dx, dy };
  }
}

const STEPS_PER_CELL = 10;

/** The edges of each grid line together. */
function byLine(edges: readonly GridEdge[]): readonly (readonly [GridEdge, ...GridEdge[]])[] {
  const lines = new Map<string, [GridEdge, ...GridEdge[]]>();
  for (const edge of edges) {
    const line = lines.get(lineKeyOf(edge));
    if (line) line.push(edge);
    else lines.set(lineKeyOf(edge), [edge]);
  }
  return [...lines.values()];
}

/** Puts walls on edges; what is in line with its neighbour becomes one wall. */
function built(scene: Scene, edges: readonly GridEdge[], cellMm: number, look: WallLook): SceneEdit | null {
  const freeId = freeIds(scene);
  const walls: Wall[] = [];
  const changes: Replacement[] = [];
  for (const line of byLine(edges)) {
    const [edge] = line;
    const there = wallsOn(scene, edge, cellMm);
    const at = edge.line * cellMm;
    const length = edge.along === 'x' ? scene.size[0] : scene.size[1];
    const out = overhangMm(look.thickness);
    const added = line
      .map((one) => spanOf(one, cellMm, scene.size))
      .filter((span) => !isTaken(span, there))
      .map(({ from, to }) => ({ from: Math.max(0, from - out), to: Math.min(length, to + out) }));
    // Only free walls that fit exactly can go on as one.
    const alike = there.filter(({ wall }) => !wall.lock && looksSo(wall, look) && liesAt(wall, edge, at));
    for (const { span, joins } of joinedSpans(added, alike)) {
      const ends = wallEndsAlong(edge, at, span);
      const [first, ...rest] = joins;
      if (first) changes.push({ id: first.wall.id, by: [{ ...first.wall, ...ends }] });
      else walls.push({ type: 'wall', id: freeId('wall'), ...ends, ...look });
      changes.push(...rest.map(({ wall }) => ({ id: wall.id, by: [] })));
    }
  }
  if (walls.length > roomIn(scene).objects) return null;
  return combined([replacing(changes), walls.length === 0 ? null : { type: 'add', objects: walls }]);
}

type WallLook = Pick<Wall, 'thickness' | 'height'>;

const looksSo = (wall: Wall, { thickness, height }: WallLook): boolean =>
  wall.thickness === thickness &&
  heightOf(wall) === heightOf({ type: 'wall', ...(height !== undefined && { height }) });

const liesAt = ({ from, to }: Wall, { along }: GridEdge, at: number): boolean =>
  along === 'x' ? from[1] === at && to[1] === at : from[0] === at && to[0] === at;

/** New stretches, each made one with those it touches and with the walls it touches. */
function joinedSpans(
  added: readonly Span[],
  walls: readonly LineWall[],
): readonly { readonly span: Span; readonly joins: readonly LineWall[] }[] {
  const all = [
    ...added.map((span) => ({ span, joins: [] as readonly LineWall[], isNew: true })),
    ...walls.map((wall) => ({ span: { from: wall.from, to: wall.to }, joins: [wall], isNew: false })),
  ].sort((a, b) => a.span.from - b.span.from);
  const groups: (typeof all)[number][] = [];
  for (const one of all) {
    const last = groups[groups.length - 1];
    if (!last || one.span.from > last.span.to) {
      groups.push(one);
      continue;
    }
    groups[groups.length - 1] = {
      span: { from: last.span.from, to: Math.max(last.span.to, one.span.to) },
      joins: [...last.joins, ...one.joins],
      isNew: last.isNew || one.isNew,
    };
  }
  return groups.filter(({ isNew }) => isNew);
}

/** Removes walls from edges; the rest of a wall that continues beyond them stays. */
function taken(scene: Scene, edges: readonly GridEdge[], cellMm: number): SceneEdit | null {
  const freeId = freeIds(scene);
  const changes: Replacement[] = [];
  let more = 0;
  for (const line of byLine(edges)) {
    const [edge] = line;
    const spans = line.map((one) => spanOf(one, cellMm, scene.size));
    for (const there of wallsOn(scene, edge, cellMm)) {
      const rest = there.wall.lock ? null : withoutSpans(there, spans);
      if (rest === null) continue;
      changes.push({ id: there.wall.id, by: pieces(there, rest, edge, freeId) });
      more += rest.length - 1;
    }
  }
  return more > roomIn(scene).objects ? null : replacing(changes);
}

function pieces({ wall }: LineWall, spans: readonly Span[], edge: GridEdge, freeId: IdSource): readonly Wall[] {
  const at = edge.along === 'x' ? wall.from[1] : wall.from[0];
  return spans.map((span, index) => ({
    ...wall,
    id: index === 0 ? wall.id : freeId('wall'),
    ...wallEndsAlong(edge, at, span),
  }));
}

/** Too short for the rest of a wall: hardly more than the overhang at a corner, in mm. */
const SHORT_REST_MM = 5;

/** The rests of a wall when stretches are removed, or `null` if they do not touch it. */
function withoutSpans({ wall, from, to }: LineWall, spans: readonly Span[]): readonly Span[] | null {
  const out = overhangMm(wall.thickness);
  let rest: readonly Span[] = [{ from, to }];
  let isCut = false;
  for (const gap of spans) {
    rest = rest.flatMap((piece) => {
      const covered = Math.min(piece.to, gap.to) - Math.max(piece.from, gap.from);
      if (covered <= out + SHORT_REST_MM) return [piece];
      isCut = true;
      const before = { from: piece.from, to: Math.min(piece.to, gap.from + out) };
      const after = { from: Math.max(piece.from, gap.to - out), to: piece.to };
      return [before, after].filter((left) => left.to - left.from > 2 * out + SHORT_REST_MM);
    });
  }
  return isCut ? rest : null;
}
