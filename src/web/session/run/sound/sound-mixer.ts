import type { SoundEvent, SoundSource } from '#board/sound/sound-event';

import type { EFFECT_RATE, renderEffect, SPEECH_RATE, speechPieces } from './synthesis';
import { createLimiter } from './limiter';
import { createStream, EDGE_S, LOUDNESS, playPieces, playSamples, playTone, SPEECH_GAIN, type Voice } from './voices';

/** The module that makes samples; loaded on demand. */
export interface Synthesis {
  readonly EFFECT_RATE: typeof EFFECT_RATE;
  readonly SPEECH_RATE: typeof SPEECH_RATE;
  readonly renderEffect: typeof renderEffect;
  readonly speechPieces: typeof speechPieces;
}

const FULL_VOLUME = 255;
const SOURCES = ['tone', 'effect', 'speech'] as const;

/** The board's four sources of sound as nodes of the sound system. It plays into the context's destination. */
export class SoundMixer {
  /** The limiter before the loudspeaker; the page's other sounds play into it, too. */
  readonly out: AudioNode;
  private readonly volume: GainNode;
  private readonly speaker: GainNode;
  private readonly stream: ReturnType<typeof createStream>;
  private readonly voices: Record<(typeof SOURCES)[number], Voice | null> = { tone: null, effect: null, speech: null };

  private speechMade: Promise<void> = Promise.resolve();

  constructor(private readonly context: BaseAudioContext) {
    this.volume = context.createGain();
    this.speaker = context.createGain();
    this.out = createLimiter(context);
    this.volume.connect(this.speaker).connect(this.out);
    this.stream = createStream(context, this.volume);
  }

  /** End of the last current sound, in s of the sound system; `Infinity` while a tone sounds. */
  get endS(): number {
    return Math.max(this.stream.endS, ...SOURCES.map((source) => this.voices[source]?.endS ?? 0));
  }

  /** Resolves when all samples of the speech are made; the first are heard earlier. */
  get made(): Promise<void> {
    return this.speechMade;
  }

  /**
   * Plays a sound event.
   *
   * @param atS when, in s of the sound system
   * @param synthesis needed for effects and speech, which are silent without it
   */
  play(event: SoundEvent, atS: number, synthesis: Synthesis | null): void {
    switch (event.type) {
      case 'tone':
        this.replace('tone', atS, event.hz === null ? null : playTone(this.context, this.volume, event.hz, atS));
        break;
      case 'effect':
      case 'speech':
        if (synthesis !== null) this.replace(event.type, atS, this.playMade(event, atS, synthesis));
        break;
      case 'samples':
        this.stream.play(event, atS);
        break;
      case 'silence':
        this.endSource(event.source, atS);
        break;
      case 'volume':
        this.volume.gain.setTargetAtTime(event.volume / FULL_VOLUME, atS, EDGE_S);
        break;
      case 'output':
        // Sound that only a pin carries is not played: there are no headphones on the pin.
        this.speaker.gain.setTargetAtTime(event.isSpeakerOn ? 1 : 0, atS, EDGE_S);
        break;
      default:
        event satisfies never;
    }
  }

  /** Silences everything immediately; volume and output stay. */
  stop(): void {
    for (const source of SOURCES) this.replace(source, this.context.currentTime, null);
    this.stream.end(this.context.currentTime);
  }

  /** Silences everything immediately, full volume, speaker on. */
  reset(): void {
    this.stop();
    for (const { gain } of [this.volume, this.speaker]) {
      gain.cancelScheduledValues(0);
      gain.value = 1;
    }
  }

  private playMade(
    event: Extract<SoundEvent, { type: 'effect' | 'speech' }>,
    atS: number,
    synthesis: Synthesis,
  ): Voice {
    const { context, volume } = this;
    if (event.type === 'effect') {
      const samples = synthesis.renderEffect(event.parts);
      return playSamples(context, volume, { samples, rate: synthesis.EFFECT_RATE, loudness: LOUDNESS }, atS);
    }
    const sound = { rate: synthesis.SPEECH_RATE, loudness: LOUDNESS * SPEECH_GAIN };
    const voice = playPieces(context, volume, synthesis.speechPieces(event.utterance), sound, atS);
    this.speechMade = voice.made;
    return voice;
  }

  private endSource(source: SoundSource, atS: number): void {
    if (source === 'samples') this.stream.end(atS);
    else this.replace(source, atS, null);
  }

  /** Ends the sound of a source and plays another one, or none. */
  private replace(source: (typeof SOURCES)[number], atS: number, voice: Voice | null): void {
    this.voices[source]?.end(atS);
    this.voices[source] = voice;
  }
}
