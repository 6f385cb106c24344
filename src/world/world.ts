import type { Pose, Vec } from '#core/geometry';
import { addedTo, type Stop } from '#core/stop';
import type { Chassis, ChassisType } from './chassis';
import { createPaintedFloor } from './ground/painted-floor';
import type { BlockBody } from './physics/block-body';
import { createPhysics } from './physics/physics';
import type { RobotBody } from './physics/robot-body';
import { createLight, type Eye, type Light } from './light/light';
import { movingObstacle, nearestInCone, stillObstacle } from './probes/distance-cone';
import type { Cone, ConeHit, Obstacle } from './probes/distance-cone';
import { nearestColor, type ColorHit } from './probes/nearest-color';
import { cameraAt, type Camera, type CameraView, type TagShape } from './probes/camera';
import { depthGrid, type DepthCell, type DepthView } from './probes/depth-grid';
import { circleRadiusMm, formParts } from './physics/form';
import { wallCorners } from './shapes';
import type {
  BarrierHandle,
  BlockHandle,
  BlockShape,
  BodyForm,
  FieldShape,
  FloorGrid,
  MoverHandle,
  MoverShape,
  Shares,
  StrokeHandle,
  StrokeShape,
  WallShape,
  WorldSize,
} from './shapes';

/** The arena: floor, walls, blocks and robots, moving in steps of `STEP_US`. World frame: mm, x right, y up, origin lower left. */
export interface World {
  /** Throws RangeError if the wall has no length or no thickness. */
  addWall(wall: WallShape): void;
  /** Adds a wall that can be opened; it is open. Throws RangeError as `addWall`. */
  addBarrier(wall: WallShape): BarrierHandle;
  /** Throws RangeError if a side is not above 0. */
  addBlock(block: BlockShape): BlockHandle;
  /** Removes a block, also from a robot that holds it. */
  removeBlock(block: BlockHandle): void;
  /** Throws RangeError if a side or the speed is not above 0. */
  addMover(mover: MoverShape): MoverHandle;
  /** Draws on the floor, on top of the present drawing. */
  addStroke(stroke: StrokeShape): StrokeHandle;
  /** Paints a field, under all strokes. */
  addField(field: FieldShape): StrokeHandle;
  /** Puts up a tag, which cameras see and nothing feels. */
  addTag(tag: TagShape): Stop;
  /** Lays a picture under strokes and fields, or removes it. Throws RangeError if its levels do not fit its cells. */
  setFloor(grid: FloorGrid | null): void;
  /** Calls something each time before strokes, fields or the picture change. */
  beforePaint(act: () => void): Stop;
  /**
   * @param nowUs clock of the program that drives it: each duty acts from the moment at which it is set, also within a
   *   step. It began with the world. Left out: from the next step on
   */
  addChassis(type: ChassisType, pose: Pose, nowUs?: () => number): Chassis;
  /** Moves everything on by `STEP_US`. */
  step(): void;
  /** Reflectance under a round spot on the floor, 0 (black) … 1 (bare floor); 0 if its middle is outside the arena. */
  reflectanceAt(spot: Vec, radiusMm: number): number;
  /** Shares of light under a round spot on the floor, each 1 on bare floor; 0 if its middle is outside the arena. */
  sharesAt(spot: Vec, radiusMm: number): Shares;
  /**
   * The nearest thing in a narrow beam and its colour; `null`: there is none in range. What has no colour is grey.
   *
   * @param except the robot that carries the sensor
   */
  colorAhead(from: Vec, headingRad: number, cone: Cone, except?: Chassis): ColorHit | null;
  /**
   * The reading of a distance sensor: the nearest point of walls, blocks, movers and robots inside its cone.
   *
   * @param from place of the sensor; inside an obstacle the distance is 0
   * @param except the robot that carries the sensor
   */
  distanceCone(from: Vec, headingRad: number, cone: Cone, except?: Chassis): ConeHit;
  /**
   * The picture of a multizone ranger: how far the nearest thing in each cell is, row by row from the upper left.
   *
   * @param from place of its lens
   * @param except the robot that carries it
   */
  depthGrid(from: Vec, headingRad: number, view: DepthView, except?: Chassis): readonly DepthCell[];
  /**
   * The sight of a camera, which looks only when its picture or tags are asked for.
   *
   * @param from place of its lens
   * @param except the robot that carries it
   */
  camera(from: Vec, headingRad: number, view: CameraView, except?: Chassis): Camera;
  /** Its light: that of the room, and lamps and tunnels that are added to it. */
  readonly light: Omit<Light, 'at'>;
  /** The light that an eye receives, in lx. Walls, blocks, movers and robots throw shadows. @param except see `depthGrid` */
  luxAt(eye: Eye, except?: Chassis): number;
}

/** Thickness in mm of the wall around the arena for a beam. Any value above 0 will do. */
const EDGE_MM = 1;

/** Radius of what a cell of a camera's picture sees of the floor. Chosen: nearly a point, so that colours do not mix. */
const POINT_MM = 0.5;

/** Height of the wall around the arena: chosen, as high as a wall of a course. */
const EDGE_HEIGHT_MM = 250;

/**
 * Makes an arena with a solid wall around it. The order in which things are added is part of a run: the same order
 * gives the same trajectory, bit for bit.
 */
export function createWorld(size: WorldSize): World {
  const physics = createPhysics(size);
  const [ground, light] = [createPaintedFloor(), createLight()];
  const tags = new Set<TagShape>();
  const point = ({ x, y }: Vec): Shares | null => (holds(size, { x, y }) ? ground.sharesAt(x, y, POINT_MM) : null);
  const solids: Solids = { things: edgesOf(size), barriers: [], blocks: new Map(), robots: [] };
  const { things, barriers, blocks, robots } = solids;
  const obstacles = (except: Chassis | undefined): Iterable<Obstacle> => obstaclesIn(solids, except);

  return {
    addWall(wall) {
      const corners = wallCorners(wall);
      physics.addFixture(corners, wall.id);
      things.push({ ...stillObstacle(corners, wall.heightMm), ...sharesOf(wall) });
    },
    addBarrier(wall) {
      const corners = wallCorners(wall);
      const barrier = physics.addBarrier(corners, wall.id);
      barriers.push({ barrier, obstacle: stillObstacle(corners, wall.heightMm) });
      return barrier;
    },
    addBlock(block) {
      const body = physics.addBlock(block);
      blocks.set(body, { body, obstacles: obstaclesOf(block, () => body.pose()) });
      return body;
    },
    removeBlock(block) {
      const found = blocks.get(block);
      if (!found) return;
      blocks.delete(block);
      physics.removeBlock(found.body);
    },
    addMover(shape) {
      const mover = physics.addMover(shape);
      things.push(...obstaclesOf(shape, () => mover.pose()));
      return mover;
    },
    addStroke: (stroke) => ground.addStroke(stroke),
    addField: (field) => ground.addField(field),
    addTag: (tag) => addedTo(tags, tag),
    setFloor: (grid) => ground.setFloor(grid),
    beforePaint: (act) => ground.beforePaint(act),
    addChassis(type, pose, nowUs) {
      const body = physics.addRobot(type, pose, nowUs);
      const { heightMm } = type;
      robots.push({ body, heightMm, parts: type.outlineMm.map((part) => movingObstacle(part, () => body.pose(), heightMm)) }); // prettier-ignore
      return body;
    },
    step: () => physics.step(),
    reflectanceAt: ({ x, y }, radiusMm) => (holds(size, { x, y }) ? ground.reflectanceAt(x, y, radiusMm) : 0),
    sharesAt: ({ x, y }, radiusMm) => (holds(size, { x, y }) ? ground.sharesAt(x, y, radiusMm) : [0, 0, 0]),
    colorAhead: (from, headingRad, cone, except) => nearestColor(from, headingRad, cone, obstacles(except)),
    depthGrid: (from, headingRad, view, except) => depthGrid(from, headingRad, view, obstacles(except)),
    camera: (from, headingRad, view, except) =>
      cameraAt(from, headingRad, view, { obstacles: obstacles(except), tags, floor: point }),
    distanceCone: (from, headingRad, cone, except) => nearestInCone(from, headingRad, cone, obstacles(except)),
    light,
    luxAt: (eye, except) => light.at(eye, () => obstacles(except)),
  };
}

/** Everything that a beam can meet. */
interface Solids {
  readonly things: Obstacle[];
  readonly barriers: { readonly barrier: BarrierHandle; readonly obstacle: Obstacle }[];
  readonly blocks: Map<BlockHandle, { readonly body: BlockBody; readonly obstacles: readonly Obstacle[] }>;
  readonly robots: { readonly body: RobotBody; readonly heightMm: number; readonly parts: readonly Obstacle[] }[];
}

function* obstaclesIn({ things, barriers, blocks, robots }: Solids, except: Chassis | undefined): Iterable<Obstacle> {
  yield* things;
  for (const { barrier, obstacle } of barriers) if (!barrier.isOpen) yield obstacle;
  for (const block of blocks.values()) yield* block.obstacles;
  for (const { body, parts, heightMm } of robots) {
    if (body === except) continue;
    yield* parts;
    yield* partsAddedTo(body, heightMm);
  }
}

const edgesOf = (size: WorldSize): Obstacle[] =>
  edges(size).map((wall) => stillObstacle(wallCorners(wall), EDGE_HEIGHT_MM));
/** True if a place is inside the arena. */
const holds = ({ widthMm, heightMm }: WorldSize, { x, y }: Vec): boolean =>
  x >= 0 && x <= widthMm && y >= 0 && y <= heightMm;

/** The colour of a solid, if it has one. */
const sharesOf = ({ shares }: { readonly shares?: Shares }): { readonly shares?: Shares } =>
  shares === undefined ? {} : { shares };

/** The convex parts of a block or a mover, for a beam. */
function obstaclesOf(form: BodyForm, pose: () => Pose): readonly Obstacle[] {
  const radiusMm = circleRadiusMm(form);
  const { heightMm = Infinity } = form;
  if (radiusMm !== null) return [{ cornersMm: [], radiusMm, heightMm, pose, ...sharesOf(form) }];
  return formParts(form).map((part) => ({ ...movingObstacle(part, pose, heightMm), ...sharesOf(form) }));
}

/** The parts added to a robot's body, for a beam. */
function partsAddedTo(robot: RobotBody, heightMm: number): Obstacle[] {
  return robot.addedOutlinesMm().map((outline) => movingObstacle(outline, () => robot.pose(), heightMm));
}

/** The inner faces of the wall around the arena, as thin walls just outside it. */
function edges({ widthMm: right, heightMm: top }: WorldSize): WallShape[] {
  const out = EDGE_MM / 2;
  const wall = (fromMm: Vec, toMm: Vec): WallShape => ({ fromMm, toMm, thicknessMm: EDGE_MM });
  return [
    wall({ x: right + out, y: 0 }, { x: right + out, y: top }),
    wall({ x: right, y: top + out }, { x: 0, y: top + out }),
    wall({ x: -out, y: top }, { x: -out, y: 0 }),
    wall({ x: 0, y: -out }, { x: right, y: -out }),
  ];
}
