import type { RobotStart, Scene } from '#scene/scene';

/** The parts of the course that are shown elsewhere while a tool holds them. */
export interface HeldParts {
  readonly hidden: ReadonlySet<string>;
  /** Proposed start of the robot. */
  readonly start: RobotStart | null;
}

/** The ghost while no tool holds anything. */
export const noGhost: HeldParts = { hidden: new Set(), start: null };

/** True if both ghosts are the same. */
export function isSameGhost(one: HeldParts, other: HeldParts): boolean {
  if (one.start !== other.start || one.hidden.size !== other.hidden.size) return false;
  for (const id of one.hidden) if (!other.hidden.has(id)) return false;
  return true;
}

/** The effect of a tool on the course: changed objects as they would be, and the ids of changed or removed ones. */
export interface GhostObjects {
  readonly shown: Scene['objects'];
  readonly hidden: ReadonlySet<string>;
}

/** Separates the objects of an edit from those that it leaves alone. */
export function ghostObjects(before: Scene, after: Scene | null): GhostObjects {
  if (after === null || after.objects === before.objects) return { shown: [], hidden: noGhost.hidden };
  const known = new Set(before.objects);
  const left = new Set(after.objects);
  return {
    shown: after.objects.filter((object) => !known.has(object)),
    hidden: new Set(before.objects.filter((object) => !left.has(object)).map(({ id }) => id)),
  };
}

/** The ghost of a course that would become another. */
export const ghostOf = (hidden: ReadonlySet<string>, course: Scene, after: Scene | null): HeldParts => {
  const start = after === null || after.robot === course.robot ? null : after.robot;
  return hidden.size === 0 && start === null ? noGhost : { hidden, start };
};
