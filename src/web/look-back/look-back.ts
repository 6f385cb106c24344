import { onScopeDispose, shallowRef, watch, type Ref, type ShallowRef } from 'vue';

import type { Snapshot } from '#simulation/snapshot';
import { RecordedRows } from '../run/recorded-rows';
import type { RunModel } from '../run/run-model';
import { Marks, type Mark } from './marks';

/** Above this size of a tape its older moments are thinned. Chosen: an hour and a half of one device. */
const MOST_BYTES = 2_000_000;

/** The moment that is looked at, and the way through time. */
export interface LookBack {
  readonly atUs: Readonly<Ref<number>>;
  readonly endUs: Readonly<ShallowRef<number>>;
  readonly marks: Readonly<ShallowRef<readonly Mark[]>>;
  /** −1 backwards, 1 forwards, 0 standing. */
  readonly playing: Readonly<ShallowRef<-1 | 0 | 1>>;
  /** Shows the moment at a time, as far as there is one. */
  seek(timeUs: number): void;
  /** Lets time pass on the screen, at the chosen speed, or stops it. */
  play(direction: -1 | 0 | 1): void;
}

/** Looks back at a run for as long as the component lives: `run.past` is what it looks at. */
export function useLookBack(run: RunModel, speed: () => number): LookBack {
  const { rows, marks, endUs } = useRows(run);
  const atUs = shallowRef(run.nowUs.value);
  const playing = shallowRef<-1 | 0 | 1>(0);
  let frame = 0;

  function show(timeUs: number, exact?: Snapshot): void {
    atUs.value = Math.min(Math.max(timeUs, 0), endUs.value);
    const moment = exact ?? rows().at(atUs.value);
    if (moment === null || run.past.value === null) return;
    run.past.value = moment;
    run.trails.lookAt(moment.timeUs);
    if (atUs.value >= (run.recording.value.asked.value?.timeUs ?? 0)) run.recording.value.asked.value = null;
  }
  // The tape may have to bring that moment first.
  watch(
    [() => run.recording.value.asked.value, endUs],
    ([asked]) => {
      if (asked === null) return;
      play(0);
      show(asked.timeUs, asked.exact);
    },
    { immediate: true },
  );
  function play(direction: -1 | 0 | 1): void {
    cancelAnimationFrame(frame);
    playing.value = direction;
    if (direction === 0) return;
    if (direction === 1 && atUs.value >= endUs.value) show(0);
    let last = performance.now();
    const next = (nowMs: number): void => {
      show(atUs.value + direction * speed() * (nowMs - last) * 1000);
      last = nowMs;
      if (direction === 1 ? atUs.value >= endUs.value : atUs.value <= 0) playing.value = 0;
      else frame = requestAnimationFrame(next);
    };
    frame = requestAnimationFrame(next);
  }
  onScopeDispose(() => {
    cancelAnimationFrame(frame);
    run.trails.lookAt(null);
  });
  return {
    ...{ atUs, endUs, marks, playing },
    play,
    seek(timeUs) {
      run.recording.value.asked.value = null;
      play(0);
      show(timeUs);
    },
  };
}

/** The moments of the run's recording, unpacked as they come. */
function useRows(run: RunModel) {
  let found = new Marks(1);
  const recorded = new RecordedRows(
    {
      begin: ({ setup }) => (found = new Marks(setup?.devices.length ?? 1)),
      chunk: (chunk) => found.add(chunk),
    },
    MOST_BYTES,
  );
  const endUs = shallowRef(run.nowUs.value);
  const marks = shallowRef<readonly Mark[]>([]);
  watch(
    [run.recording, () => run.recording.value.count.value],
    ([recording]) => {
      const rows = recorded.of(recording);
      if (rows.endUs >= 0) endUs.value = rows.endUs;
      marks.value = [...found.all];
    },
    { immediate: true },
  );
  return { rows: () => recorded.of(run.recording.value), marks, endUs };
}
