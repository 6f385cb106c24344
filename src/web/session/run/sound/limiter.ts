/** Up to this level nothing is changed, so that a single source is unaffected. */
const KNEE = 0.7;
/** The highest sum that all sources together can reach. */
const MOST = 4;
const POINTS = 8193; // every 0.001: straight between them

/** The limited level of a sum of sources: unchanged up to the knee, then flattening out, never above 1. */
export function limited(sum: number): number {
  const size = Math.abs(sum);
  if (size <= KNEE) return sum;
  return Math.sign(sum) * (KNEE + (1 - KNEE) * Math.tanh((size - KNEE) / (1 - KNEE)));
}

/**
 * Puts a limiter before the loudspeaker, without delay: tone, effect, speech and samples at once would exceed full scale,
 * and the browser would clip them.
 *
 * @returns the node to play into
 */
export function createLimiter(context: BaseAudioContext): AudioNode {
  const input = context.createGain();
  const shaper = context.createWaveShaper();
  input.gain.value = 1 / MOST;
  shaper.curve = Float32Array.from({ length: POINTS }, (_, at) => limited(((2 * at) / (POINTS - 1) - 1) * MOST));
  input.connect(shaper).connect(context.destination);
  return input;
}
