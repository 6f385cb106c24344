import { describe, expect, it } from 'vitest';
import type { SoundEvent } from '#board/sound/sound-event';
import { microbitV2 } from '#board/boards/microbit-v2';
import { LATER, linesOf, play } from './testing/play';

/** Programs start on a whole ms, so that ms are exact. */
const AT_MS = `
def exact(f, *a, **k):
    now = running_time()
    while running_time() == now: pass
    return took(f, *a, **k)
`;

describe('audio: sounds and effects', () => {
  it('plays a sound effect for exactly its duration', () => {
    const program = `${AT_MS}
e = audio.SoundEffect(duration=300)
print(exact(audio.play, e), exact(audio.play, [e, e]), exact(audio.play, e, wait=False), audio.is_playing())
sleep(310)
print(audio.is_playing())`;
    expect(linesOf(program)).toEqual(['300 600 0 True', 'False']);
  });

  it('plays the built-in sounds for as long as their parts say', () => {
    const program = `${AT_MS}
print(exact(audio.play, Sound.HELLO), exact(audio.play, Sound.SAD), exact(audio.play, Sound.TWINKLE))
print(1391 - 90 <= exact(audio.play, Sound.GIGGLE) <= 1491 + 190)
print(Sound.GIGGLE, [n for n in sorted(dir(Sound)) if n[0] != '_'])`;
    expect(linesOf(program)).toEqual([
      '506 1644 6722',
      'True',
      "Sound('giggle') ['GIGGLE', 'HAPPY', 'HELLO', 'MYSTERIOUS', 'SAD', 'SLIDE', 'SOARING', 'SPRING', 'TWINKLE', 'YAWN']",
    ]);
  });

  it('has the defaults, the texts and the copies of the device', () => {
    const program = `
e = audio.SoundEffect()
print(repr(e))
print(e)
c = e.copy()
c.freq_start = 100
c.vol_start = 10
c.shape = 3
err(setattr, c, 'fx', None)
err(audio.SoundEffect, fx=None)
print(e.freq_start, c.freq_start, c.vol_start, c.fx)
print(c)
print(audio.SoundEffect(1, 2, 3, 4, 5, audio.SoundEffect.WAVEFORM_NOISE, audio.SoundEffect.FX_WARBLE, 2))
print(repr(audio.SoundEffect._from_string("010230988019008440044008881023001601003300240000000000000000000000000000")))`;
    expect(linesOf(program)).toEqual([
      'SoundEffect(500, 2500, 500, 255, 0, 3, 0, 18)',
      'SoundEffect(freq_start=500, freq_end=2500, duration=500, vol_start=255, vol_end=0, waveform=WAVEFORM_SQUARE, fx=FX_NONE, shape=SHAPE_LOG)',
      "TypeError: can't convert NoneType to int",
      "TypeError: can't convert NoneType to int",
      '500 100 10 0',
      'SoundEffect(freq_start=100, freq_end=2500, duration=500, vol_start=10, vol_end=0, waveform=WAVEFORM_SQUARE, fx=FX_NONE, shape=3)',
      'SoundEffect(freq_start=1, freq_end=2, duration=3, vol_start=4, vol_end=5, waveform=WAVEFORM_NOISE, fx=FX_WARBLE, shape=SHAPE_CURVE)',
      'SoundEffect(988, 440, 190, 255, 255, 0, 1, 8)',
    ]);
  });

  it('refuses values that are too large in the words of the device', () => {
    const program = `
E = audio.SoundEffect
err(E, 10000)
err(E, -1)
err(E, 0, 0, 0, 256)
err(E, waveform=10)
err(E, shape=100)
err(E, 1.5)
err(setattr, E(), 'duration', 10000)
err(audio.play, Sound.HAPPY, pin=pin3)
err(audio.play, Sound.HAPPY, pin=pin_speaker)
err(audio.play, Sound.HAPPY, pin=7)
err(audio.play, 7)
err(audio.play, audio.AudioFrame())
err(audio.play, [7])`;
    expect(linesOf(program)).toEqual([
      'ValueError: maximum value is 9999',
      'ValueError: maximum value is 9999',
      'ValueError: maximum value is 255',
      'ValueError: maximum value is 9',
      'ValueError: maximum value is 99',
      "TypeError: can't convert float to int",
      'ValueError: maximum value is 9999',
      'ValueError: Pin 3 in display mode',
      'ValueError: pin_speaker not allowed',
      'TypeError: expecting a pin',
      "TypeError: 'int' object isn't iterable",
      "TypeError: 'AudioFrame' object isn't iterable",
      'TypeError: not an AudioFrame',
    ]);
  });

  it('stops when told, or when the waiting program is interrupted', () => {
    const run = play(
      'from microbit import *\ntry:\n    audio.play(Sound.TWINKLE)\nexcept KeyboardInterrupt:\n    print(audio.is_playing())\n',
    );
    run.until(300).vm.interrupt();
    expect(run.until(400).printed()).toBe('False\n');
  });

  it('takes pin 0 in audio mode, which any other use may take back', () => {
    const program = `
audio.play(audio.SoundEffect(duration=10))
print(pin0.get_mode())
pin0.write_digital(1)
print(pin0.get_mode())
audio.play(audio.SoundEffect(duration=10), pin=None)
print(pin0.get_mode())
audio.play(audio.SoundEffect(duration=10), pin=pin1, return_pin=None)
print(pin1.get_mode())`;
    expect(linesOf(program)).toEqual(['audio', 'write_digital', 'write_digital', 'audio']);
  });

  it('refuses a return_pin on v2.1.2, where stop() ends samples alone; newer firmwares take it, and stop() ends all', () => {
    const program = `
err(audio.play, Sound.HAPPY, return_pin=pin2)
audio.play(audio.SoundEffect(duration=900), wait=False)
audio.stop()
print(audio.is_playing())`;
    expect(linesOf(program)).toEqual(['ValueError: return_pin not supported', 'True']);
    for (const device of LATER) expect(linesOf(program, {}, undefined, device)).toEqual(['no error: None', 'False']);
  });

  it('is the module microbit.audio too, and the speaker goes on and off', () => {
    const program = `
import audio as a, microbit
print(a is audio, a is microbit.audio)
speaker.off(); speaker.on()
set_volume(100); set_volume(300)
err(set_volume, 'loud')`;
    const lines = linesOf(program, {}, ({ board }) => board.sound.onEvent(() => undefined));
    expect(lines).toEqual(['True True', "TypeError: can't convert str to int"]);
  });
});

/** The sounds of a program, with whole ms. */
function heard(program: string, untilMs: number): readonly SoundEvent[] {
  const events: SoundEvent[] = [];
  play(program, {}, ({ board }) => board.sound.onEvent((event) => events.push(event))).until(untilMs);
  return events;
}

describe('audio: frames', () => {
  it('asks a generator for each frame when the one before begins to sound, every 4.096 ms', () => {
    const program = `${AT_MS}
f = audio.AudioFrame()
times = []
def frames():
    for n in range(5):
        times.append(running_time())
        yield f
print(exact(audio.play, frames()))
print([t - times[0] for t in times])
print(exact(audio.play, [f] * 100), exact(audio.play, [f]))`;
    // Each lasts 32 / 7812 s; the play has ended when the last one has begun and no other comes.
    expect(linesOf(program)).toEqual(['16', '[0, 0, 4, 8, 12]', '405 0']);
  });

  it('tells the samples, one frame after the other without a gap', () => {
    const program = `
from microbit import *
f = audio.AudioFrame()
while running_time() < 20: pass
audio.play([f, f, f])
`;
    const blocks = heard(program, 100).filter((event) => event.type === 'samples');
    expect(blocks.map(({ rate, samples }) => [rate, samples.length, samples[0]])).toEqual([
      [7812, 32, 128],
      [7812, 32, 128],
      [7812, 32, 128],
    ]);
    const [first, second, third] = blocks.map(({ startUs }) => startUs);
    expect([second! - first!, third! - first!].map(Math.round)).toEqual([4096, 8193]);
  });

  it('leaves a gap when a generator is late', () => {
    const program = `
from microbit import *
def slow():
    for n in range(3):
        sleep(10)
        yield audio.AudioFrame()
audio.play(slow())
`;
    const [first, second] = heard(program, 100)
      .filter((event) => event.type === 'samples')
      .map(({ startUs }) => startUs);
    expect(second! - first!).toBeGreaterThan(10_000);
  });

  it('goes on in the background, until the program stops it or the frames end', () => {
    const program = `
def endless():
    f = audio.AudioFrame()
    while True: yield f
audio.play(endless(), wait=False)
sleep(50)
print(audio.is_playing())
audio.stop()
print(audio.is_playing())
audio.play([audio.AudioFrame()] * 5, wait=False)
sleep(15)
print(audio.is_playing())
sleep(5)
print(audio.is_playing())`;
    expect(linesOf(program)).toEqual(['True', 'False', 'True', 'False']);
  });

  it('raises what a generator raises, in the main program', () => {
    const program = `
def bad():
    yield audio.AudioFrame()
    yield audio.AudioFrame()
    1/0
def wrong():
    yield audio.AudioFrame()
    yield audio.AudioFrame()
    yield 5
err(audio.play, bad())
err(audio.play, wrong())
print(audio.is_playing())`;
    expect(linesOf(program)).toEqual(['ZeroDivisionError: divide by zero', 'TypeError: not an AudioFrame', 'False']);
  });

  it('counts, adds, subtracts and multiplies like the device', () => {
    const program = `
F = audio.AudioFrame
a = F(); b = F()
print(len(a), a[0])
a[0] = 200; b[0] = 100; a[1] = 255; b[1] = 255; a[2] = 0; b[2] = 0
c = a + b; d = a - b; e = a * 0.5; f = a * -2
print(list(c[i] for i in range(3)), [d[i] for i in range(3)], [e[i] for i in range(3)], [f[i] for i in range(3)])
a += b; b -= b; e *= 2
print(a[0], b[0], e[0])
b.copyfrom(a)
b.copyfrom(bytes((1, 2, 3)))
print(b[0], b[2], b[3], bytes(b)[:3], b)
err(lambda: a[32])
err(lambda: a[-1])
err(a.__setitem__, 0, 256)
err(a.__delitem__, 0)
err(lambda: a * 'x')
err(F, 100)
err(lambda: a + 5)`;
    const lines = linesOf(program);
    expect(lines.slice(0, 9)).toEqual([
      '32 128',
      '[172, 255, 0] [228, 128, 128] [164, 191, 64] [0, 0, 255]',
      '172 128 200',
      "1 3 128 b'\\x01\\x02\\x03' <AudioFrame>",
      'ValueError: index out of bounds',
      'ValueError: index out of bounds',
      'ValueError: value out of range',
      'TypeError: cannot delete elements of AudioFrame',
      "TypeError: can't convert str to float",
    ]);
    expect(lines[9]).toMatch(/^TypeError: function takes /);
    expect(lines[10]).toMatch(/^TypeError: unsupported types for __add__: 'AudioFrame', 'int'/);
  });
});

describe('audio: recordings, with the newest firmware', () => {
  const firmware = microbitV2.firmwares.find(({ features }) => features.includes('recording'));
  const newest = (program: string): string[] => linesOf(program, {}, () => undefined, { firmware });

  it('plays frames of any length at any rate', () => {
    const program = `${AT_MS}
f = audio.AudioFrame(duration=1000, rate=3200)
print(len(f), f.get_rate(), exact(audio.play, f))
f.set_rate(6400)
print(exact(audio.play, f))
audio.play(f, wait=False)
print(audio.sound_level(), audio.is_playing())
f[0] = 255
audio.play(f, wait=False)
print(audio.sound_level())
err(audio.AudioFrame, -1)
err(audio.AudioFrame, 10, 0)`;
    expect(newest(program)).toEqual([
      '3200 3200 990',
      '495',
      '0 True',
      '44',
      'ValueError: size out of bounds',
      'ValueError: rate out of bounds',
    ]);
  });

  it('makes recordings of a duration and tracks that are parts of them', () => {
    const program = `${AT_MS}
r = audio.AudioRecording(1000)
t = r.track(start_ms=100, end_ms=300)
print(r.get_rate(), len(t), t.get_rate(), exact(audio.play, r), exact(audio.play, t))
t[0] = 7
u = t[:100]
print(len(u), u[0], r.track()[1100], r.copy().track()[1100])
t *= 0
t += t
print(u[0], t[-1])
b = bytearray(10)
audio.AudioTrack(b, 4000)[3] = 9
print(b[3])
err(audio.AudioRecording, 0)
err(audio.AudioTrack, 5)
err(t.__setitem__, 0, 256)`;
    const lines = newest(program);
    expect(lines.slice(0, 4)).toEqual(['11000 2200 11000 997 197', '100 7 7 7', '128 128', '9']);
    expect(lines[4]).toBe('ValueError: duration out of bounds');
    expect(lines[5]).toMatch(/^TypeError: /);
    expect(lines[6]).toBe('ValueError: value out of range');
  });

  it('has no such names in firmware v2.1.2', () => {
    const program = `
print([n for n in sorted(dir(audio)) if n[0] != '_'])
err(lambda: audio.AudioFrame().get_rate())`;
    expect(linesOf(program)).toEqual([
      "['AudioFrame', 'SoundEffect', 'is_playing', 'play', 'stop']",
      "AttributeError: 'AudioFrame' object has no attribute 'get_rate'",
    ]);
  });
});
