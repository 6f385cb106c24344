import { computed, onScopeDispose, shallowRef, watch, type ComputedRef } from 'vue';

import type { SensorInfo } from './sensor-list';
import { slowly } from '../../../kit/slowly';
import { steady } from '../../../kit/steady';
import type { RunParts } from '../../../session/run/parts';

/** How long a value set by hand is shown before the run's own value counts again, in ms of a running run. */
const SETTLE_MS = 500; // chosen: several pictures come back within it, also from a slow tablet

/** The present values of the sensors: the run's while there is one, else what the next run starts with. */
export interface SensorValues {
  number(id: string): number;
  set(id: string, value: number): void;
  reset(): void;
  /** True if a value was set by hand. */
  readonly isChanged: ComputedRef<boolean>;
}

/** The values for a panel that is open. What the hand just set is shown at once, before the run has taken it in. */
export function useSensorValues(app: Pick<RunParts, 'run' | 'sensors'>, infos: readonly SensorInfo[]): SensorValues {
  const { run, sensors } = app;
  const told = slowly(
    steady<Readonly<Record<string, number | string>>>(() =>
      run.isActive.value ? (run.shown.value?.sensors ?? {}) : {},
    ),
  );
  const fresh = shallowRef<Readonly<Record<string, number>>>({});
  let timer: ReturnType<typeof setTimeout> | undefined;
  const starts = new Map(infos.flatMap((info) => (info.kind === 'range' ? [[info.id, info.start] as const] : [])));

  function settle(): void {
    clearTimeout(timer);
    if (run.phase.value === 'paused') return; // a run that stands still has not taken it in
    timer = setTimeout(() => (fresh.value = {}), SETTLE_MS);
  }
  watch(run.phase, settle);
  onScopeDispose(() => clearTimeout(timer));

  const planned = (id: string): number => sensors.wishes.value[id] ?? starts.get(id) ?? 0;
  return {
    number: (id) => {
      const live = told.value[id];
      return fresh.value[id] ?? (typeof live === 'number' ? live : planned(id));
    },
    set: (id, value) => {
      if (!sensors.set(id, value)) return;
      fresh.value = { ...fresh.value, [id]: value };
      settle();
    },
    reset: () => {
      fresh.value = Object.fromEntries(starts);
      sensors.reset(starts);
      if (run.shown.value?.arenaSenses === true) run.input({ type: 'arena-senses', on: true }); // all of them again
      settle();
    },
    isChanged: computed(() => Object.keys(sensors.wishes.value).length > 0),
  };
}
