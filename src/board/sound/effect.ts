import type { Rng } from '#core/rng';

/** One part of a sound effect, random values drawn. Source: codal-microbit-v2 SoundExpressions.cpp. */
export interface EffectPart {
  /** 0 sine, 1 sawtooth, 2 triangle, 3 square, 4 noise. */
  readonly waveform: number;
  /** 0 … 1023. */
  readonly startVolume: number;
  readonly endVolume: number;
  readonly startHz: number;
  readonly endHz: number;
  readonly durationMs: number;
  /**
   * Course of the frequency: 0 constant, 1 linear, 2 curve, 5 and 6 rising and falling, 8 … 17 scales, 18 logarithmic.
   */
  readonly shape: number;
  /** Number of steps of the frequency. */
  readonly steps: number;
  /** 0 none, 1 vibrato, 2 tremolo, 3 warble. */
  readonly fx: number;
  readonly fxParameter: number;
  /** In 10 s. */
  readonly fxSteps: number;
}

/** Position of each field in a part: first digit, number of digits, first digit of its random range. */
const FIELDS = {
  waveform: [0, 1, null],
  startVolume: [1, 4, 52],
  startHz: [5, 4, 44],
  durationMs: [9, 4, 60],
  shape: [13, 2, null],
  endHz: [18, 4, 48],
  endVolume: [26, 4, 56],
  steps: [30, 4, null],
  fx: [34, 2, null],
  fxParameter: [36, 4, 64],
  fxSteps: [40, 4, 68],
} as const satisfies Record<keyof EffectPart, readonly [number, number, number | null]>;

/** The order in which the device draws its random values. */
const DRAWN = ['startHz', 'endHz', 'startVolume', 'endVolume', 'durationMs', 'fxParameter', 'fxSteps'] as const;
const CHANCE_DIGITS = 4;

/**
 * Reads a sound effect: parts of 72 digits with a comma between them.
 *
 * @param chance draws the random part of a field: up to this much more or less
 * @returns `null` for anything else; the device then plays nothing
 */
export function readEffect(text: string, chance: Rng): readonly EffectPart[] | null {
  const parts: EffectPart[] = [];
  for (const part of text.split(',')) {
    if (!/^\d{72}$/.test(part)) return null;
    parts.push(readPart(part, chance));
  }
  return parts;
}

function readPart(text: string, chance: Rng): EffectPart {
  const number = (from: number, digits: number): number => Number(text.slice(from, from + digits));
  const field = (name: keyof EffectPart): number => number(FIELDS[name][0], FIELDS[name][1]);
  const drawn: Partial<Record<keyof EffectPart, number>> = {};
  for (const name of DRAWN) {
    const range = number(FIELDS[name][2], CHANCE_DIGITS);
    const delta = range > 0 ? (chance.u32() % (2 * range + 1)) - range : 0;
    drawn[name] = Math.abs(field(name) + delta);
  }
  const value = (name: keyof EffectPart): number => drawn[name] ?? field(name);
  return {
    waveform: value('waveform'),
    startVolume: Math.min(value('startVolume'), MAX_VOLUME),
    endVolume: Math.min(value('endVolume'), MAX_VOLUME),
    startHz: value('startHz'),
    endHz: value('endHz'),
    durationMs: value('durationMs'),
    shape: value('shape'),
    steps: value('steps'),
    fx: value('fx'),
    fxParameter: value('fxParameter'),
    fxSteps: value('fxSteps'),
  };
}

const MAX_VOLUME = 1023;

/** Duration of an effect, in ms. */
export function effectMs(parts: readonly EffectPart[]): number {
  return parts.reduce((sum, part) => sum + part.durationMs, 0);
}
