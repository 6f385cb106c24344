import { PAIRS, PHONEMES, type Phoneme } from './phoneme-table';
import type { SpeechSound, Utterance } from './utterance';

/** Settings of a voice: the values of the speech module, 0 … 255 each. */
export interface Voice {
  /** A higher number is a lower voice; 64 is normal. */
  readonly pitch: number;
  /** A higher number is slower; 72 is normal. */
  readonly speed: number;
  readonly mouth: number;
  readonly throat: number;
  /** True: uses the pitches as written; false: varies them as in a spoken sentence. */
  readonly sings: boolean;
}

/** Pitch number times the voice's Hz. Fitted to the notes in the speech module's documentation: #115 is C2. */
const HZ_OF_PITCH = 7600;
const ORDINARY_SPEED = 72; // documentation of the speech module
const LONGEST = 255; // documentation of the speech module: characters of phonemes

/** A phoneme as it is written, with its marks. */
interface Written {
  readonly name: string;
  readonly phoneme: Phoneme;
  /** 1 (very strong) … 8 (falling), 0 without a mark. */
  readonly stress: number;
  readonly pitch: number;
}

/** Effect of stress on the voice, by its mark: no mark, 1 … 8. Chosen to follow the words of the documentation. */
const STRESS_PITCH = [1, 1.3, 1.24, 1.18, 1.12, 1.06, 1, 0.88, 0.78] as const;
const STRESS_LENGTH = [1, 1.45, 1.4, 1.3, 1.25, 1.15, 1.1, 1.1, 1.1] as const;
const UNSTRESSED_GAIN = 0.8;
/** When speaking, the voice sinks from the beginning to the end of a sentence: share of its pitch. Chosen by ear. */
const SENTENCE_FROM = 1.06;
const SENTENCE_TO = 0.9;
/** The last sounds fall before a full stop, rise before a question mark, and stay up before a comma. */
const ENDINGS: Readonly<Record<string, number>> = { '.': 0.78, '?': 1.35, ',': 1.08 };
const ENDING_SOUNDS = 4;

/**
 * Converts a text of phonemes to speech.
 *
 * @param text as `speech.pronounce` takes it: phonemes, stress marks 1 … 8 after a vowel, spaces, punctuation and, to
 *   sing, pitches such as `#115`
 * @returns `null` for text that is not made of phonemes, or longer than the device takes
 */
export function utter(text: string, voice: Voice): Utterance | null {
  if (text.length > LONGEST) return null;
  const written = readPhonemes(text.toUpperCase(), voice.pitch);
  if (!written) return null;
  return {
    sounds: voice.sings ? sing(written, voice) : speak(written, voice),
    mouth: voice.mouth,
    throat: voice.throat,
  };
}

function readPhonemes(text: string, startPitch: number): readonly Written[] | null {
  const written: Written[] = [];
  let pitch = startPitch;
  for (let place = 0; place < text.length;) {
    const mark = /^#(\d{1,3})/.exec(text.slice(place));
    if (mark) {
      pitch = Number(mark[1]) & 0xff;
      place += mark[0].length;
      continue;
    }
    const name = nameAt(text, place);
    if (name === null) return null;
    place += name.length;
    const stress = /^[1-8]/.exec(text.slice(place))?.[0] ?? '';
    place += stress.length;
    for (const part of PAIRS[name] ?? [name]) {
      const phoneme = PHONEMES[part];
      if (phoneme) written.push({ name: part, phoneme, stress: Number(stress), pitch });
    }
  }
  return written;
}

/** The longest phoneme name at this place. */
function nameAt(text: string, place: number): string | null {
  for (const length of [2, 1]) {
    const name = text.slice(place, place + length);
    if (name.length === length && (name in PHONEMES || name in PAIRS)) return name;
  }
  return null;
}

const hzOf = (pitch: number): number => HZ_OF_PITCH / Math.max(pitch, 1);
const durationUs = (ms: number, speed: number): number => Math.floor((ms * 1000 * Math.max(speed, 1)) / ORDINARY_SPEED);

function sing(written: readonly Written[], { speed }: Voice): SpeechSound[] {
  return written.map(({ name, phoneme, pitch }) => ({
    phoneme: name,
    durationUs: durationUs(phoneme.ms, speed),
    startHz: hzOf(pitch),
    endHz: hzOf(pitch),
    gain: 1,
  }));
}

function speak(written: readonly Written[], { speed }: Voice): SpeechSound[] {
  const sounds: SpeechSound[] = [];
  let from = 0;
  while (from < written.length) {
    const stop = written.findIndex((sound, place) => place >= from && sound.name in ENDINGS);
    const to = stop < 0 ? written.length : stop + 1;
    sounds.push(...speakClause(written.slice(from, to), speed));
    from = to;
  }
  return sounds;
}

/** A part of a sentence, up to its full stop, comma or question mark: the voice sinks, and turns at the end. */
function speakClause(clause: readonly Written[], speed: number): SpeechSound[] {
  const ending = ENDINGS[clause.at(-1)?.name ?? ''] ?? ENDINGS['.'] ?? 1;
  const last = clause.length - 1;
  const shareAt = (place: number): number => {
    const sunk = SENTENCE_FROM + (SENTENCE_TO - SENTENCE_FROM) * (place / Math.max(last, 1));
    const intoEnding = Math.max(0, place - (last - ENDING_SOUNDS)) / ENDING_SOUNDS;
    return sunk + (ending - sunk) * Math.min(1, intoEnding);
  };
  return clause.map(({ name, phoneme, stress, pitch }, place) => {
    const hz = hzOf(pitch) * (STRESS_PITCH[stress] ?? 1);
    const isWeak = phoneme.kind === 'vowel' && stress === 0;
    return {
      phoneme: name,
      durationUs: durationUs(phoneme.ms * (STRESS_LENGTH[stress] ?? 1), speed),
      startHz: hz * shareAt(place),
      endHz: hz * shareAt(place + 1),
      gain: isWeak ? UNSTRESSED_GAIN : 1,
    };
  });
}
