import type { Vec } from '#core/geometry';
import { distanceMm } from './plane';
import type { Drag } from './tools/tool';

/** Start of a drag. */
export function startOf({ path }: Drag): Vec {
  return path[0] ?? { x: 0, y: 0 };
}

/** Present place of a drag. */
export function endOf({ path }: Drag): Vec {
  return path[path.length - 1] ?? { x: 0, y: 0 };
}

/**
 * True if a drag never went far enough to be more than a tap: a finger always moves a little. Once it has, it stays a
 * drag even if it comes back.
 */
export function isTap({ path, reachMm }: Drag): boolean {
  const [start] = path;
  if (start === undefined) return true;
  const slackMm = reachMm / 2; // chosen: 4 px of a mouse, 11 px of a finger at the usual reaches
  // From the end, since a drag is far away there most of the time.
  for (let i = path.length - 1; i > 0; i -= 1) {
    const place = path[i];
    if (place !== undefined && distanceMm(start, place) > slackMm) return false;
  }
  return true;
}
