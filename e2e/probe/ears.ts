import type { SoundEvent } from '#board/sound/sound-event';
import { SoundMixer } from '../../src/web/session/run/sound/sound-mixer';
import * as synthesis from '../../src/web/session/run/sound/synthesis';

/** A stretch of time, in ms. */
export interface Stretch {
  readonly fromMs: number;
  readonly toMs: number;
}

/** The sounds that were heard. */
export interface Heard {
  /** Root mean square of each ms, in thousandths of full scale. */
  readonly loudness: readonly number[];
  /** The largest sample, 1 being full scale. */
  readonly peak: number;
  /** For each stretch asked for: its loudest frequency in Hz, to about 1 Hz. */
  readonly peaksHz: readonly number[];
}

const RATE = 48_000;

/** Plays sound events into a recording, time 0 being the begin of the run, and listens to it. */
export async function hear(
  events: readonly SoundEvent[],
  forMs: number,
  stretches: readonly Stretch[],
): Promise<Heard> {
  const context = new OfflineAudioContext(1, (forMs * RATE) / 1000, RATE);
  const mixer = new SoundMixer(context);
  for (const event of events) mixer.play(event, event.timeUs / 1_000_000, synthesis);
  await mixer.made;
  const samples = (await context.startRendering()).getChannelData(0);
  const part = ({ fromMs, toMs }: Stretch): Float32Array =>
    samples.subarray((fromMs * RATE) / 1000, (toMs * RATE) / 1000);
  const loudness = Array.from({ length: forMs }, (_, ms) => Math.round(rms(part({ fromMs: ms, toMs: ms + 1 })) * 1000));
  const peak = samples.reduce((most, sample) => Math.max(most, Math.abs(sample)), 0);
  return { loudness, peak, peaksHz: stretches.map((stretch) => peakHz(part(stretch))) };
}

function rms(samples: Float32Array): number {
  return Math.sqrt(samples.reduce((sum, sample) => sum + sample * sample, 0) / Math.max(samples.length, 1));
}

/** The loudest frequency between 50 Hz and 6 kHz: a discrete Fourier transform in steps of 1 Hz, with a Hann window. */
function peakHz(samples: Float32Array): number {
  const windowed = samples.map((sample, i) => sample * (0.5 - 0.5 * Math.cos((2 * Math.PI * i) / samples.length)));
  let best = { hz: 0, power: 0 };
  for (let hz = 50; hz <= 6000; hz += best.power > 0 && hz > 2000 ? 5 : 1) {
    const power = powerAt(windowed, hz);
    if (power > best.power) best = { hz, power };
  }
  return best.hz;
}

/** Goertzel's algorithm. */
function powerAt(samples: Float32Array, hz: number): number {
  const factor = 2 * Math.cos((2 * Math.PI * hz) / RATE);
  let last = 0;
  let beforeLast = 0;
  for (const sample of samples) [last, beforeLast] = [sample + factor * last - beforeLast, last];
  return last * last + beforeLast * beforeLast - factor * last * beforeLast;
}
