import { computed, onScopeDispose, watch, type ComputedRef } from 'vue';

import type { App } from './use-app';

/** Loudness of the tone, 0 … 1: a square wave is shrill, and there may be twenty of them in the room. */
const LOUDNESS = 0.04;
/** Time constant of switching on and off, in s: without it every note clicks. */
const SMOOTH_S = 0.005;
/** Silence after which the sound system is put to sleep, in ms: awake it costs a weak tablet a few percent all the time. */
const SLEEP_AFTER_MS = 3000;

/** What sounds: one oscillator, like the board's one speaker pin. */
interface Voice {
  readonly context: AudioContext;
  readonly oscillator: OscillatorNode;
  readonly gain: GainNode;
}

/** The tone that the run makes now, in Hz, whether it is heard or not; 0: none. */
export function useTone({ run }: Pick<App, 'run'>): ComputedRef<number> {
  return computed(() => (run.phase.value === 'running' ? (run.snapshot.value?.sound?.hz ?? 0) : 0));
}

/** Lets the tone of the run be heard, unless muted. */
export function useSound({ run, settings }: Pick<App, 'run' | 'settings'>): void {
  let voice: Voice | null = null;
  let sleep: ReturnType<typeof setTimeout> | undefined;
  const tone = useTone({ run });
  const muted = computed(() => settings.current.value.muted);
  const heard = computed(() => (muted.value ? 0 : tone.value));

  /** Browsers let sound begin only inside a tap or a key press: the one that starts a run or unmutes. */
  function wake(): void {
    voice ??= createVoice();
    if (voice?.context.state === 'suspended') voice.context.resume().catch(() => undefined);
    rest();
  }
  function rest(): void {
    clearTimeout(sleep);
    sleep = setTimeout(() => void voice?.context.suspend().catch(() => undefined), SLEEP_AFTER_MS);
  }
  watch(
    () => run.phase.value === 'starting' && !muted.value,
    (starts) => {
      if (starts) wake();
    },
    { flush: 'sync' },
  );
  watch(heard, (hz) => {
    if (hz > 0) wake();
    if (voice === null) return;
    const { context, oscillator, gain } = voice;
    if (hz > 0) {
      clearTimeout(sleep);
      oscillator.frequency.setValueAtTime(Math.min(hz, context.sampleRate / 2), context.currentTime);
    } else {
      rest();
    }
    gain.gain.setTargetAtTime(hz > 0 ? LOUDNESS : 0, context.currentTime, SMOOTH_S);
  });
  onScopeDispose(() => {
    clearTimeout(sleep);
    void voice?.context.close();
  });
}

function createVoice(): Voice | null {
  try {
    const context = new AudioContext();
    const oscillator = context.createOscillator();
    const gain = context.createGain();
    oscillator.type = 'square'; // what a PWM pin puts out
    gain.gain.value = 0;
    oscillator.connect(gain).connect(context.destination);
    oscillator.start();
    return { context, oscillator, gain };
  } catch {
    return null; // a machine without sound runs all the same
  }
}
