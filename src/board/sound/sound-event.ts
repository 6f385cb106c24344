import type { EffectPart } from './effect';
import type { Utterance } from './utterance';

/**
 * Something that the board's sound hardware begins or ends to do. Plain data: it can be logged and sent. What sounds
 * follows from the events alone; `render-effect` and `render-speech` make samples of them, which a run without ears
 * never does.
 *
 * The device mixes four sources: a tone, an effect, samples and speech. Each goes on until it has ended, is replaced by
 * the next event of its kind, or is silenced.
 */
export type SoundEvent = {
  /** When it happens, in µs since the start of the run. */
  readonly timeUs: number;
} & SoundChange;

/** What a sound event says, without its time. */
export type SoundChange =
  /** The square wave of music; `null` is silence. */
  | { readonly type: 'tone'; readonly hz: number | null }
  /** A sound effect or a built-in sound: its parts follow one another without a gap. */
  | { readonly type: 'effect'; readonly parts: readonly EffectPart[] }
  /** Samples of 8 bits, 128 is the middle; `rate` in samples a second. They begin `startUs` after the start, not whole. */
  | { readonly type: 'samples'; readonly startUs: number; readonly rate: number; readonly samples: readonly number[] }
  | { readonly type: 'speech'; readonly utterance: Utterance }
  /** A source ends before its time. */
  | { readonly type: 'silence'; readonly source: SoundSource }
  /** Loudness of everything, 0 … 255. */
  | { readonly type: 'volume'; readonly volume: number }
  /** Where the sound goes: to the board's speaker or not, and to the wire of a pin or of none (`null`). */
  | { readonly type: 'output'; readonly isSpeakerOn: boolean; readonly pin: string | null };

/** What can be silenced before its time; a tone is silenced by the tone `null`. */
export type SoundSource = 'effect' | 'samples' | 'speech';
