import { exactExp } from '#core/exact-exp';
import { exactCos } from '#core/exact-math';
import { createRng } from '#core/rng';
import { PHONEMES, type Phoneme } from './phoneme-table';
import { utteranceUs, type SpeechSound, type Utterance } from './utterance';

/** Samples a second of what `renderSpeech` makes. Chosen: up to 11 kHz, so that S is not F. */
export const SPEECH_RATE = 22_050;

/** Number of samples between two updates of the parameters (0.4 ms): with larger steps the glides crackle. */
const BLOCK = 8;
const MIDDLE_SETTING = 128;

/** State of the voice at one moment. */
interface Posture {
  readonly formants: readonly [number, number, number];
  /** Loudness of the voice, of breath through the mouth, of noise at one place; 0 … 1. */
  readonly voice: number;
  readonly breath: number;
  readonly noise: number;
  readonly noiseHz: number;
  readonly noiseWidthHz: number;
}

/** A stretch of time with one posture, or gliding from one to another. */
interface Segment {
  readonly startS: number;
  readonly endS: number;
  readonly from: Posture;
  readonly to: Posture;
  /** Time before the segment at which the voice begins to take its posture, in s. */
  readonly rampS: number;
  readonly startHz: number;
  readonly endHz: number;
}

/** Samples that `speechPieces` makes at a time: a quarter of a second, a frame or two on a weak tablet. */
const PIECE = 5504; // a multiple of BLOCK

/**
 * Makes samples of speech, −1 … 1, at `SPEECH_RATE`, piece by piece, so that the first words can be heard before the
 * last ones are made.
 *
 * A pulse train and noise go through five resonators in a row, noise of tongue and teeth through one beside them: after
 * D. H. Klatt, "Software for a cascade/parallel formant synthesizer" (1980), made smaller. The same utterance gives the
 * same samples in every engine.
 */
export function* speechPieces(utterance: Utterance): Generator<Float32Array, void, void> {
  const segments = segmentsOf(utterance);
  const length = Math.ceil((utteranceUs(utterance) * SPEECH_RATE) / 1_000_000);
  const tract = createTract();
  let place = 0;
  for (let pieceStart = 0; pieceStart < length; pieceStart += PIECE) {
    const piece = new Float32Array(Math.min(PIECE, length - pieceStart));
    for (let start = 0; start < piece.length; start += BLOCK) {
      const timeS = (pieceStart + start) / SPEECH_RATE;
      while (place < segments.length - 1 && timeS >= (segments[place]?.endS ?? Infinity)) place++;
      const segment = segments[place];
      if (!segment) return;
      const share = Math.min(1, (timeS - segment.startS) / Math.max(segment.endS - segment.startS, 1e-6));
      const hz = segment.startHz + (segment.endHz - segment.startHz) * share;
      tract.sound(postureAt(segments, place, timeS, share), hz, piece.subarray(start, start + BLOCK));
    }
    yield piece.map(limited);
  }
}

/** All samples of an utterance at once. */
export function renderSpeech(utterance: Utterance): Float32Array {
  const pieces = [...speechPieces(utterance)];
  const samples = new Float32Array(pieces.reduce((sum, piece) => sum + piece.length, 0));
  let start = 0;
  for (const piece of pieces) {
    samples.set(piece, start);
    start += piece.length;
  }
  return samples;
}

/** The posture at one moment: the segment's own, leaning towards the next one when that is near. */
function postureAt(segments: readonly Segment[], place: number, timeS: number, share: number): Posture {
  const segment = segments[place];
  if (!segment) throw new RangeError(`There is no segment ${place}.`);
  const own = mix(segment.from, segment.to, share);
  const next = segments[place + 1];
  if (!next) return own;
  const until = segment.endS - timeS;
  return until >= next.rampS ? own : mix(own, next.from, 1 - until / next.rampS);
}

function mix(a: Posture, b: Posture, share: number): Posture {
  const between = (from: number, to: number): number => from + (to - from) * share;
  return {
    formants: [
      between(a.formants[0], b.formants[0]),
      between(a.formants[1], b.formants[1]),
      between(a.formants[2], b.formants[2]),
    ],
    voice: between(a.voice, b.voice),
    breath: between(a.breath, b.breath),
    noise: between(a.noise, b.noise),
    noiseHz: between(a.noiseHz, b.noiseHz),
    noiseWidthHz: between(a.noiseWidthHz, b.noiseWidthHz),
  };
}

/** Duration of the transition from the previous sound, in s. Chosen by spectrograms. */
const RAMP_S = { vowel: 0.045, sonorant: 0.06, nasal: 0.025, fricative: 0.025, stop: 0.03, breath: 0.03, pause: 0.03 };
/** Parts of a stop: how long it is shut, how long it bursts; the rest is breath or nothing. */
const SHUT_SHARE = 0.6;
const BURST_S = 0.012;
const BURST_RAMP_S = 0.002;
const SHUT_VOICE = 0.12;

function segmentsOf({ sounds, mouth, throat }: Utterance): Segment[] {
  const segments: Segment[] = [];
  let startS = 0;
  sounds.forEach((sound, place) => {
    const phoneme = PHONEMES[sound.phoneme];
    if (!phoneme) return;
    const endS = startS + sound.durationUs / 1_000_000;
    const after = sounds.slice(place + 1).find((other) => isShaped(PHONEMES[other.phoneme]));
    const shape = (formants: Phoneme['formants']): Phoneme['formants'] => [
      Math.max(150, (formants[0] * mouth) / MIDDLE_SETTING),
      Math.max(400, (formants[1] * throat) / MIDDLE_SETTING),
      formants[2],
    ];
    segments.push(...segmentsOfSound(sound, phoneme, after && PHONEMES[after.phoneme], startS, endS, shape));
    startS = endS;
  });
  return segments;
}

const isShaped = (phoneme: Phoneme | undefined): boolean =>
  phoneme?.kind === 'vowel' || phoneme?.kind === 'sonorant' || phoneme?.kind === 'nasal';

function segmentsOfSound(
  sound: SpeechSound,
  phoneme: Phoneme,
  after: Phoneme | undefined,
  startS: number,
  endS: number,
  shape: (formants: Phoneme['formants']) => Phoneme['formants'],
): Segment[] {
  const { startHz, endHz, gain } = sound;
  const noise = phoneme.noise ?? { gain: 0, hz: 3000, widthHz: 1000 };
  const quiet: Posture = {
    formants: shape(phoneme.formants),
    voice: 0,
    breath: 0,
    noise: 0,
    noiseHz: noise.hz,
    noiseWidthHz: noise.widthHz,
  };
  const whole = (from: Posture, to: Posture): Segment[] => [
    { startS, endS, from, to, rampS: Math.min(RAMP_S[phoneme.kind], (endS - startS) / 2), startHz, endHz },
  ];
  if (phoneme.kind === 'breath') {
    // Breath uses the mouth of the vowel that follows.
    const from = { ...quiet, formants: shape((after ?? phoneme).formants), breath: noise.gain };
    return whole(from, from);
  }
  if (phoneme.kind !== 'stop') {
    const from = { ...quiet, voice: phoneme.voice * gain, noise: noise.gain };
    return whole(from, { ...from, formants: shape(phoneme.glide ?? phoneme.formants) });
  }
  const burstS = startS + (endS - startS) * SHUT_SHARE;
  const releaseS = Math.min(burstS + BURST_S, endS);
  const shut = { ...quiet, voice: phoneme.voice > 0 ? SHUT_VOICE : 0 };
  const burst = { ...shut, noise: noise.gain };
  const open = { ...quiet, breath: phoneme.voice > 0 ? 0 : 0.12, voice: phoneme.voice };
  return [
    { startS, endS: burstS, from: shut, to: shut, rampS: RAMP_S.stop, startHz, endHz },
    { startS: burstS, endS: releaseS, from: burst, to: burst, rampS: BURST_RAMP_S, startHz, endHz },
    { startS: releaseS, endS, from: open, to: open, rampS: BURST_RAMP_S, startHz, endHz },
  ];
}

/** Widths of the resonators in Hz, and the fixed upper formants. Klatt 1980, table I. */
const WIDTHS_HZ = [60, 90, 150, 250, 300] as const;
const UPPER_FORMANTS_HZ = [3500, 4500] as const;
/**
 * Bandwidth of the voice: how soon high frequencies fade. Chosen brighter than a human voice, for small loudspeakers.
 */
const GLOTTIS_WIDTH_HZ = 500;
/** Loudness of breath and of noise beside the voice's 1. Fitted: an S is half as loud as the vowel beside it. */
const BREATH_GAIN = 0.6;
const NOISE_GAIN = 3;

/** Mouth and throat: the state of its resonances carries over from block to block. */
function createTract(): { sound(posture: Posture, hz: number, out: Float32Array): void } {
  const chance = createRng(1982);
  const glottis = createResonator();
  const chain = WIDTHS_HZ.map(() => createResonator());
  const teeth = createResonator('peak');
  let phase = 0;
  let before = 0;
  let voice = 0;
  return {
    sound(posture, hz, out) {
      const centres = [...posture.formants, ...UPPER_FORMANTS_HZ];
      glottis.tune(0, GLOTTIS_WIDTH_HZ);
      chain.forEach((resonator, i) => resonator.tune(centres[i] ?? 0, WIDTHS_HZ[i] ?? 100));
      teeth.tune(posture.noiseHz, posture.noiseWidthHz);
      const step = hz / SPEECH_RATE;
      for (let i = 0; i < out.length; i++) {
        voice += (posture.voice - voice) * 0.02;
        phase += step;
        let pulse = 0;
        if (phase >= 1) {
          phase -= 1;
          pulse = 1 / step;
        }
        const hiss = chance.unit() * 2 - 1;
        let sample = glottis.pass(pulse) * voice + hiss * posture.breath * BREATH_GAIN;
        for (const resonator of chain) sample = resonator.pass(sample);
        const radiated = sample - before;
        before = sample;
        out[i] = radiated + teeth.pass(hiss) * posture.noise * NOISE_GAIN;
      }
    },
  };
}

/** A second-order resonator with gain 1 at 0 Hz (Klatt 1980, section I.B), or at its peak. */
function createResonator(unity: 'base' | 'peak' = 'base'): {
  tune(hz: number, widthHz: number): void;
  pass(sample: number): number;
} {
  let a = 1;
  let b = 0;
  let c = 0;
  let last = 0;
  let beforeLast = 0;
  let tunedHz = -1;
  let tunedWidthHz = -1;
  return {
    tune(hz, widthHz) {
      if (hz === tunedHz && widthHz === tunedWidthHz) return;
      tunedHz = hz;
      tunedWidthHz = widthHz;
      const decay = exactExp((-Math.PI * widthHz) / SPEECH_RATE);
      c = -decay * decay;
      const angle = (2 * Math.PI * Math.min(hz, SPEECH_RATE / 2)) / SPEECH_RATE;
      b = 2 * decay * exactCos(angle);
      const peak = (1 - decay) * Math.sqrt(1 - 2 * decay * exactCos(2 * angle) + decay * decay);
      a = unity === 'base' ? 1 - b - c : peak;
    },
    pass(sample) {
      const result = a * sample + b * last + c * beforeLast;
      beforeLast = last;
      last = result;
      return result;
    },
  };
}

/** Brings the voice to full scale; peaks are rounded off. Fitted: of "hello world" one sample in a hundred is above 0.6. */
const OUTPUT_GAIN = 0.7;
const limited = (sample: number): number => {
  const loud = sample * OUTPUT_GAIN;
  return loud / Math.sqrt(1 + loud * loud);
};
