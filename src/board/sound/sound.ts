import type { Clock } from '#core/clock';
import type { Stop } from '#core/stop';
import { AudioRoute } from './audio-route';
import { effectMs, type EffectPart } from './effect';
import { SampleStream } from './sample-stream';
import type { SoundChange, SoundEvent, SoundSource } from './sound-event';
import { utteranceUs, type Utterance } from './utterance';

const MAX_VOLUME = 255;

/**
 * The board's sound hardware: the mixer of four sources, its volume and its outputs. It reports what sounds from when
 * to when; it makes no samples. Source: codal-microbit-v2 MicroBitAudio.cpp, micropython-microbit-v2 modaudio.c and
 * modspeech.c. Left out: the mixer's buffers, some 6 ms.
 */
export class Sound {
  /** The pin that also carries the sound. */
  readonly route = new AudioRoute(() => this.tellOutput());
  /** Samples that a program makes itself. */
  readonly stream: SampleStream;
  private readonly listeners = new Set<(event: SoundEvent) => void>();
  private currentVolume = MAX_VOLUME;
  private speakerOn = true;
  private effectEndUs = 0;
  private speechEndUs = 0;

  constructor(private readonly clock: Clock) {
    this.stream = new SampleStream(clock, ({ samples, rate }, startUs) =>
      this.tell({ type: 'samples', startUs, rate, samples }),
    );
  }

  /** Overall loudness, 0 … 255; 255 after a start. */
  get volume(): number {
    return this.currentVolume;
  }

  /** Values outside 0 … 255 change nothing, as on the device. */
  setVolume(volume: number): void {
    if (!(volume >= 0 && volume <= MAX_VOLUME)) return;
    this.currentVolume = volume;
    this.tell({ type: 'volume', volume });
  }

  /** False after `setSpeaker(false)`: the sound then goes to the pin alone. */
  get isSpeakerOn(): boolean {
    return this.speakerOn;
  }

  setSpeaker(isOn: boolean): void {
    this.speakerOn = isOn;
    this.tellOutput();
  }

  /** True while an effect, samples or speech sound. The tone is `MusicPlayer.frequencyHz`. */
  get isSounding(): boolean {
    const { nowUs } = this.clock;
    return this.effectEndUs > nowUs || this.speechEndUs > nowUs || this.stream.isSounding;
  }

  /** When the current effect ends, in µs; a time in the past if there is none. */
  get effectUntilUs(): number {
    return this.effectEndUs;
  }

  /** When the current speech ends, in µs; a time in the past if there is none. */
  get speechUntilUs(): number {
    return this.speechEndUs;
  }

  /** Plays an effect, replacing the current one. */
  playEffect(parts: readonly EffectPart[]): void {
    this.effectEndUs = this.clock.nowUs + effectMs(parts) * 1000;
    this.tell({ type: 'effect', parts });
  }

  /** Speaks, replacing the current speech. */
  speak(utterance: Utterance): void {
    this.speechEndUs = this.clock.nowUs + utteranceUs(utterance);
    this.tell({ type: 'speech', utterance });
  }

  /** Ends a source early. */
  silence(source: SoundSource): void {
    if (this.stopSource(source)) this.tell({ type: 'silence', source });
  }

  /** Reports everything that the sound hardware does from now on, in the order of time. */
  onEvent(listener: (event: SoundEvent) => void): Stop {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  /** Back to silence, full volume, speaker on, no pin. `MusicPlayer.stop` ends the tone of music. */
  reset(): void {
    for (const source of ['effect', 'samples', 'speech'] as const) this.silence(source);
    this.route.free();
    if (this.currentVolume !== MAX_VOLUME) this.setVolume(MAX_VOLUME);
    if (!this.speakerOn) this.setSpeaker(true);
  }

  /** Notifies the listeners. */
  tell(change: SoundChange): void {
    if (this.listeners.size === 0) return;
    const event: SoundEvent = { timeUs: this.clock.nowUs, ...change };
    for (const listener of this.listeners) listener(event);
  }

  private stopSource(source: SoundSource): boolean {
    const { nowUs } = this.clock;
    if (source === 'samples') return this.stream.silence();
    if (source === 'effect') {
      const sounded = this.effectEndUs > nowUs;
      this.effectEndUs = Math.min(this.effectEndUs, nowUs);
      return sounded;
    }
    const sounded = this.speechEndUs > nowUs;
    this.speechEndUs = Math.min(this.speechEndUs, nowUs);
    return sounded;
  }

  private tellOutput(): void {
    this.tell({ type: 'output', isSpeakerOn: this.speakerOn, pin: this.route.current?.name ?? null });
  }
}
