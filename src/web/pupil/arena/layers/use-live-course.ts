import { computed, type ComputedRef } from 'vue';
import { radOf } from '#core/angle';
import type { Pose } from '#core/geometry';
import type { RobotStart, Scene } from '#scene/scene';
import type { Snapshot } from '#simulation/snapshot';
import { liveScene, type LiveScene } from '../picture/live-scene';

/** Sources of the picture of a course and its run. */
export interface LiveCourseSources {
  /** The course as shown without a run: with the things where the hand has put them. */
  readonly shown: () => Scene;
  /** The document. */
  readonly course: () => Scene;
  /** The course that the run began with, or `null`. */
  readonly started: () => Scene | null;
  readonly newest: () => Snapshot | null;
}

/** Follows which parts of the course are in the run; the same object as long as no course changes. */
export function useLiveCourse(sources: LiveCourseSources): ComputedRef<LiveScene> {
  const hasRun = computed(() => sources.newest() !== null);
  return computed(() => {
    const started = hasRun.value ? sources.started() : null;
    return liveScene(started === null ? sources.shown() : sources.course(), started);
  });
}

/** A robot nearer to its start than this is at its start: mm, rad. Chosen: its outline would only double its rim. */
const NEAR = { mm: 4, rad: 0.05 };

/** The start of the robot if it is elsewhere now: its outline is drawn there; else `null`. */
export function startElsewhere(start: RobotStart, now: Pose | null): RobotStart | null {
  if (now === null) return null;
  const apart = Math.hypot(now.xMm - start.at[0], now.yMm - start.at[1]);
  const turn = (now.headingRad - radOf(start.heading)) / (2 * Math.PI);
  const turnedRad = Math.abs(turn - Math.round(turn)) * 2 * Math.PI;
  return apart > NEAR.mm || turnedRad > NEAR.rad ? start : null;
}
