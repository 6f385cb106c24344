import { exactLog } from '#core/exact-exp';
import { exactCos, exactSin } from '#core/exact-math';
import type { EffectPart } from './effect';

/** Samples a second of what `renderEffect` makes: codal-microbit-v2 MicroBitAudio.cpp, the mixer's rate. */
export const EFFECT_RATE = 44_100;

/** Resolution of a period of the wave: codal-core Synthesizer.h, TONE_WIDTH. */
const TONE_WIDTH = 1024;
const NOISE_FACTOR = 7919; // codal-core Synthesizer.cpp: NoiseTone
const VOLUME_STEPS = 36; // codal-microbit-v2 SoundExpressions.cpp: the volume's ramp
const FULL_VOLUME = 1023;
const FX_TIME_MS = 10_000; // SoundExpressions.cpp: steps of vibrato and others are given for this time
const LOG_SCALE = 1.95; // SoundSynthesizerEffects.cpp: logarithmicInterpolation
const DEGREE = 3.14159 / 180;
const LN_10 = 2.302585092994046;

/** Intervals of scales as factors of the root: SoundSynthesizerEffects.cpp, MusicalIntervals. */
const CHROMATIC = [1, 1.0417, 1.125, 1.2, 1.25, 1.3333, 1.4063, 1.5, 1.6, 1.6667, 1.8, 1.875] as const;
const degrees = (...places: number[]): readonly number[] => places.map((place) => CHROMATIC[place] ?? 1);
const SCALES: Readonly<Record<number, readonly number[]>> = {
  8: degrees(0, 2, 4, 5, 7, 9, 11), // major
  10: degrees(0, 2, 3, 5, 7, 8, 10), // minor
  12: degrees(0, 3, 6, 9), // diminished
  14: CHROMATIC,
  16: degrees(0, 2, 4, 6, 8, 10), // whole tones
};

/** The state of the sound; each part hands it to the next. */
interface Oscillator {
  /** Place within the period, 0 … TONE_WIDTH. */
  position: number;
  hz: number;
  volume: number;
}

/** Something that changes in steps while a part sounds. */
interface Change {
  readonly steps: number;
  readonly apply: (step: number) => void;
}

/**
 * Makes samples of a sound effect, −1 … 1, at `EFFECT_RATE`, as the device's synthesiser does: in steps, with its own
 * deterministic noise. Source: codal-microbit-v2 SoundEmojiSynthesizer.cpp and SoundSynthesizerEffects.cpp.
 */
export function renderEffect(parts: readonly EffectPart[]): Float32Array {
  const counts = parts.map((part) => Math.floor((EFFECT_RATE * part.durationMs) / 1000));
  const samples = new Float32Array(counts.reduce((sum, count) => sum + count, 0));
  const oscillator: Oscillator = { position: 0, hz: 0, volume: 0 };
  let start = 0;
  parts.forEach((part, place) => {
    const count = counts[place] ?? 0;
    renderPart(part, oscillator, samples.subarray(start, start + count));
    start += count;
  });
  return samples;
}

function renderPart(part: EffectPart, oscillator: Oscillator, out: Float32Array): void {
  oscillator.hz = part.startHz;
  oscillator.volume = part.startVolume / FULL_VOLUME;
  const table = tableOf(part.waveform);
  const changes = [shapeChange(part, oscillator), volumeChange(part, oscillator), fxChange(part, oscillator)].filter(
    (change) => change !== null,
  );
  const next = changes.map(() => 0);
  // The last step of a change falls on the end of the part: it is inaudible.
  const dueAt = ({ steps }: Change, step: number): number =>
    step >= steps - 1 ? out.length : Math.floor((out.length / steps) * step);
  for (let i = 0; i < out.length;) {
    let until = out.length;
    changes.forEach((change, place) => {
      let step = next[place] ?? 0;
      while (dueAt(change, step) <= i) change.apply(step++);
      next[place] = step;
      until = Math.min(until, dueAt(change, step));
    });
    // Scales of many steps and falling curves leave the audible range, and the range of numbers.
    const skip = (TONE_WIDTH * Math.min(Math.max(oscillator.hz, 0), EFFECT_RATE / 2)) / EFFECT_RATE;
    const { volume } = oscillator;
    let { position } = oscillator;
    for (; i < until; i++) {
      out[i] = (table[Math.floor(position)] ?? 0) * volume;
      position += skip;
      while (position >= TONE_WIDTH) position -= TONE_WIDTH;
    }
    oscillator.position = position;
  }
}

/** One period, −1 … 1, by the place within it. */
const WAVES: readonly [Wave, ...Wave[]] = [
  (place) => -exactCos((2 * Math.PI * place) / TONE_WIDTH),
  (place) => place / 512 - 1,
  (place) => (place < 512 ? place / 256 - 1 : 3 - place / 256),
  (place) => (place < 512 ? 1 : -1),
  (place) => ((place * NOISE_FACTOR) & (TONE_WIDTH - 1)) / 512 - 1,
];
type Wave = (place: number) => number;

const tables = new Map<number, Float32Array>();

/** The period of a waveform as a table, made when it is first needed; an unknown one is a sine. */
function tableOf(waveform: number): Float32Array {
  const known = tables.get(waveform);
  if (known) return known;
  const wave = WAVES[waveform] ?? WAVES[0];
  const table = Float32Array.from({ length: TONE_WIDTH }, (_, place) => wave(place));
  tables.set(waveform, table);
  return table;
}

function shapeChange(part: EffectPart, oscillator: Oscillator): Change | null {
  const { startHz, endHz, shape } = part;
  const steps = Math.max(part.steps, 1);
  const set = (hzAt: (step: number) => number): Change => ({ steps, apply: (step) => (oscillator.hz = hzAt(step)) });
  const range = endHz - startHz;
  switch (shape) {
    case 1:
      return set((step) => startHz + (range / steps) * step);
    case 2:
      return set((step) => startHz + exactSin(step * DEGREE) * range);
    case 5:
      return set((step) => startHz + exactSin(step * DEGREE) * endHz);
    case 6:
      return set((step) => startHz + exactCos(step * DEGREE) * endHz);
    case 18:
      return set((step) => Math.max(0, startHz + (exactLog(Math.max(step, 1)) / LN_10 / LOG_SCALE) * range));
    default: {
      const scale = SCALES[shape - (shape % 2)];
      if (!scale) return null;
      return set((step) => startHz * interval(scale, shape % 2 === 0 ? step : steps - step - 1));
    }
  }
}

/** The factor of the n-th note of a scale, octave after octave. */
function interval(scale: readonly number[], n: number): number {
  let octaves = 1;
  for (let left = n; left >= scale.length; left -= scale.length) octaves *= 2;
  return octaves * (scale[n % scale.length] ?? 1);
}

function volumeChange({ startVolume, endVolume }: EffectPart, oscillator: Oscillator): Change {
  const step = (endVolume - startVolume) / VOLUME_STEPS;
  return {
    steps: VOLUME_STEPS,
    apply: (n) => (oscillator.volume = (startVolume + n * step) / FULL_VOLUME),
  };
}

function fxChange(part: EffectPart, oscillator: Oscillator): Change | null {
  const { fx, fxParameter, startHz } = part;
  const steps = Math.max(1, Math.floor((part.durationMs / FX_TIME_MS) * part.fxSteps));
  // Up with every odd step and down again with the next.
  const factor = (step: number): number =>
    step === 0 ? 1 : step % 2 === 0 ? 1 / Math.max(fxParameter, 1) : fxParameter;
  switch (fx) {
    case 1:
      return { steps, apply: (step) => (oscillator.hz *= factor(step)) };
    case 2:
      return { steps, apply: (step) => (oscillator.volume = Math.min(1, oscillator.volume * factor(step))) };
    case 3:
      return { steps, apply: (step) => (oscillator.hz = exactSin(step) * (fxParameter - startHz) + startHz) };
    default:
      return null;
  }
}
