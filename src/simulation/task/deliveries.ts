import type { Pose } from '#core/geometry';
import { zoneContains } from '#scene/kinds/zone';
import type { Outline } from '#scene/outline';
import type { PaintColor } from '#scene/paint/paint';
import type { Zone } from '#scene/scene';
import { ownOutline } from '#scene/shape/shape';
import type { BlockHandle } from '#world/shapes';
import { outlineAt } from './outline-at';
import type { TaskBrief } from './task-brief';

/** Counts the blocks that lie in targets. */
export interface Deliveries {
  /** Number of blocks delivered now: no more in each target than it wants, and each block once. */
  count(): number;
}

/** A movable block, and its state at the last look. */
interface Watched {
  readonly color: PaintColor | undefined;
  readonly block: BlockHandle;
  readonly corners: Outline;
  pose: Pose | null;
  held: boolean;
  /** The targets that contain it. */
  targets: readonly Zone[];
}

/** @param block finds a movable block of the run by its id */
export function createDeliveries(
  { blocks, blockTargets }: TaskBrief,
  block: (id: string) => BlockHandle | undefined,
): Deliveries {
  const watched = blocks.flatMap((object): Watched[] => {
    const found = block(object.id);
    return found
      ? [{ color: object.color, block: found, corners: ownOutline(object), pose: null, held: false, targets: [] }]
      : [];
  });
  let delivered = 0;
  return {
    count() {
      let hasChanged = false;
      for (const one of watched) {
        const pose = one.block.pose();
        const held = one.block.isHeld();
        if (held === one.held && one.pose !== null && isSame(pose, one.pose)) continue;
        one.pose = pose;
        one.held = held;
        const outline = outlineAt(one.corners, pose);
        const targets = held
          ? []
          : blockTargets.filter((target) => wants(target, one) && zoneContains(target, outline));
        // Nearly everything that moves does so outside all targets.
        if (targets.length === 0 && one.targets.length === 0) continue;
        one.targets = targets;
        hasChanged = true;
      }
      if (hasChanged) delivered = countIn(blockTargets, watched);
      return delivered;
    },
  };
}

/** True if blocks of this colour are to lie in a target. */
const wants = ({ blockColor }: Zone, { color }: Watched): boolean => blockColor === undefined || blockColor === color;

function countIn(targets: readonly Zone[], watched: readonly Watched[]): number {
  const counted = new Set<Watched>();
  for (const target of targets) {
    let room = target.blocks;
    for (const one of watched) {
      if (room === 0) break;
      if (counted.has(one) || !one.targets.includes(target)) continue;
      counted.add(one);
      room--;
    }
  }
  return counted.size;
}

/** True if two poses are the same to the last bit. */
export const isSame = (a: Pose, b: Pose): boolean =>
  a.xMm === b.xMm && a.yMm === b.yMm && a.headingRad === b.headingRad;
