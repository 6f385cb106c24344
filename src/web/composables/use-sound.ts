import { onScopeDispose, watch } from 'vue';

import type { App } from './use-app';

/** Loudness of the tone, 0 … 1: a square wave is shrill, and there may be twenty of them in the room. */
const LOUDNESS = 0.04;
/** Time constant of switching on and off, in s: without it every note clicks. */
const SMOOTH_S = 0.005;

/** What sounds: one oscillator, like the board's one speaker pin. */
interface Voice {
  readonly context: AudioContext;
  readonly oscillator: OscillatorNode;
  readonly gain: GainNode;
}

/** Lets the tone of the run be heard, unless muted. The first run is a tap or a key, which browsers ask for before sound. */
export function useSound({ run, settings }: Pick<App, 'run' | 'settings'>): void {
  let voice: Voice | null = null;
  watch(
    () => {
      const audible = run.phase.value === 'running' && !settings.current.value.muted;
      return audible ? (run.snapshot.value?.sound?.hz ?? 0) : 0;
    },
    (hz) => {
      if (hz > 0) voice ??= createVoice();
      if (voice === null) return;
      const { context, oscillator, gain } = voice;
      if (context.state === 'suspended') void context.resume();
      if (hz > 0) oscillator.frequency.setValueAtTime(Math.min(hz, context.sampleRate / 2), context.currentTime);
      gain.gain.setTargetAtTime(hz > 0 ? LOUDNESS : 0, context.currentTime, SMOOTH_S);
    },
  );
  onScopeDispose(() => void voice?.context.close());
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
