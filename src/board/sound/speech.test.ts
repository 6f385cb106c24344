import { describe, expect, it } from 'vitest';
import { phonemesOf } from './letter-rules';
import { renderSpeech, SPEECH_RATE } from './render-speech';
import { utter, type Voice } from './utter';
import { utteranceUs } from './utterance';

const VOICE: Voice = { pitch: 64, speed: 72, mouth: 128, throat: 128, sings: false };
const spoken = (text: string): string | null => phonemesOf(text);

describe('text to phonemes', () => {
  it('reads the words of a robot lesson', () => {
    expect(spoken('hello world')).toBe('/HEH4LOW WER4LD');
    expect(spoken('exterminate')).toBe('EH4KSTERMIHNEYT');
    expect(spoken('The quick brown fox')).toBe('DHAX KWIH4K BROW4N FAA4KS');
    expect(spoken('this is a robot')).toBe('DHIH4S IHZ AX ROW4BAAT');
    expect(spoken('left, right - python!')).toBe('LEH4FT, RAY4T- PAY4THAAN.');
  });

  it('knows the endings: boats, houses, needed, jumped, running', () => {
    expect(spoken('boats houses needed jumped running')).toBe('BOW4TS /HAW4ZIHZ NIY4DIHD JAH4MPT RAH4NIHNX');
  });

  it('reads digits one by one and signs by their names', () => {
    expect(spoken('21')).toBe('TUW4 WAH4N');
    expect(spoken('3 + 4 = 7')).toBe('THRIY4 PLAH4S FAO4R IY4KWAXLZ SEH4VAXN');
  });

  it('does not read letters that English does not have', () => {
    expect(['ä', 'hello ☺', 'naïve'].map(spoken)).toEqual([null, null, null]);
    expect([spoken(''), spoken('   ')]).toEqual(['', '']);
  });
});

describe('phonemes to speech', () => {
  const msOf = (text: string, voice: Partial<Voice> = {}): number | null => {
    const utterance = utter(text, { ...VOICE, ...voice });
    return utterance && utteranceUs(utterance) / 1000;
  };

  it('takes 120 ms for IY, twice as long at half the speed, and longer when it is stressed', () => {
    expect([msOf('IY'), msOf('IY', { speed: 144 }), msOf('IY4'), msOf('iy')]).toEqual([120, 240, 150, 120]);
  });

  it('pauses 30 ms between words, 150 at a hyphen, 300 at a comma, 400 at the end of a sentence', () => {
    const iy = 120;
    expect(['IY ', 'IY-', 'IY,', 'IY.', 'IY?'].map((text) => (msOf(text) ?? 0) - iy)).toEqual([30, 150, 300, 400, 400]);
  });

  it('speaks at 119 Hz with pitch 64, higher with lower numbers, and sings the pitch that is written', () => {
    const hz = (text: string, voice: Partial<Voice>) =>
      Math.round(utter(text, { ...VOICE, ...voice })?.sounds[0]?.startHz ?? 0);
    expect([hz('IY', { sings: true }), hz('IY', { sings: true, pitch: 32 })]).toEqual([119, 238]);
    expect([hz('#115IY', { sings: true }), hz('#58IY', { sings: true })]).toEqual([66, 131]);
  });

  it('lets the voice fall before a full stop and rise before a question mark', () => {
    const last = (text: string): number => utter(text, VOICE)?.sounds.at(-1)?.endHz ?? 0;
    expect(last('AA AA AA AA.')).toBeLessThan(100);
    expect(last('AA AA AA AA?')).toBeGreaterThan(150);
  });

  it('refuses what is no phoneme, and more than 255 characters', () => {
    expect([msOf('XX'), msOf('IY9'), msOf('#IY'), msOf('A'.repeat(256))]).toEqual([null, null, null, null]);
  });

  it('speaks two phonemes for UL, UM and UN', () => {
    expect(utter('UL', VOICE)?.sounds.map(({ phoneme }) => phoneme)).toEqual(['AX', 'LX']);
  });
});

/** Samples of phonemes, from one share of their time to another. */
function samplesOf(
  text: string,
  [from, to]: readonly [number, number] = [0, 1],
  voice: Partial<Voice> = {},
): Float32Array {
  const utterance = utter(text, { ...VOICE, sings: true, ...voice });
  if (!utterance) throw new Error(`${text} are no phonemes.`);
  const samples = renderSpeech(utterance);
  return samples.subarray(Math.floor(samples.length * from), Math.floor(samples.length * to));
}

/** Energy between two frequencies, by a sum of single frequencies every 25 Hz. */
function energy(samples: Float32Array, fromHz: number, toHz: number): number {
  let sum = 0;
  for (let hz = fromHz; hz < toHz; hz += 25) {
    let re = 0;
    let im = 0;
    samples.forEach((sample, i) => {
      const angle = (2 * Math.PI * hz * i) / SPEECH_RATE;
      const window = 0.5 - 0.5 * Math.cos((2 * Math.PI * i) / samples.length);
      re += sample * window * Math.cos(angle);
      im += sample * window * Math.sin(angle);
    });
    sum += re * re + im * im;
  }
  return sum;
}

/** The loudest band of 100 Hz within a range, by its middle. */
function loudestHz(samples: Float32Array, fromHz: number, toHz: number): number {
  let best = { hz: 0, energy: 0 };
  for (let hz = fromHz; hz < toHz; hz += 50) {
    const found = energy(samples, hz - 50, hz + 50);
    if (found > best.energy) best = { hz, energy: found };
  }
  return best.hz;
}

/** Pitch of the voice, 40 … 250 Hz, by the shift at which the samples are most like themselves. */
function voiceHz(samples: Float32Array): number {
  let best = { lag: 0, likeness: 0 };
  for (let lag = Math.floor(SPEECH_RATE / 250); lag < SPEECH_RATE / 40; lag++) {
    let likeness = 0;
    for (let i = 0; i + lag < samples.length; i++) likeness += samples[i]! * samples[i + lag]!;
    if (likeness > best.likeness) best = { lag, likeness };
  }
  return SPEECH_RATE / best.lag;
}

describe('speech to samples', () => {
  it('gives the vowels their formants: IY 270 and 2290 Hz, AA 730 and 1090 Hz', () => {
    const iy = samplesOf('IY', [0.3, 0.7]);
    const aa = samplesOf('AA', [0.3, 0.7]);
    expect(Math.abs(loudestHz(iy, 200, 1000) - 270)).toBeLessThanOrEqual(100);
    expect(Math.abs(loudestHz(iy, 1500, 2700) - 2290)).toBeLessThanOrEqual(150);
    expect(Math.abs(loudestHz(aa, 500, 950) - 730)).toBeLessThanOrEqual(120);
    expect(Math.abs(loudestHz(aa, 950, 1400) - 1090)).toBeLessThanOrEqual(150);
  });

  it('hisses S above 4 kHz and SH below, and lets T burst after silence', () => {
    const s = samplesOf('S', [0.3, 0.7]);
    const sh = samplesOf('SH', [0.3, 0.7]);
    expect(energy(s, 4500, 7000)).toBeGreaterThan(5 * energy(s, 500, 3500));
    expect(energy(sh, 2000, 3700)).toBeGreaterThan(3 * energy(sh, 4500, 7000));
    const loudness = (from: number, to: number): number =>
      Math.sqrt(samplesOf('AATAA', [from, to]).reduce((sum, sample) => sum + sample * sample, 0));
    expect(loudness(0.42, 0.5)).toBeLessThan(0.2 * loudness(0.53, 0.58));
  });

  it('moves the formants with throat and mouth', () => {
    const low = loudestHz(samplesOf('IY', [0.3, 0.7], { throat: 90 }), 1200, 2700);
    expect(low).toBeLessThan(1900);
  });

  it('makes as many samples as the speech is long, the same every time, below full scale', () => {
    const once = samplesOf('/HEH4LOW WER4LD');
    expect(once.length).toBe(
      Math.ceil((utteranceUs(utter('/HEH4LOW WER4LD', { ...VOICE, sings: true })!) * SPEECH_RATE) / 1_000_000),
    );
    const loudest = Math.max(...once.map(Math.abs));
    expect([loudest > 0.4, loudest < 1]).toEqual([true, true]);
    expect(samplesOf('/HEH4LOW WER4LD')).toEqual(once);
    expect(once.every(Number.isFinite)).toBe(true);
  });

  it('sings #58 an octave above #115', () => {
    expect(Math.abs(voiceHz(samplesOf('#115AAAAAAAA', [0.2, 0.8])) - 7600 / 115)).toBeLessThan(1);
    expect(Math.abs(voiceHz(samplesOf('#58AAAAAAAA', [0.2, 0.8])) - 7600 / 58)).toBeLessThan(2);
  });
});
