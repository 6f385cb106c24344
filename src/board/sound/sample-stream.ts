import type { Clock } from '#core/clock';
import type { Stop } from '#core/stop';

/** Samples as a program passes them on. */
export interface SampleBlock {
  /** 8 bits each, 128 is the middle. */
  readonly samples: readonly number[];
  /** Samples a second. */
  readonly rate: number;
}

/** The device's mixer takes this many samples at a time: micropython-microbit-v2 modaudio.c, AUDIO_CHUNK_SIZE. */
export const CHUNK_SAMPLES = 32;

/**
 * The output of samples: blocks that follow one another without a gap, as long as the next one arrives in time.
 *
 * When the last 32 samples of a block begin to sound the stream asks for the next block. A late block begins at once,
 * after a gap. Source of the double buffer: micropython-microbit-v2 modaudio.c. Left out: the mixer's own buffer, which
 * delays everything by some ms.
 */
export class SampleStream {
  private askForMore: (() => void) | null = null;
  private waiting: SampleBlock | null = null;
  private playing: { readonly block: SampleBlock; readonly startUs: number } | null = null;
  private stops: Stop[] = [];

  constructor(
    private readonly clock: Clock,
    private readonly began: (block: SampleBlock, startUs: number) => void,
  ) {}

  /** True from `open` until `close`; a waiting program waits for it. The samples of the last block still sound then. */
  get isOpen(): boolean {
    return this.askForMore !== null;
  }

  /** True while samples sound. */
  get isSounding(): boolean {
    return this.playing !== null;
  }

  /** Begins a new series of blocks and ends the current one. */
  open(askForMore: () => void): void {
    this.silence();
    this.askForMore = askForMore;
  }

  /** Hands over the next block; an empty one lasts as long as 32 samples of silence, as on the device. */
  write(block: SampleBlock): void {
    if (this.playing) this.waiting = block;
    else this.begin(block, this.clock.nowUs);
  }

  /** Ends the input; the samples already handed over sound to their end. */
  close(): void {
    this.askForMore = null;
  }

  /** Ends everything at once. @returns whether samples sounded */
  silence(): boolean {
    const sounded = this.playing !== null;
    for (const stop of this.stops) stop();
    this.stops = [];
    this.askForMore = null;
    this.waiting = null;
    this.playing = null;
    return sounded;
  }

  /** Loudness of the 32 samples that sound now: the root of their mean square, doubled; 0 in silence. */
  get level(): number {
    if (!this.playing) return 0;
    const { block, startUs } = this.playing;
    const played = ((this.clock.nowUs - startUs) * block.rate) / 1_000_000;
    const from = Math.floor(played / CHUNK_SAMPLES) * CHUNK_SAMPLES;
    let sum = 0;
    for (const sample of block.samples.slice(from, from + CHUNK_SAMPLES)) sum += (sample - 128) * (sample - 128);
    return Math.trunc(2 * Math.sqrt(Math.floor(sum / CHUNK_SAMPLES)));
  }

  private begin(block: SampleBlock, startUs: number): void {
    const chunkUs = (CHUNK_SAMPLES * 1_000_000) / block.rate;
    const chunks = Math.max(1, Math.ceil(block.samples.length / CHUNK_SAMPLES));
    const endUs = startUs + chunks * chunkUs;
    this.playing = { block, startUs };
    this.began(block, startUs);
    this.stops = [
      this.clock.at(startUs + (chunks - 1) * chunkUs, () => this.askForMore?.()),
      this.clock.at(endUs, () => this.next(endUs)),
    ];
  }

  private next(endUs: number): void {
    const block = this.waiting;
    this.waiting = null;
    this.playing = null;
    if (block) this.begin(block, endUs);
  }
}
