import type { SoundEvent } from '#board/sound/sound-event';

/** Loudness of a tone and of a full square wave, 0 … 1. Chosen: −8 dB, about as loud as other sites; it is shrill. */
export const LOUDNESS = 0.4;
/** Gain of speech. Fitted to "hello world": its highest peaks reach −4 dB; more would be clipped. */
export const SPEECH_GAIN = 1.7;
/** Gain of a program's samples, which are seldom as loud as a full square wave. Chosen. */
const SAMPLES_GAIN = 1.25;
/** Fade-in and fade-out time of a tone, in s: without it every note clicks. */
export const EDGE_S = 0.003;

/** A playing sound that can be ended. */
export interface Voice {
  readonly endS: number;
  end(atS: number): void;
}

/** A square wave that sounds until it is stopped. */
export function playTone(context: BaseAudioContext, to: AudioNode, hz: number, atS: number): Voice {
  const oscillator = context.createOscillator();
  const gain = context.createGain();
  oscillator.type = 'square'; // the output of a PWM pin
  oscillator.frequency.value = Math.min(hz, context.sampleRate / 2);
  gain.gain.value = 0;
  gain.gain.setTargetAtTime(LOUDNESS, atS, EDGE_S / 3);
  oscillator.connect(gain).connect(to);
  oscillator.start(atS);
  let untilS = Infinity;
  return {
    get endS() {
      return untilS;
    },
    end(endS) {
      untilS = endS;
      gain.gain.setTargetAtTime(0, endS, EDGE_S / 3);
      oscillator.stop(endS + 2 * EDGE_S);
    },
  };
}

/** Samples that are known from beginning to end. */
export function playSamples(
  context: BaseAudioContext,
  to: AudioNode,
  { samples, rate, loudness }: { readonly samples: Float32Array; readonly rate: number; readonly loudness: number },
  atS: number,
): Voice {
  const source = context.createBufferSource();
  const gain = context.createGain();
  gain.gain.value = loudness;
  if (samples.length > 0) {
    const buffer = context.createBuffer(1, samples.length, rate);
    buffer.getChannelData(0).set(samples);
    source.buffer = buffer; // filled first: Firefox plays the contents of the buffer at this moment
  }
  source.connect(gain).connect(to);
  source.start(atS);
  let untilS = atS + samples.length / rate;
  return {
    get endS() {
      return untilS;
    },
    end(endS) {
      if (endS >= untilS) return;
      untilS = endS;
      gain.gain.setTargetAtTime(0, endS, EDGE_S / 3);
      source.stop(endS + 2 * EDGE_S);
    },
  };
}

/** Plays samples piece by piece as they are made: the first one immediately, the others in tasks of their own. */
export function playPieces(
  context: BaseAudioContext,
  to: AudioNode,
  pieces: Iterator<Float32Array, void>,
  { rate, loudness }: { readonly rate: number; readonly loudness: number },
  atS: number,
): Voice & { readonly made: Promise<void> } {
  const seam = createSeam(context, to, loudness);
  let ended = false;
  seam.begin(atS);
  const next = (): boolean => {
    const { value, done } = pieces.next();
    if (done === true || ended) return false;
    seam.add(value, rate);
    return true;
  };
  const makeAll = async (): Promise<void> => {
    while (next()) await new Promise((resolve) => setTimeout(resolve));
  };
  return {
    made: makeAll(),
    get endS() {
      return seam.endS;
    },
    end(endS) {
      ended = true;
      seam.end(endS);
    },
  };
}

/** Creates a player for the samples of a program: one block after the other, without a seam where the run had none. */
export function createStream(context: BaseAudioContext, to: AudioNode) {
  const seam = createSeam(context, to, LOUDNESS * SAMPLES_GAIN);
  let endUs = -1;
  return {
    get endS(): number {
      return seam.endS;
    },
    play(block: Extract<SoundEvent, { type: 'samples' }>, atS: number): void {
      const follows = Math.abs(block.startUs - endUs) < 1 && Math.abs(atS - seam.endS) < MOST_SHIFT_S;
      if (!follows) seam.begin(atS);
      seam.add(
        Float32Array.from(block.samples, (sample) => (sample - 128) / 128),
        block.rate,
      );
      endUs = block.startUs + (block.samples.length * 1_000_000) / block.rate;
    },
    end(atS: number): void {
      seam.end(atS);
      endUs = -1;
    },
  };
}

/** Largest gap between a block and the end of the previous one after a synchronisation of the clocks, in s. */
const MOST_SHIFT_S = 0.05;

/** Joins stretches of samples without a gap or an overlap, at any rate. */
function createSeam(context: BaseAudioContext, to: AudioNode, loudness: number) {
  const gain = context.createGain();
  gain.gain.value = loudness;
  gain.connect(to);
  /** Start of the next stretch, in frames of the sound system; not rounded, so that errors do not add up. */
  let place = 0;
  let last = 0;
  let running: AudioBufferSourceNode[] = [];
  return {
    get endS(): number {
      return place / context.sampleRate;
    },
    begin(atS: number): void {
      place = Math.round(atS * context.sampleRate);
      last = 0;
    },
    add(samples: Float32Array, rate: number): void {
      const from = Math.round(place);
      place += (samples.length / rate) * context.sampleRate;
      const buffer = context.createBuffer(1, Math.max(1, Math.round(place) - from), context.sampleRate);
      last = stretch(samples, last, buffer.getChannelData(0));
      const source = context.createBufferSource();
      source.buffer = buffer;
      source.connect(gain);
      source.start(from / context.sampleRate);
      source.onended = () => {
        running = running.filter((other) => other !== source);
      };
      running.push(source);
    },
    end(atS: number): void {
      for (const source of running) source.stop(atS);
      running = [];
      place = Math.min(place, atS * context.sampleRate);
    },
  };
}

/** Fills frames from samples with straight lines between them, as modaudio.c does. @returns the last value */
function stretch(samples: Float32Array, before: number, frames: Float32Array): number {
  const valueAt = (place: number): number => (place < 0 ? before : (samples[place] ?? 0));
  for (let i = 0; i < frames.length; i++) {
    const place = ((i + 1) * samples.length) / frames.length - 1;
    const whole = Math.floor(place);
    frames[i] = valueAt(whole) + (valueAt(whole + 1) - valueAt(whole)) * (place - whole);
  }
  return valueAt(samples.length - 1);
}
