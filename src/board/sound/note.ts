/** Settings that a note leaves to the next one: octave and length. */
export interface NoteMemory {
  readonly octave: number;
  /** In ticks, 0 … 255. */
  readonly ticks: number;
}

/** A note as the device understands it. */
export interface Note {
  /** Period of the tone in µs, or `null` for silence. */
  readonly periodUs: number | null;
  /** Octave and length from now on, including this note's length. */
  readonly memory: NoteMemory;
}

/**
 * Periods in µs of the octave of middle C, a … g. Source: micropython-microbit-v2 modmusic.c.
 * @license micropython-microbit-v2 (pictures, melodies, pitches): MIT. Copyright (c) 2015-2020 Damien P. George.
 */
const NATURAL_US: readonly number[] = [2273, 2025, 3822, 3405, 3034, 2863, 2551];
/** The sharps a# … g#; 0 for a missing one. Same source. */
const SHARP_US: readonly number[] = [2145, 0, 3608, 3214, 0, 2703, 2408];

const A = 0;
const B = 1;
const G = 6;
const MIDDLE_OCTAVE = 4;

/**
 * Reads a note `name[#|b][octave][:ticks]`, name a … g or r for a rest.
 *
 * There are no errors, as on the device (modmusic.c, start_note): unknown characters are skipped, so `c5,1` is a c5
 * with the length of the previous note. Letters, digits and signs count by the low bits of their character. A note that
 * is not in the tables (e#, b#, fb, cb, h) is silent for its length; the device reads beyond its table.
 */
export function readNote(text: string, memory: NoteMemory): Note {
  let letter = ((text.charCodeAt(0) & 0x1f) - 1) & 0xff; // a = 0 … g = 6, r = 17, nothing = 255
  let { octave, ticks } = memory;
  let place = 1;
  let octaveShift = 0;
  const sign = text[place];
  const sharp = sign === '#' || sign === 'b';
  if (sharp) place++;
  if (sign === 'b') {
    letter = letter === A ? G : letter - 1;
    if (letter === B) octaveShift = -1;
  }
  if (place < text.length && text[place] !== ':') octave = text.charCodeAt(place++) & 0xf;
  if (text[place] === ':' && place + 1 < text.length) {
    ticks = text.charCodeAt(place + 1) & 0xf;
    if (place + 2 < text.length) ticks = ticks * 10 + (text.charCodeAt(place + 2) & 0xf);
  }
  const base = (sharp ? SHARP_US : NATURAL_US)[letter] ?? 0;
  const up = octave + octaveShift - MIDDLE_OCTAVE;
  const periodUs = up >= 0 ? base >> up : base << -up;
  return { periodUs: periodUs > 0 ? periodUs : null, memory: { octave, ticks } };
}
