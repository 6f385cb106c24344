import { shallowRef } from 'vue';

import { touchedBy, type Step } from '#scene/history';
import type { PlacedPose } from '#simulation/input';

/** Where the hand put robot and blocks while no run goes on; a reset, and every start, puts them back. */
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
    /** Whatever was changed in the course goes back to where the course has it. */
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
