import { describe, expect, it } from 'vitest';
import type { SoundEvent } from '#board/sound/sound-event';
import { createHalBench } from '../testing/hal-bench';

const EFFECT = ['3', '1023', '0500', '0500', '01', '0'.repeat(54)].join('').padEnd(72, '0').slice(0, 72);

describe('sound syscalls', () => {
  it('plays an effect and waits for its 500 ms, a callback in between being told', () => {
    const { call, interrupted, timed } = createHalBench();
    call('audio_effect', EFFECT);
    expect(interrupted(100_000, 'audio_wait')).toBe(true);
    expect(timed('audio_wait').us).toBeGreaterThan(390_000);
    expect(call('audio_playing')).toBe(false);
  });

  it('knows the built-in sounds by name, and is silent for anything else', () => {
    const { bench, call } = createHalBench();
    call('audio_effect', 'twinkle');
    expect(call('audio_playing')).toBe(true);
    call('audio_stop', false);
    expect(call('audio_playing')).toBe(true);
    call('audio_stop', true);
    call('audio_effect', 'bark');
    expect([call('audio_playing'), bench.board.sound.effectUntilUs < bench.clock.nowUs]).toEqual([false, true]);
  });

  it('draws the chance of a sound from the seed', () => {
    const lengthUs = (): number => {
      const { bench, call } = createHalBench();
      call('audio_effect', 'giggle');
      return bench.board.sound.effectUntilUs;
    };
    expect(lengthUs()).toBe(lengthUs());
  });

  it('queues the callback whenever the next frame is due', () => {
    const { bench, call, put, queued } = createHalBench();
    const address = put(Array.from({ length: 32 }, () => 200));
    call('audio_open', 7);
    call('audio_frame', address, 32, 7812);
    bench.passMs(1);
    expect([queued, call('audio_frames'), call('audio_level')]).toEqual([[7], true, 144]);
    call('audio_frame', address, 32, 7812);
    bench.passMs(4);
    expect(queued).toEqual([7, 7]);
    call('audio_close');
    expect([call('audio_wait'), call('audio_frames')]).toEqual([false, false]);
  });

  it('takes over the samples of the moment: what is written later is not heard', () => {
    const { bench, call, put, memory } = createHalBench();
    const events: SoundEvent[] = [];
    bench.board.sound.onEvent((event) => events.push(event));
    const address = put([1, 2, 3]);
    call('audio_open', 1);
    call('audio_frame', address, 3, 1000);
    memory[address] = 99;
    expect(events).toEqual([
      {
        timeUs: expect.any(Number) as number,
        type: 'samples',
        startUs: expect.any(Number) as number,
        rate: 1000,
        samples: [1, 2, 3],
      },
    ]);
  });

  it('adds, subtracts and scales samples within 0 … 255', () => {
    const { call, put, memory } = createHalBench();
    const a = put([128, 200, 0], 100);
    const b = put([100, 250, 0], 200);
    call('samples_add', a, b, 3, 1);
    expect([...memory.subarray(a, a + 3)]).toEqual([100, 255, 0]);
    call('samples_add', a, b, 3, -1);
    expect([...memory.subarray(a, a + 3)]).toEqual([128, 133, 128]);
    call('samples_multiply', a, 3, -2.5);
    expect([...memory.subarray(a, a + 3)]).toEqual([128, 115, 128]);
  });

  it('sends the sound to a pin, refuses a held one and the speaker', () => {
    const { bench, call } = createHalBench();
    expect([call('audio_pin', 1), bench.board.pin('pin1').mode]).toEqual([null, 'audio']);
    expect(call('audio_pin', 3)).toBe('Pin 3 in display mode');
    expect(call('audio_pin', bench.board.pin('pin_speaker').number)).toBe('pin_speaker not allowed');
    expect([call('audio_pin', -1), bench.board.pin('pin1').mode]).toEqual([null, 'unused']);
  });

  it('translates and says words, and waits until they are said', () => {
    const { bench, call, timed } = createHalBench();
    expect([call('speech_translate', 'hello'), call('speech_translate', 'ö')]).toEqual(['/HEH4LOW', null]);
    const settings = 64 | (72 << 8) | (128 << 16);
    expect(call('speech_say', 'QX', settings, 128, false)).toBe(false);
    expect(call('speech_say', 'AA', settings, 128, false)).toBe(true);
    expect(timed('speech_wait').us).toBe(140_000);
    call('speech_say', 'AA', settings, 128, false);
    call('speech_stop');
    expect(bench.board.sound.speechUntilUs).toBeLessThanOrEqual(bench.clock.nowUs);
  });

  it('sets the volume and switches the speaker', () => {
    const { bench, call } = createHalBench();
    call('set_volume', 40);
    call('speaker', false);
    expect([bench.board.sound.volume, bench.board.sound.isSpeakerOn]).toEqual([40, false]);
  });
});
