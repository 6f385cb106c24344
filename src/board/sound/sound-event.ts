import type { EffectPart } from './effect';
import type { Utterance } from './utterance';

/**
 * An event of the board's sound hardware. It is plain data: it can be logged and sent. The sound follows from the
 * events alone. `render-effect` and `render-speech` make samples of them, which a headless run never does.
 *
 * The device mixes four sources: a tone, an effect, samples and speech. Each continues until it has ended, is replaced
 * by the next event of its kind, or is silenced.
 */
export type SoundEvent = {
  /** When it happens, in µs since the start of the run. */
  readonly timeUs: number;
} & SoundChange;

/** A sound event without its time. */
export type SoundChange =
  /** The square wave of music; `null` is silence. */
  | { readonly type: 'tone'; readonly hz: number | null }
  /** A sound effect or a built-in sound: its parts follow one another without a gap. */
  | { readonly type: 'effect'; readonly parts: readonly EffectPart[] }
  /** Samples of 8 bits, 128 is the middle; `rate` in samples a second. They begin at `startUs` (may be a fraction). */
  | { readonly type: 'samples'; readonly startUs: number; readonly rate: number; readonly samples: readonly number[] }
  | { readonly type: 'speech'; readonly utterance: Utterance }
  /** A source ends early. */
  | { readonly type: 'silence'; readonly source: SoundSource }
  /** Overall loudness, 0 … 255. */
  | { readonly type: 'volume'; readonly volume: number }
  /** The destination of the sound: to the board's speaker or not, and to the wire of a pin or of none (`null`). */
  | { readonly type: 'output'; readonly isSpeakerOn: boolean; readonly pin: string | null };

/** The sources that can be silenced early; a tone is silenced by the tone `null`. */
export type SoundSource = 'effect' | 'samples' | 'speech';
