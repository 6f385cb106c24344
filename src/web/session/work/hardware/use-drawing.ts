import { shallowRef, watch, type ShallowRef } from 'vue';

import { fetchDrawing, fetchedDrawing } from '#robots/drawings';
import type { RobotType } from '#robots/robot';

/** The drawing of a robot, which is fetched when the robot is first shown; `null` until it is there. */
export function useDrawing(robot: () => Pick<RobotType, 'id'> | null): Readonly<ShallowRef<string | null>> {
  const drawing = shallowRef<string | null>(null);
  const show = async (id: string): Promise<void> => {
    const fetched = await fetchDrawing(id).catch(() => null); // without a connection it is asked for at the next change
    if (robot()?.id === id) drawing.value = fetched;
  };
  watch(
    () => robot()?.id ?? null,
    (id) => {
      drawing.value = id === null ? null : fetchedDrawing(id);
      if (id !== null && drawing.value === null) void show(id);
    },
    { immediate: true },
  );
  return drawing;
}
