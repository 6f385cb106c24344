import { describe, expect, it } from 'vitest';
import { readNote } from './note';
import { createBench } from '../testing/bench';

const START = { octave: 4, ticks: 4 };

/** A board with its music, and a record of its sounds. */
function bench() {
  const table = createBench();
  const { music } = table.board;
  const pin = table.board.pin('pin0');
  /** Plays to the end and returns the beginning and end of each tone, in ms and whole Hz. */
  const hear = (notes: readonly string[]): string[] => {
    expect(music.play(notes, { pin, loop: false })).toBeNull();
    const heard: string[] = [];
    let before = music.frequencyHz;
    while (music.isPlaying) {
      const atMs = table.waitUntil(() => music.frequencyHz !== before || !music.isPlaying);
      before = music.frequencyHz;
      heard.push(`${atMs}: ${before === null ? 'silence' : Math.round(before)}`);
    }
    return heard;
  };
  return { ...table, music, pin, hear };
}

/** The period of a note in µs. */
function period(text: string): number | null {
  return readNote(text, START).periodUs;
}

describe('music', () => {
  it('M1: two crotchets begin at 6 and 510 ms and sound for 492 ms each', () => {
    const { hear } = bench();
    expect(hear(['c4:4', 'd'])).toEqual(['6: 262', '498: silence', '510: 294', '1002: silence', '1014: silence']);
  });

  it('M2: a very short note still sounds for 12 ms', () => {
    const { hear, music } = bench();
    music.setTempo({ bpm: 6000 });
    expect(hear(['a4:1'])).toEqual(['6: 440', '18: silence', '30: silence']);
  });

  it('M3: octave and length stick, and every tune begins with octave 4 and four ticks', () => {
    const { hear } = bench();
    expect(hear(['a5:1', 'a'])).toEqual(['6: 880', '126: silence', '138: 880', '258: silence', '270: silence']);
    expect(hear(['a'])).toEqual(['276: 440', '768: silence', '780: silence']);
  });

  it('M4: c5,1 is a c5 of the length before', () => {
    expect(readNote('c5,1', { octave: 3, ticks: 2 })).toEqual({ periodUs: 1911, memory: { octave: 5, ticks: 2 } });
    expect(bench().hear(['c5,1'])).toEqual(['6: 523', '498: silence', '510: silence']);
  });

  it('M4: an empty note, signs and a length of three digits do not disturb the music', () => {
    expect(readNote('', START)).toEqual({ periodUs: null, memory: START });
    expect(readNote('?!', START)).toEqual({ periodUs: null, memory: { octave: 1, ticks: 4 } });
    expect(readNote('c:123', START).memory.ticks).toBe(12);
    expect(readNote('c4:', START).memory).toEqual(START);
  });

  it('M4: sharps and flats are the notes between, in every octave', () => {
    expect([period('c#'), period('db'), period('ab'), period('bb'), period('C#')]).toEqual([
      3608, 3608, 2408, 2145, 3608,
    ]);
    expect([period('a3'), period('a4'), period('a5'), period('a8')]).toEqual([4546, 2273, 1136, 142]);
  });

  it('M5: a rest is silence of its length', () => {
    expect(bench().hear(['r:2', 'a:4'])).toEqual(['258: 440', '750: silence', '762: silence']);
    expect([period('r'), period('e#'), period('b#'), period('h')]).toEqual([null, null, null, null]);
  });

  it('M6: a pitch of 500 ms sounds at once and for 504 ms, and has ended at 516 ms', () => {
    const { music, pin, waitUntil } = bench();
    expect(music.pitch(440, 500, pin)).toBeNull();
    expect(music.frequencyHz).toBeCloseTo(440, 0);
    expect(waitUntil(() => music.frequencyHz === null)).toBe(504);
    expect(waitUntil(() => !music.isPlaying)).toBe(516);
    expect(pin.mode).toBe('unused');
  });

  it('M6: 0 Hz is silence for the time; so is less than that or more than 1 MHz, and the pin stays with the music', () => {
    const { music, pin, waitUntil } = bench();
    music.pitch(0, 100, pin);
    expect(music.frequencyHz).toBeNull();
    expect(waitUntil(() => !music.isPlaying)).toBe(114);
    for (const hz of [-100, 2_000_000]) {
      expect(music.pitch(hz, 100, pin)).toBeNull();
      expect([music.frequencyHz, music.isPlaying, pin.mode]).toEqual([null, true, 'music']);
      waitUntil(() => !music.isPlaying);
      expect(pin.mode).toBe('unused');
    }
  });

  it('M7: a pitch without duration sounds until it is stopped', () => {
    const { music, pin, passMs } = bench();
    music.pitch(880, -1, pin);
    expect(music.isPlaying).toBe(false);
    passMs(100_000);
    expect(music.frequencyHz).toBeCloseTo(880, 0);
    music.stop();
    expect(music.frequencyHz).toBeNull();
  });

  it('M8: the pin belongs to the music while it plays, and pin 3 is refused', () => {
    const { board, music, pin } = bench();
    expect(music.play(['c'], { pin: board.pin('pin3'), loop: false })).toBe('Pin 3 in display mode');
    expect(music.isPlaying).toBe(false);
    music.play(['c'], { pin, loop: false });
    expect(pin.acquire('write_digital')).toBe('music');
    music.stop();
    expect(pin.acquire('write_digital')).toBeNull();
  });

  it('M8: a new tune on another pin gives the first one back', () => {
    const { board, music, pin } = bench();
    music.play(['c'], { pin, loop: true });
    music.play(['c'], { pin: board.pin('pin1'), loop: true });
    expect(pin.mode).toBe('unused');
    expect(board.pin('pin1').mode).toBe('music');
    music.play(['c'], { pin: null, loop: true });
    expect(board.pin('pin1').mode).toBe('unused');
  });

  it('M9: at 130 beats a minute and 8 ticks to the beat a tick lasts 57 ms', () => {
    const { music, hear } = bench();
    music.setTempo({ bpm: 130, ticks: 8 });
    expect(hear(['a4:8'])).toEqual(['6: 440', '456: silence', '468: silence']);
    music.setTempo({ bpm: 0 });
    expect(music.tempo).toEqual({ bpm: 130, ticks: 8 });
    music.resetTempo();
    expect(music.tempo).toEqual({ bpm: 120, ticks: 4 });
  });

  it('M9: absurd tempos play short notes instead of failing', () => {
    const { music, hear } = bench();
    music.setTempo({ bpm: 65_536 });
    expect(hear(['a'])).toEqual(['6: 440', '18: silence', '30: silence']);
  });

  it('M10: with loop it plays on, an empty tune ends at the next tick', () => {
    const { music, pin, passMs, waitUntil } = bench();
    music.play([], { pin, loop: true });
    expect(waitUntil(() => !music.isPlaying)).toBe(6);
    music.play(['a', 'r'], { pin, loop: true });
    passMs(60_000);
    expect(music.isPlaying).toBe(true);
  });

  it('M11: pin 0 carries 440 Hz while pin 1 keeps its 20 ms', () => {
    const { board, music, pin, record, passMs } = bench();
    board.pin('pin1').writeAnalog(512);
    const happened = record('P0');
    music.pitch(440, 100, pin);
    passMs(200);
    expect(happened).toEqual(['0 ms: 1136 of 2272 µs high', '102 ms: no PWM']);
    expect(board.wire('P1').pwm?.periodUs).toBe(20_000);
  });
});
