import { computed } from 'vue';

import type { Scene } from '#scene/scene';
import type { PlacedPose } from '#simulation/input';

import type { App } from './use-app';

/** What the arena shows and what the hand does in it: it changes the run, never the course. */
export function useArenaRun({ run, work, hand }: Pick<App, 'run' | 'work' | 'hand'>) {
  /** The course, with the robot where the hand put it before the run. */
  const shownScene = computed<Scene>(() => {
    const pose = hand.pose.value;
    const scene = work.scene.value;
    if (pose === null || run.snapshot.value !== null) return scene;
    return { ...scene, robot: { ...scene.robot, at: [pose.xMm, pose.yMm], heading: pose.headingDeg } };
  });

  function placeRobot(pose: PlacedPose): void {
    if (run.isActive.value) {
      run.input({ type: 'place', pose });
      return;
    }
    // Without a run the hand says where the next one starts; the last picture of a stopped run would stand in the way.
    if (run.snapshot.value !== null) void run.reset();
    hand.pose.value = pose;
  }

  function placeBlock({ id, ...pose }: PlacedPose & { readonly id: string }): void {
    run.input({ type: 'place-block', id, pose });
  }

  return { shownScene, placeRobot, placeBlock };
}
