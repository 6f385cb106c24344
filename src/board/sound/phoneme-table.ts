/** Articulation of a phoneme. */
export type PhonemeKind = 'vowel' | 'sonorant' | 'nasal' | 'fricative' | 'stop' | 'breath' | 'pause';

/** A phoneme of the speech module: its length and the posture of mouth and throat. */
export interface Phoneme {
  readonly kind: PhonemeKind;
  /** Length at speed 72, in ms. Chosen, after D. H. Klatt's table of inherent durations (1976), for a clear slow voice. */
  readonly ms: number;
  /** The first three formants in Hz. */
  readonly formants: readonly [number, number, number];
  /** The formants at the end, for a sound that glides. */
  readonly glide?: readonly [number, number, number];
  /** Loudness of the voice, 0 … 1. */
  readonly voice: number;
  /** Noise of breath or burst: loudness 0 … 1, centre and width in Hz. */
  readonly noise?: { readonly gain: number; readonly hz: number; readonly widthHz: number };
}

const vowel = (ms: number, f1: number, f2: number, f3: number): Phoneme => ({
  kind: 'vowel',
  ms,
  formants: [f1, f2, f3],
  voice: 1,
});
const diphthong = (ms: number, from: Phoneme['formants'], to: Phoneme['formants']): Phoneme => ({
  kind: 'vowel',
  ms,
  formants: from,
  glide: to,
  voice: 1,
});
const sonorant = (ms: number, f1: number, f2: number, f3: number): Phoneme => ({
  kind: 'sonorant',
  ms,
  formants: [f1, f2, f3],
  voice: 0.75,
});
const nasal = (ms: number, f2: number): Phoneme => ({ kind: 'nasal', ms, formants: [280, f2, 2400], voice: 0.5 });
const fricative = (
  ms: number,
  formants: Phoneme['formants'],
  voice: number,
  noise: NonNullable<Phoneme['noise']>,
): Phoneme => ({ kind: 'fricative', ms, formants, voice, noise });
const stop = (
  ms: number,
  formants: Phoneme['formants'],
  voice: number,
  noise: NonNullable<Phoneme['noise']>,
): Phoneme => ({ kind: 'stop', ms, formants, voice, noise });
const pause = (ms: number): Phoneme => ({ kind: 'pause', ms, formants: [500, 1500, 2500], voice: 0 });

/** Formants of consonants by the place where they are made: those of the vowels beside them bend towards these. */
const LIPS = [300, 900, 2200] as const;
const TEETH = [300, 1400, 2600] as const;
const RIDGE = [300, 1750, 2700] as const;
const PALATE = [300, 1900, 2600] as const;
const VELUM = [300, 2000, 2400] as const;

/**
 * The phonemes by name, as the documentation of the micro:bit's speech module lists them.
 *
 * Formants of the vowels: G. E. Peterson and H. L. Barney, "Control Methods Used in a Study of the Vowels" (1952),
 * averages of men; consonants: D. H. Klatt, "Software for a cascade/parallel formant synthesizer" (1980), table III;
 * loudness and noises: chosen by spectrograms of the words in `render-speech.test.ts`.
 */
export const PHONEMES: Readonly<Record<string, Phoneme>> = {
  IY: vowel(120, 270, 2290, 3010),
  IH: vowel(90, 390, 1990, 2550),
  EH: vowel(110, 530, 1840, 2480),
  AE: vowel(140, 660, 1720, 2410),
  AA: vowel(140, 730, 1090, 2440),
  AH: vowel(110, 640, 1190, 2390),
  AO: vowel(150, 570, 840, 2410),
  OH: vowel(130, 480, 900, 2400),
  UH: vowel(100, 440, 1020, 2240),
  UX: vowel(120, 300, 900, 2240),
  ER: vowel(140, 490, 1350, 1690),
  AX: vowel(70, 500, 1400, 2400),
  IX: vowel(70, 420, 1800, 2500),
  EY: diphthong(150, [500, 1850, 2500], [300, 2250, 2900]),
  AY: diphthong(170, [720, 1150, 2450], [380, 2050, 2600]),
  OY: diphthong(190, [540, 850, 2400], [380, 2000, 2550]),
  AW: diphthong(180, [720, 1250, 2450], [420, 950, 2300]),
  OW: diphthong(150, [520, 950, 2400], [370, 820, 2300]),
  UW: diphthong(140, [340, 1150, 2300], [290, 850, 2240]),
  R: sonorant(80, 330, 1060, 1400),
  L: sonorant(80, 340, 1050, 2800),
  W: sonorant(80, 300, 620, 2150),
  WH: { ...sonorant(90, 300, 620, 2150), voice: 0.4, noise: { gain: 0.12, hz: 900, widthHz: 600 } },
  Y: sonorant(70, 270, 2200, 3000),
  RX: sonorant(80, 400, 1150, 1550),
  LX: sonorant(90, 420, 850, 2700),
  WX: sonorant(80, 340, 700, 2200),
  YX: sonorant(80, 300, 2150, 2800),
  M: nasal(90, 1100),
  N: nasal(80, 1600),
  NX: nasal(100, 2100),
  B: stop(80, LIPS, 0.5, { gain: 0.25, hz: 700, widthHz: 700 }),
  D: stop(75, RIDGE, 0.5, { gain: 0.25, hz: 3400, widthHz: 1400 }),
  G: stop(85, VELUM, 0.5, { gain: 0.3, hz: 1900, widthHz: 600 }),
  P: stop(110, LIPS, 0, { gain: 0.35, hz: 800, widthHz: 900 }),
  T: stop(105, RIDGE, 0, { gain: 0.5, hz: 4000, widthHz: 1600 }),
  K: stop(115, VELUM, 0, { gain: 0.5, hz: 2000, widthHz: 700 }),
  DX: stop(40, RIDGE, 0.6, { gain: 0.1, hz: 3400, widthHz: 1400 }),
  Q: stop(60, [500, 1500, 2500], 0, { gain: 0, hz: 1000, widthHz: 1000 }),
  J: fricative(120, PALATE, 0.35, { gain: 0.4, hz: 2800, widthHz: 900 }),
  CH: fricative(140, PALATE, 0, { gain: 0.55, hz: 2900, widthHz: 900 }),
  S: fricative(120, RIDGE, 0, { gain: 0.5, hz: 5600, widthHz: 1400 }),
  SH: fricative(130, PALATE, 0, { gain: 0.55, hz: 2800, widthHz: 800 }),
  F: fricative(110, LIPS, 0, { gain: 0.14, hz: 4500, widthHz: 5000 }),
  TH: fricative(110, TEETH, 0, { gain: 0.12, hz: 6000, widthHz: 4000 }),
  Z: fricative(90, RIDGE, 0.4, { gain: 0.3, hz: 5400, widthHz: 1400 }),
  ZH: fricative(90, PALATE, 0.4, { gain: 0.35, hz: 2700, widthHz: 800 }),
  V: fricative(70, LIPS, 0.5, { gain: 0.07, hz: 4500, widthHz: 5000 }),
  DH: fricative(60, TEETH, 0.5, { gain: 0.06, hz: 6000, widthHz: 4000 }),
  '/H': { kind: 'breath', ms: 80, formants: [500, 1500, 2500], voice: 0, noise: { gain: 0.2, hz: 0, widthHz: 0 } },
  '/X': { kind: 'breath', ms: 90, formants: [400, 1800, 2500], voice: 0, noise: { gain: 0.3, hz: 0, widthHz: 0 } },
  ' ': pause(30),
  '-': pause(150),
  ',': pause(300),
  '.': pause(400),
  '?': pause(400),
};

/** Names for pairs of phonemes. */
export const PAIRS: Readonly<Record<string, readonly [string, string]>> = {
  UL: ['AX', 'LX'],
  UM: ['AX', 'M'],
  UN: ['AX', 'N'],
};
