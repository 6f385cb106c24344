import { onBeforeUnmount, onMounted, shallowRef, watch, type ShallowRef } from 'vue';
import type { ArenaRobot } from './model/arena-model';
import { summaryOf, type ArenaSummary } from './picture/arranged';

/**
 * Shortest time between changes of the text about the robot, in ms: a screen reader must be able to finish a sentence.
 */
const RENEW_MS = 1000;

/** The figures about the robot as text needs them, renewed at most once a second. */
export function useSummary(robot: () => ArenaRobot | null): Readonly<ShallowRef<ArenaSummary | null>> {
  const summary = shallowRef<ArenaSummary | null>(null);
  let timer: ReturnType<typeof setTimeout> | null = null;
  const renew = (): void => {
    timer = null;
    summary.value = summaryOf(robot());
  };
  watch(robot, () => (timer ??= setTimeout(renew, RENEW_MS)));
  onMounted(renew);
  onBeforeUnmount(() => {
    if (timer !== null) clearTimeout(timer);
  });
  return summary;
}
