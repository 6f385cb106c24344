import { describe, expect, it } from 'vitest';
import { createRng } from '#core/rng';
import { createBench } from '../testing/bench';
import { BUILT_IN_SOUNDS } from './built-in-sounds';
import { effectMs, readEffect, type EffectPart } from './effect';
import type { SoundEvent } from './sound-event';
import { utter } from './utter';

const VOICE = { pitch: 64, speed: 72, mouth: 128, throat: 128, sings: false };
const SILENT_FRAME = { samples: Array.from({ length: 32 }, () => 128), rate: 7812 };

/** A board whose sound is written down: `['5 ms: effect']`. */
function bench() {
  const table = createBench();
  const events: SoundEvent[] = [];
  const lines: string[] = [];
  table.board.sound.onEvent((event) => {
    events.push(event);
    lines.push(
      `${Math.round(event.timeUs / 1000)} ms: ${event.type}${event.type === 'silence' ? ` of ${event.source}` : ''}`,
    );
  });
  return { ...table, sound: table.board.sound, events, lines };
}

function effect(durationMs: number): readonly EffectPart[] {
  const [part] = readEffect(BUILT_IN_SOUNDS['twinkle'] ?? '', createRng(1)) ?? [];
  if (!part) throw new Error('There is no sound twinkle.');
  return [{ ...part, durationMs }];
}

function words(phonemes: string) {
  const utterance = utter(phonemes, VOICE);
  if (!utterance) throw new Error(`${phonemes} are no phonemes.`);
  return utterance;
}

describe('sound', () => {
  it('V1: all four sources sound together, and a second effect replaces the first', () => {
    const { board, sound, lines, passMs } = bench();
    board.music.pitch(440, -1, null);
    sound.playEffect(effect(500));
    sound.speak(words('AA'));
    sound.stream.open(() => undefined);
    sound.stream.write(SILENT_FRAME);
    passMs(100);
    sound.playEffect(effect(50));
    expect(lines).toEqual(['0 ms: tone', '0 ms: effect', '0 ms: speech', '0 ms: samples', '100 ms: effect']);
    expect([sound.effectUntilUs, sound.isSounding]).toEqual([150_000, true]);
    passMs(50);
    expect(sound.isSounding).toBe(false);
  });

  it('V2: the built-in sounds last as long as their parts, give or take their chance', () => {
    const lengths = (seed: number) =>
      Object.fromEntries(
        Object.entries(BUILT_IN_SOUNDS).map(([name, text]) => [
          name,
          effectMs(readEffect(text, createRng(seed)) ?? []),
        ]),
      );
    expect(lengths(1)).toMatchObject({ hello: 506, sad: 1644, twinkle: 6722 });
    expect(lengths(1)).toEqual(lengths(1));
    expect(lengths(1)).not.toEqual(lengths(2));
    expect(Math.abs((lengths(1)['giggle'] ?? 0) - 1491)).toBeLessThanOrEqual(190);
  });

  it('V2: an effect of 300 ms ends at 300 ms', () => {
    const { sound, passMs, nowMs } = bench();
    passMs(7);
    sound.playEffect(effect(300));
    expect([nowMs, sound.effectUntilUs]).toEqual([0, 307_000]);
  });

  it('V3: a text that is no effect is read as none', () => {
    for (const text of ['', '123', 'x'.repeat(72), `${'0'.repeat(72)},`, `${'0'.repeat(72)};${'0'.repeat(72)}`]) {
      expect(readEffect(text, createRng(1))).toBeNull();
    }
    expect(readEffect('0'.repeat(72), createRng(1))).toHaveLength(1);
  });

  it('V4: ten frames of 32 samples follow one another every 4.096 ms', () => {
    const { sound, events, passMs } = bench();
    let left = 10;
    const next = (): void => (left-- > 0 ? sound.stream.write(SILENT_FRAME) : sound.stream.close());
    sound.stream.open(next);
    next();
    passMs(100);
    const starts = events.flatMap((event) => (event.type === 'samples' ? [Math.round(event.startUs)] : []));
    expect(starts).toEqual([0, 4096, 8193, 12_289, 16_385, 20_481, 24_578, 28_674, 32_770, 36_866]);
    expect(sound.stream.isOpen).toBe(false);
  });

  it('V4: a block of 33 samples takes as long as 64', () => {
    const { sound, events, passMs } = bench();
    sound.stream.open(() => undefined);
    sound.stream.write({ samples: Array.from({ length: 33 }, () => 0), rate: 1000 });
    sound.stream.write({ samples: [0], rate: 1000 });
    passMs(1000);
    expect(events.map((event) => (event.type === 'samples' ? event.startUs : null))).toEqual([0, 64_000]);
  });

  it('V5: a long block asks for the next one 32 samples before its end, a late one begins at once', () => {
    const { sound, events, clock, passMs } = bench();
    const asked: number[] = [];
    sound.stream.open(() => asked.push(clock.nowUs / 1000));
    sound.stream.write({ samples: Array.from({ length: 320 }, () => 128), rate: 1000 });
    passMs(400);
    sound.stream.write(SILENT_FRAME);
    expect(asked).toEqual([288]);
    expect(events.map((event) => (event.type === 'samples' ? event.startUs : null))).toEqual([0, 400_000]);
  });

  it('V5: the level is that of the 32 samples that sound now', () => {
    const { sound, passMs } = bench();
    const samples = [...Array.from({ length: 32 }, () => 228), ...Array.from({ length: 32 }, () => 118)];
    sound.stream.open(() => undefined);
    sound.stream.write({ samples, rate: 1000 });
    passMs(10);
    expect(sound.stream.level).toBe(200);
    passMs(30);
    expect(sound.stream.level).toBe(20);
    passMs(30);
    expect(sound.stream.level).toBe(0);
  });

  it('V6: the vowel AA is spoken for 140 ms, and can be cut short', () => {
    const { sound, lines, passMs } = bench();
    sound.speak(words('AA'));
    expect(sound.speechUntilUs).toBe(140_000);
    passMs(40);
    sound.silence('speech');
    sound.silence('speech');
    expect([sound.speechUntilUs, lines]).toEqual([40_000, ['0 ms: speech', '40 ms: silence of speech']]);
  });

  it('V7: choosing pin 1 gives pin 0 back', () => {
    const { board, sound, events } = bench();
    expect(sound.route.select(board.pin('pin0'), 'audio')).toBeNull();
    expect(sound.route.select(board.pin('pin1'), 'music')).toBeNull();
    expect([board.pin('pin0').mode, board.pin('pin1').mode]).toEqual(['unused', 'music']);
    expect(sound.route.select(board.pin('pin3'), 'music')).toBe('Pin 3 in display mode');
    expect(events.map((event) => (event.type === 'output' ? event.pin : null))).toEqual(['pin0', null, 'pin1', null]);
  });

  it('V8: a pin in audio mode can be taken, and the sound goes on without it', () => {
    const { board, sound } = bench();
    const pin = board.pin('pin0');
    sound.route.select(pin, 'audio');
    sound.playEffect(effect(100));
    pin.writeDigital(1);
    expect([sound.route.current, pin.mode, sound.effectUntilUs]).toEqual([null, 'write_digital', 100_000]);
    sound.route.free();
    expect(pin.mode).toBe('write_digital');
  });

  it('V8: music goes on when its pin is freed by something else', () => {
    const { board, passMs } = bench();
    const pin = board.pin('pin0');
    board.music.play(['a4', 'a5'], { pin, loop: true });
    passMs(10);
    pin.free();
    passMs(700);
    expect(board.music.frequencyHz).toBeCloseTo(880, 0);
    expect([pin.mode, board.wire('P0').pwm]).toEqual(['unused', null]);
    board.music.stop();
    expect(pin.mode).toBe('unused');
  });

  it('V9: the volume is 255 after a start, and 300 changes nothing', () => {
    const { sound } = bench();
    const seen = [sound.volume];
    for (const volume of [100, 300, -1]) {
      sound.setVolume(volume);
      seen.push(sound.volume);
    }
    expect(seen).toEqual([255, 100, 100, 100]);
  });

  it('V10: a reset ends everything and puts volume and speaker back', () => {
    const { board, sound, lines, passMs } = bench();
    sound.setVolume(10);
    sound.setSpeaker(false);
    sound.playEffect(effect(5000));
    sound.route.select(board.pin('pin1'), 'audio');
    passMs(1);
    lines.length = 0;
    board.reset();
    expect([sound.volume, sound.isSpeakerOn, board.pin('pin1').mode]).toEqual([255, true, 'unused']);
    expect(lines).toEqual(['1 ms: output', '1 ms: silence of effect', '1 ms: volume', '1 ms: output']);
  });

  it('V11: a melody is told note by note, and who stops listening hears no more', () => {
    const { board, events, passMs } = bench();
    board.music.play(['c4:1', 'd'], { pin: null, loop: false });
    passMs(400);
    board.music.stop();
    const told = events.map((event) =>
      event.type === 'tone' ? [event.timeUs / 1000, Math.round(event.hz ?? 0)] : null,
    );
    expect(told).toEqual([
      [6, 262],
      [126, 0],
      [138, 294],
      [258, 0],
    ]);
    const heard: SoundEvent[] = [];
    const stop = board.sound.onEvent((event) => heard.push(event));
    stop();
    board.music.pitch(440, -1, null);
    expect(heard).toEqual([]);
  });
});
