import { robotColors } from '#scene/scene';
import { startsIn } from '#simulation/several/starts';

import type { WorkParts } from '../model/parts';
import { hardwareNow } from './use-hardware';

/**
 * The colour of each device by its place, as its number among `robotColors`: that of its robot's start in the course, or
 * the one that has its own number.
 */
export function colorsOfDevices(parts: WorkParts): readonly number[] {
  const starts = startsIn(parts.work.scene.value.objects);
  let robots = 0;
  return parts.work.devices.value.map((_, place) => {
    if (starts.length === 0 || (hardwareNow(parts, place)?.robot ?? null) === null) return place;
    const color = robots === 0 ? null : (starts[robots - 1]?.color ?? null);
    robots++;
    return color === null ? place : robotColors.indexOf(color);
  });
}
