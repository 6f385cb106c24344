import { shallowRef } from 'vue';

import { touchedBy, type Step } from '#scene/history';
import type { PlacedPose } from '#simulation/input';

/** Poses that the hand gave robot and blocks while there is no run; a reset, and every start, discards them. */
export type Hand = ReturnType<typeof createHand>;

/** Makes a hand that has moved nothing yet. */
export function createHand() {
  const pose = shallowRef<PlacedPose | null>(null);
  /** By the object's id. */
  const blocks = shallowRef<Readonly<Record<string, PlacedPose>>>({});
  return {
    pose,
    blocks,
    reset: (): void => {
      pose.value = null;
      blocks.value = {};
    },
    /** Discards the poses of everything that a step has changed in the course. */
    letGo: (step: Step): void => {
      const { objects, robot } = touchedBy(step);
      if (robot) pose.value = null;
      const held = Object.entries(blocks.value);
      if (held.length === 0) return;
      const touched = new Set(objects.map(({ id }) => id));
      const kept = held.filter(([id]) => !touched.has(id));
      if (kept.length < held.length) blocks.value = Object.fromEntries(kept);
    },
  };
}
