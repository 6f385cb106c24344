import type { Scene } from '#scene/scene';
import type { CourseWorld } from '../course/course-world';
import type { Device } from '../device';
import type { FittedDevice } from '../fit-devices';
import { scaledBody } from '../scaled-body';
import { Judge } from './judge';
import { spikedIds } from './task-brief';

/** The judge of a run; `null` where no device has a robot. */
export function judgeOf(
  course: Scene,
  devices: readonly Device[],
  fitted: readonly FittedDevice[],
  world: CourseWorld,
): Judge | null {
  const scaleOf = (place: number): number => fitted[place]?.start.scale ?? 1;
  const robots = devices.flatMap(({ name, mounted }, place) =>
    mounted === null
      ? []
      : [{ device: name, chassis: mounted.chassis, body: scaledBody(mounted.type.body, scaleOf(place)).outlineMm }],
  );
  if (robots.length === 0) return null;
  return new Judge(course, { robots, block: (id) => world.block(id), spiked: spikedIds(course) });
}
