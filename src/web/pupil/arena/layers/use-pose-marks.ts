import { onBeforeUnmount, onMounted, watch } from 'vue';
import type { ArenaRobot } from '../model/arena-model';
import { degreesOf } from '../picture/arranged';

/** Shortest interval between changes of the marks, in ms: short enough for observers, too long to cost a frame. */
const RENEW_MS = 100;

/** Writes the robot's place onto `element` as data-x-mm, data-y-mm and data-heading-deg, with one decimal each. */
export function usePoseMarks(element: () => HTMLElement | null, robot: () => ArenaRobot | null): void {
  let timer: ReturnType<typeof setTimeout> | null = null;
  const renew = (): void => {
    timer = null;
    const data = element()?.dataset;
    if (data !== undefined) Object.assign(data, poseMarks(robot()));
  };
  watch(robot, () => (timer ??= setTimeout(renew, RENEW_MS)));
  onMounted(renew);
  onBeforeUnmount(() => {
    if (timer !== null) clearTimeout(timer);
  });
}

/** The marks: mm in the arena, degrees counter-clockwise from +x, more than −180 up to 180; empty without a robot. */
export function poseMarks(robot: ArenaRobot | null): Readonly<Record<'xMm' | 'yMm' | 'headingDeg', string>> {
  if (robot === null) return { xMm: '', yMm: '', headingDeg: '' };
  const { xMm, yMm, headingRad } = robot.pose;
  return { xMm: tenths(xMm), yMm: tenths(yMm), headingDeg: tenths(degreesOf(headingRad, 10)) };
}

/** One decimal; zero never has a sign. */
const tenths = (value: number): string => (Math.round(value * 10) / 10 + 0).toFixed(1);
