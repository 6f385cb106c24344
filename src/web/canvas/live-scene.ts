import type { RobotStart, Scene, SceneObject } from '#scene/scene';

/** A course while a run of it goes on: what of it is in the run, and what waits for the next start. */
export interface LiveScene {
  /** What the run knows: the course with walls, obstacles and size as they were at the start. */
  readonly scene: Scene;
  /** Objects of the course that the run does not have yet. */
  readonly waiting: readonly SceneObject[];
  /** Ids of objects that the run still has, and the course no more. */
  readonly leaving: ReadonlySet<string>;
  /** Where the next run starts, if that is another place than this one's. */
  readonly start: RobotStart | null;
  /** How large the arena is from the next start on, mm, if that is another size than this run's. */
  readonly size: Scene['size'] | null;
}

const nobody: ReadonlySet<string> = new Set();

/**
 * Tells what of a course a run has. Lines, zones, labels and blocks that can be pushed come into it at once; walls and
 * what else stands fixed, the arena's size and the robot's start wait for the next one.
 *
 * @param started the course as the run began with it, or `null`: there is no run
 */
export function liveScene(course: Scene, started: Scene | null): LiveScene {
  if (started === null || started === course)
    return { scene: course, waiting: [], leaving: nobody, start: null, size: null };
  const wanted = new Map(course.objects.filter(waitsForStart).map((object) => [object.id, object]));
  const standing = started.objects.filter(waitsForStart);
  const leaving = new Set<string>();
  for (const object of standing) {
    const wish = wanted.get(object.id);
    if (wish !== undefined && isSame(wish, object)) wanted.delete(object.id);
    else leaving.add(object.id);
  }
  const objects = [...standing, ...course.objects.filter((object) => !waitsForStart(object))];
  return {
    scene: { ...course, size: started.size, robot: started.robot, objects },
    waiting: [...wanted.values()],
    leaving,
    start: isSame(course.robot, started.robot) ? null : course.robot,
    size: isSame(course.size, started.size) ? null : course.size,
  };
}

/** Whether an object comes into a run at its start only. */
export function waitsForStart({ type }: SceneObject): boolean {
  return type === 'wall' || type === 'fixed-block' || type === 'spikes' || type === 'mover';
}

/** Plain data: what was changed and changed back is the same again. */
const isSame = (one: object, other: object): boolean => one === other || JSON.stringify(one) === JSON.stringify(other);

/** What is to be seen of the arena, mm: all of the run's, and all of the one that tools change already. */
export function shownSize({ scene, size }: LiveScene): Scene['size'] {
  return size === null ? scene.size : [Math.max(scene.size[0], size[0]), Math.max(scene.size[1], size[1])];
}
