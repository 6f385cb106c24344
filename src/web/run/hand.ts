import { shallowRef } from 'vue';

import type { Scene } from '#scene/scene';
import type { PlacedPose } from '#simulation/input';

/** Where the hand put robot and blocks before a run; a reset puts them back. */
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
    /** What was changed in the course is where the course says. */
    letGo: (before: Scene, after: Scene): void => {
      if (before.robot !== after.robot) pose.value = null;
      const ids = Object.keys(blocks.value);
      if (ids.length === 0) return;
      const objectIn = (scene: Scene, id: string) => scene.objects.find((object) => object.id === id);
      const kept = ids.filter((id) => objectIn(before, id) === objectIn(after, id));
      if (kept.length < ids.length) {
        blocks.value = Object.fromEntries(Object.entries(blocks.value).filter(([id]) => kept.includes(id)));
      }
    },
  };
}
