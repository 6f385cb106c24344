import { describe, expect, it } from 'vitest';
import { createHalBench } from '../testing/hal-bench';

describe('music syscalls', () => {
  it('plays a pitch on pin 0 until it is stopped', () => {
    const { bench, call } = createHalBench();
    expect(call('music_pitch', 440, -1, 0)).toBeNull();
    expect(bench.board.wire('P0').pwm?.periodUs).toBe(2272);
    expect(bench.board.music.frequencyHz).toBeCloseTo(440, 0);
    call('music_stop');
    expect(bench.board.wire('P0').pwm).toBeNull();
  });

  it('waits for notes and notices a callback in between', () => {
    const { bench, call, interrupted } = createHalBench();
    call('music_play', '\nc4:4\nr:2', -1, false);
    expect(interrupted(100_000, 'music_busy')).toBe(true);
    expect(call('music_busy')).toBe(false);
    expect(bench.nowMs).toBeGreaterThanOrEqual(750);
  });

  it('says which pin is held, and takes any pitch', () => {
    const { call } = createHalBench();
    expect(call('music_pitch', 440, -1, 3)).toBe('Pin 3 in display mode');
    expect(call('music_pitch', -100, 10, 0)).toBeNull();
  });

  it('keeps the tempo until it is reset', () => {
    const { call } = createHalBench();
    call('music_set_tempo', 60, 0);
    expect([call('music_bpm'), call('music_ticks')]).toEqual([60, 4]);
    call('music_reset');
    expect([call('music_bpm'), call('music_ticks')]).toEqual([120, 4]);
  });
});
