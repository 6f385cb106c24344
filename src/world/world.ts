import type { Pose, Vec } from '#core/geometry';
import type { Chassis, ChassisType } from './chassis';
import { createGround } from './ground/strokes';
import { createPhysics } from './physics/physics';
import type { RobotBody } from './physics/robot-body';
import { movingObstacle, nearestInCone, stillObstacle } from './probes/distance-cone';
import type { Cone, ConeHit, Obstacle } from './probes/distance-cone';
import { wallCorners } from './shapes';
import type { BlockHandle, BlockShape, StrokeShape, WallShape, WorldSize } from './shapes';

export type {
  Chassis,
  ChassisPart,
  ChassisType,
  Fork,
  ForkType,
  Gripper,
  GripperType,
  Wheel,
  WheelSide,
} from './chassis';
export type { DriveLaw } from './drive-law';
export type { Cone, ConeHit } from './probes/distance-cone';
export type { BlockHandle, BlockShape, StrokeShape, WallShape, WorldSize } from './shapes';
export { STEP_US } from './step';

/** The arena: floor, walls, blocks and robots, moving in steps of `STEP_US`. World frame: mm, x right, y up, origin lower left. */
export interface World {
  /** Throws RangeError when the wall has no length or no thickness. */
  addWall(wall: WallShape): void;
  /** Throws RangeError when a side is not above 0. */
  addBlock(block: BlockShape): BlockHandle;
  /** Draws on the floor; later strokes cover earlier ones. */
  addStroke(stroke: StrokeShape): void;
  addChassis(type: ChassisType, pose: Pose): Chassis;
  /** Moves everything on by `STEP_US`. */
  step(): void;
  /** Reflectance seen by a round spot on the floor, 0 (black) … 1 (bare floor); with its middle outside the arena 0. */
  reflectanceAt(spot: Vec, radiusMm: number): number;
  /**
   * What a distance sensor faces: the nearest point of walls, blocks and robots inside its cone.
   *
   * @param from place of the sensor; inside an obstacle the distance is 0
   * @param except the robot that carries the sensor
   */
  distanceCone(from: Vec, headingRad: number, cone: Cone, except?: Chassis): ConeHit;
}

/** Thickness in mm that the wall around the arena has for a beam. It only has to be there. */
const EDGE_MM = 1;

/**
 * Makes an arena with a solid wall around it. The order in which things are added is part of a run: the same order
 * gives the same trajectory, bit for bit.
 */
export function createWorld(size: WorldSize): World {
  const physics = createPhysics(size);
  const ground = createGround();
  const obstacles: { readonly obstacle: Obstacle; readonly chassis: Chassis | null }[] = [];
  const robots: RobotBody[] = [];
  const add = (obstacle: Obstacle, chassis: Chassis | null = null): number => obstacles.push({ obstacle, chassis });
  for (const wall of edges(size)) add(stillObstacle(wallCorners(wall)));

  return {
    addWall(wall) {
      const corners = wallCorners(wall);
      physics.addFixture(corners);
      add(stillObstacle(corners));
    },
    addBlock(block) {
      const body = physics.addBlock(block);
      add(movingObstacle(body.cornersMm, () => body.pose()));
      return body;
    },
    addStroke: (stroke) => ground.addStroke(stroke),
    addChassis(type, pose) {
      const chassis = physics.addRobot(type, pose);
      robots.push(chassis);
      for (const part of type.outlineMm)
        add(
          movingObstacle(part, () => chassis.pose()),
          chassis,
        );
      return chassis;
    },
    step: () => physics.step(),
    reflectanceAt({ x, y }, radiusMm) {
      if (!(x >= 0 && x <= size.widthMm && y >= 0 && y <= size.heightMm)) return 0;
      return ground.reflectanceAt(x, y, radiusMm);
    },
    distanceCone(from, headingRad, cone, except) {
      const others = obstacles.filter(({ chassis }) => chassis === null || chassis !== except);
      const added = robots.filter((robot) => robot !== except).flatMap(addedTo);
      return nearestInCone(from, headingRad, cone, [...others.map(({ obstacle }) => obstacle), ...added]);
    },
  };
}

/** What was added to a robot's body, for a beam. */
function addedTo(robot: RobotBody): Obstacle[] {
  return robot.addedOutlinesMm().map((outline) => movingObstacle(outline, () => robot.pose()));
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
