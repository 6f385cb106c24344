import { computed, onScopeDispose, shallowRef, watch, type ShallowRef } from 'vue';

import type { RunParts } from '../../session/run/parts';
import { useHardware } from '../../session/work/hardware/use-hardware';
import type { WorkParts } from '../../session/work/model/parts';
import { createNarrator, type Narrator } from './narrator';
import type { Surroundings } from './sentences';

/** Interval at which the narrator is asked for something to say, in ms. */
const ASK_MS = 200;

/** Pause of other announcements after the answer to exploring by keyboard (N, O), in ms. Chosen: ten words. */
const ANSWER_MS = 3600;

/** Something that was said. The same words again are something new. */
export interface Said {
  readonly count: number;
  readonly words: string;
}

/**
 * Announces the runs, one sentence after the other.
 *
 * @param begin the words that are said first
 */
export function useNarration(app: Pick<RunParts, 'run'> & WorkParts, begin: () => string): Readonly<ShallowRef<Said>> {
  const { run, work } = app;
  const hardware = useHardware(app);
  const said = shallowRef<Said>({ count: 0, words: '' });
  const tell = (words: string): void => void (said.value = { count: said.value.count + 1, words });
  const body = computed(() => {
    const { scale } = work.scene.value.robot;
    const parts = hardware.value?.robot?.body.outlineMm ?? [];
    return parts.map((part) => part.map(({ x, y }) => ({ x: x * scale, y: y * scale })));
  });
  const around = (): Surroundings => ({ scene: work.scene.value, body: body.value });
  let narrator: Narrator | null = null;
  let timer: ReturnType<typeof setInterval> | undefined;

  function ask(): void {
    const nowMs = performance.now();
    const snapshot = run.shown.value;
    if (run.phase.value === 'running' && snapshot !== null) narrator?.see(snapshot, nowMs);
    const words = narrator?.next(nowMs) ?? null;
    if (words !== null) tell(words);
    if (run.phase.value !== 'running' && narrator?.isWaiting !== true) clearInterval(timer);
  }
  function askOften(): void {
    clearInterval(timer);
    timer = setInterval(ask, ASK_MS);
  }

  watch(run.shown, (snapshot) => {
    if (snapshot === null || run.phase.value !== 'running') return;
    narrator ??= createNarrator(around);
    narrator.see(snapshot, performance.now());
  });
  watch(run.ended, () => narrator?.letSpeak(performance.now())); // the page says how the program has ended
  watch(
    run.phase,
    (phase, before) => {
      if (phase === 'ready') narrator = null;
      if (phase === 'starting') narrator = createNarrator(around);
      // The page itself says that the run has begun, makes a pause or has stopped.
      narrator?.letSpeak(performance.now());
      if (phase === 'paused') narrator?.pause();
      if ((phase === 'stopped' || phase === 'killed') && before !== undefined) narrator?.end(performance.now());
      if (phase === 'running' || phase === 'stopped' || phase === 'killed') askOften();
    },
    { immediate: true },
  );
  setTimeout(() => tell(begin())); // a region that is there before its words is heard
  const hearKey = ({ key, target }: KeyboardEvent): void => {
    const isInArena = target instanceof Element && target.closest('[role="application"]') !== null;
    if (isInArena && /^[no]$/i.test(key)) narrator?.letSpeak(performance.now(), ANSWER_MS);
  };
  addEventListener('keydown', hearKey);
  onScopeDispose(() => {
    removeEventListener('keydown', hearKey);
    clearInterval(timer);
  });
  return said;
}
