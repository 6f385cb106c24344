/** The speech synthesiser's output: phonemes with their lengths and pitches, as plain data. */
export interface Utterance {
  /** One after the other, without gaps. */
  readonly sounds: readonly SpeechSound[];
  /** Size of the mouth's opening, 0 … 255: scales the first formant; 128 is as the tables have it. */
  readonly mouth: number;
  /** Size of the throat, 0 … 255: scales the second formant; 128 is as the tables have it. */
  readonly throat: number;
}

/** One phoneme of spoken text. */
export interface SpeechSound {
  /** Name in the table of phonemes, `IY`; a pause is a space. */
  readonly phoneme: string;
  /** Whole µs. */
  readonly durationUs: number;
  /** Pitch of the voice in Hz at its beginning and at its end. */
  readonly startHz: number;
  readonly endHz: number;
  /** Loudness, 0 … 1: a stressed vowel is louder. */
  readonly gain: number;
}

/** Its duration, in µs. */
export function utteranceUs({ sounds }: Utterance): number {
  return sounds.reduce((sum, sound) => sum + sound.durationUs, 0);
}
