import { onScopeDispose, shallowRef, watch, type Ref, type ShallowRef } from 'vue';

import type { Snapshot } from '#simulation/snapshot';
import { Rows } from '#tape/rows/rows';
import type { Recording } from '../../session/run/recording';
import type { RunModel } from '../../session/run/run-model';
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
  const { rows, marks, endUs } = useRows(run, () => {
    if (taped !== null && taped === run.past.value) show(atUs.value); // now it is known better
  });
  const atUs = shallowRef(run.nowUs.value);
  const playing = shallowRef<-1 | 0 | 1>(0);
  let frame = 0;
  /** The moment that is shown, if it is one of the tape's. */
  let taped: Snapshot | null = null;

  function show(timeUs: number, exact?: Snapshot): void {
    atUs.value = Math.min(Math.max(timeUs, 0), endUs.value);
    const moment = exact ?? rows().at(atUs.value);
    if (moment === null || run.past.value === null) return;
    run.look.show(moment);
    taped = exact === undefined ? moment : null;
    run.trails.lookAt(moment.timeUs);
    if (atUs.value >= (run.recording.value.asked.value?.timeUs ?? 0)) run.recording.value.ask(null);
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
      run.recording.value.ask(null);
      play(0);
      show(timeUs);
    },
  };
}

/** Longest stretch of unpacking without a rest, in ms of wall time: half a frame. */
const SLICE_MS = 8;

/** A tape that is being unpacked. */
interface Unpacked {
  readonly of: Recording;
  readonly pieces: Recording['pieces'];
  readonly rows: Rows<Snapshot>;
  readonly found: Marks;
  taken: number;
}

const unpackingOf = (of: Recording): Unpacked => ({
  ...{ of, pieces: of.pieces, taken: 0 },
  rows: new Rows<Snapshot>(MOST_BYTES),
  found: new Marks(of.setup?.devices.length ?? 1),
});

/**
 * The moments of the run's recording, unpacked as they come, in slices.
 *
 * @param onOthers called when other pieces of the same run have taken the place of those so far
 */
function useRows(run: RunModel, onOthers: () => void) {
  let next = unpackingOf(run.recording.value);
  let shown = next;
  /** Counts the calls of `unpack`: after a rest an older one finds that a newer one has begun. */
  let turn = 0;
  const endUs = shallowRef(run.nowUs.value);
  const marks = shallowRef<readonly Mark[]>([]);
  function publish(): void {
    if (shown.rows.endUs >= 0) endUs.value = shown.rows.endUs;
    marks.value = [...shown.found.all];
  }
  async function unpack(recording: Recording): Promise<void> {
    const mine = ++turn;
    if (next.pieces !== recording.pieces) next = unpackingOf(recording);
    if (shown.of !== recording) shown = next; // else those so far are shown until all others are there
    let sinceMs = performance.now();
    while (next.taken < next.pieces.length) {
      const chunk = next.rows.push(next.pieces[next.taken++] ?? new Uint8Array());
      if (chunk !== null) next.found.add(chunk);
      if (performance.now() - sinceMs < SLICE_MS) continue;
      if (shown === next) publish();
      await new Promise((rested) => setTimeout(rested));
      if (mine !== turn) return;
      sinceMs = performance.now();
    }
    const isOther = shown !== next;
    shown = next;
    publish();
    if (isOther) onOthers();
  }
  watch([run.recording, () => run.recording.value.count.value], ([recording]) => void unpack(recording), {
    immediate: true,
  });
  onScopeDispose(() => (turn += 1));
  return { rows: () => shown.rows, marks, endUs };
}
