import { robotColors } from '#scene/scene';
import { startsIn } from '#simulation/several/starts';

import type { WorkParts } from '../model/parts';
import { hardwareNow } from './use-hardware';

/**
 * The colour of each device by its place, as an index of `robotColors`: that of its robot's start in the course, or
 * else its own place.
 */
export function colorsOfDevices(parts: WorkParts): readonly number[] {
  const { robot, objects } = parts.work.scene.value;
  const starts = startsIn(objects);
  const isAnyColored = starts.length > 0 || robot.color !== undefined;
  let robots = 0;
  return parts.work.devices.value.map((_, place) => {
    if (!isAnyColored || (hardwareNow(parts, place)?.robot ?? null) === null) return place;
    const color = (robots === 0 ? robot : starts[robots - 1])?.color ?? null;
    robots++;
    return color === null ? place : robotColors.indexOf(color);
  });
}
