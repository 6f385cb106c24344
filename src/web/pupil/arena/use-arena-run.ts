import { computed, shallowRef, type ShallowRef } from 'vue';

import type { Shifted } from '#scene/kinds/stuck-tags';
import type { Scene, SceneObject } from '#scene/scene';
import type { PlacedPose } from '#simulation/input';

import type { RunParts } from '../../session/run/parts';
import type { RobotStarts } from './others/use-starts';
import type { WorkParts } from '../../session/work/model/parts';

/** The scene that the arena shows and the actions of the hand, which change the run, never the course. */
export function useArenaRun(
  { run, work, hand }: Pick<RunParts, 'run' | 'hand'> & Pick<WorkParts, 'work'>,
  starts: Readonly<ShallowRef<RobotStarts>> = shallowRef([]),
) {
  /** The course, with robot and blocks where the hand put them, until the next start. */
  const shownScene = computed<Scene>(() => {
    const { pose, blocks } = hand;
    const start = starts.value[work.place.value] ?? null;
    const scene = start === null || work.place.value === 0 ? work.scene.value : { ...work.scene.value, robot: start };
    if (run.snapshot.value !== null) return scene;
    const objects = Object.keys(blocks.value).length === 0 ? scene.objects : scene.objects.map(inHand);
    if (pose.value === null) return objects === scene.objects ? scene : { ...scene, objects };
    const { xMm, yMm, headingDeg } = pose.value;
    return { ...scene, objects, robot: { ...scene.robot, at: [xMm, yMm], heading: headingDeg } };
  });

  /** Puts a block where the hand has put it, only for showing: poses of the hand are finer than those of a course. */
  function inHand(object: SceneObject): SceneObject & Shifted {
    const pose = object.type === 'block' ? hand.blocks.value[object.id] : undefined;
    if (object.type !== 'block' || pose === undefined) return object;
    return { ...object, at: [pose.xMm, pose.yMm], angle: pose.headingDeg, lay: object };
  }

  /** Resets a stopped run: its last picture would hide the hand's changes. */
  function prepare(): void {
    if (run.snapshot.value !== null) void run.reset();
  }

  function placeRobot(pose: PlacedPose): void {
    if (run.past.value !== null) return; // nothing can be moved while looking back
    if (run.isActive.value) {
      run.input({ type: 'place', pose });
      return;
    }
    prepare();
    hand.pose.value = pose;
  }

  function placeBlock({ id, ...pose }: PlacedPose & { readonly id: string }): void {
    if (run.past.value !== null) return;
    if (run.isActive.value) {
      run.input({ type: 'place-block', id, pose });
      return;
    }
    prepare();
    hand.blocks.value = { ...hand.blocks.value, [id]: pose };
  }

  return { shownScene, placeRobot, placeBlock };
}
