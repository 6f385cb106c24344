import { isSame } from '#core/same';
import type { RobotStart, Scene, SceneObject } from '#scene/scene';
import { pendingChanges } from '#simulation/at-once';
import { isLasting } from '#simulation/kinds';

/** A course while a run of it goes on: what of it is in the run, and what waits for the next start. */
export interface LiveScene {
  /** The course that the run knows, with walls, obstacles and size as they were at the start. */
  readonly scene: Scene;
  /** Objects of the course that the run does not have yet. */
  readonly waiting: readonly SceneObject[];
  /** Ids of objects that the run still has, and the course no more. */
  readonly leaving: ReadonlySet<string>;
  /** The start of the next run, if it differs from this one's. */
  readonly start: RobotStart | null;
  /** How large the arena is from the next start on, mm, if that is another size than this run's. */
  readonly size: Scene['size'] | null;
}

const nobody: ReadonlySet<string> = new Set();

/**
 * Finds out which parts of a course a run has, by the run's own rule (`pendingChanges`).
 *
 * @param started the course with which the run began, or `null` without a run
 */
export function liveScene(course: Scene, started: Scene | null): LiveScene {
  if (started === null || started === course)
    return { scene: course, waiting: [], leaving: nobody, start: null, size: null };
  const { coming, going, robot } = pendingChanges(started, course);
  const waiting = new Set(coming);
  const atOnce = course.objects.filter((object) => !isLasting(object) && !waiting.has(object));
  return {
    scene: {
      ...course,
      size: started.size,
      robot: started.robot,
      objects: [...started.objects.filter(isLasting), ...atOnce],
    },
    waiting: coming,
    leaving: new Set(going.map(({ id }) => id)),
    start: robot ? course.robot : null,
    size: isSame(course.size, started.size) ? null : course.size,
  };
}

/** The visible size of the arena, mm: the run's and the next one's, the larger along each side. */
export function shownSize({ scene, size }: LiveScene): Scene['size'] {
  return size === null ? scene.size : [Math.max(scene.size[0], size[0]), Math.max(scene.size[1], size[1])];
}
