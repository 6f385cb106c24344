/**
 * The attachments as seen from above, one SVG document each. Loaded on demand: only code that shows one needs it.
 *
 * Rules: 1 unit = 1 mm of the real robot, front up, origin where it is fixed to the robot (`mountMm`); `viewBox` around
 * everything. The groups right below the root are its parts. Those named like a part of the attachment's pose move:
 * - `jaw-left`, `jaw-right` turn about their `data-pivot`, "x y"; `data-rest` is how far, in degrees counter-clockwise,
 *   they are turned while nothing runs;
 * - `fork` is raised;
 * - `sonar` represents the distance sensor: a robot with a sensor of its own turns that one instead. All other groups
 *   are fixed.
 */
import claw from './claw/claw.svg?raw';
import forklift from './forklift/forklift.svg?raw';
import loader from './loader/loader.svg?raw';
import push from './push/push.svg?raw';

/** By the id of the attachment. */
export const attachmentDrawings: Readonly<Record<string, string>> = { claw, forklift, loader, push };
