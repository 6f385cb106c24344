import { freeId } from '#check/task/read-checks';
import { plainWorld, type ClassTask, type WorldVariant } from '#check/task/task';
import { exactCos, exactSin } from '#core/exact-math';

/**
 * Differences of a new hidden world, so that it hides something. Chosen: what a careless hand puts down, and a robot
 * with some play. Along its heading, not aside: who follows a line still has it under the sensors.
 */
const ALONG_MM = 20;
const TURNED_DEG = 5;
const USED = 0.2;

/**
 * A new hidden world: another seed, and a robot that is not ideal and starts turned, in one world farther on, in the
 * next farther back.
 */
export function freshWorld(task: ClassTask): WorldVariant {
  const count = task.worlds.length;
  const side = count % 2 === 1 ? 1 : -1;
  const { robot, size } = task.project.scene;
  const headingRad = (robot.heading * Math.PI) / 180;
  const [x, y] = robot.at;
  const along = side * ALONG_MM;
  const within = (mm: number, most: number): number => Math.min(Math.max(Math.round(mm), 0), most);
  return {
    ...{ ...plainWorld, id: freeId(String(count + 1), task.worlds), hidden: true, seed: count, reality: USED },
    start: {
      at: [within(x + along * exactCos(headingRad), size[0]), within(y + along * exactSin(headingRad), size[1])],
      heading: (robot.heading + side * TURNED_DEG) % 360,
    },
  };
}

/** The start of a world's robot: the world's, else the course's. */
export const startOf = ({ project }: ClassTask, world: WorldVariant): NonNullable<WorldVariant['start']> =>
  world.start ?? project.scene.robot;
